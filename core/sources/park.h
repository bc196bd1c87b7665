// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/control/motion_source.h"

// Sends the mount to the park position of the profile. Station thread only.
namespace boresight::sources {

class Park : public SourceOf<Park, request::Park>
{
public:
    using SourceOf::SourceOf;

    Result<> ask(const request::Park& wanted, const Source& by);
};

}  // namespace boresight::sources
