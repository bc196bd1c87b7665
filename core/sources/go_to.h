// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/control/motion_source.h"

// The operator sends the mount to a direction, to angles of the axes, or one axis alone. Station thread only.
namespace boresight::sources {

class GoTo : public SourceOf<GoTo, request::PointSky, request::PointAxes, request::PointAxis>
{
public:
    using SourceOf::SourceOf;

    Result<> ask(const request::PointSky& wanted, const Source& by);
    Result<> ask(const request::PointAxes& wanted, const Source& by);
    Result<> ask(const request::PointAxis& wanted, const Source& by);

protected:
    [[nodiscard]] bool serves(const Request& /*request*/, const Source& by) const override
    {
        return by.kind != SourceKind::Client;
    }
};

}  // namespace boresight::sources
