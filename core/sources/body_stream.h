// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/control/motion_source.h"

// The operator's own stream: Sun or Moon, whose direction arrives point by point. Limits and trim hold for it as for
// the stream of a client. Station thread only.
namespace boresight::sources {

class BodyStream : public SourceOf<BodyStream, request::Follow>
{
public:
    using SourceOf::SourceOf;

    Result<> ask(const request::Follow& wanted, const Source& by);
};

}  // namespace boresight::sources
