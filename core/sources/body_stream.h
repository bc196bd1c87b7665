// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/control/motion_source.h"

// Follows the Sun or the Moon for a calibration. The direction arrives point by point. Limits and trim apply to this
// stream as they do to the stream of a client. Station thread only.
namespace boresight::sources {

class BodyStream : public SourceOf<BodyStream, request::Follow>
{
public:
    using SourceOf::SourceOf;

    Result<> ask(const request::Follow& wanted, const Source& by);
};

}  // namespace boresight::sources
