// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/control/motion_source.h"

// Moves the mount by a fixed amount, by hand. While the mount follows a stream, a nudge by the operator changes the
// trim of the stream instead. Station thread only.
namespace boresight::sources {

class Step : public SourceOf<Step, request::Step, request::Nudge>
{
public:
    using SourceOf::SourceOf;

    Result<> ask(const request::Step& wanted, const Source& by);
    Result<> ask(const request::Nudge& wanted, const Source& by);
};

}  // namespace boresight::sources
