// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/control/motion_source.h"

// A client sends one target after the other. After the client has disconnected, the mount settles at the last target.
// Station thread only.
namespace boresight::sources {

class ClientStream : public SourceOf<ClientStream, request::PointSky, request::PointAxes>
{
public:
    using SourceOf::SourceOf;

    Result<> ask(const request::PointSky& wanted, const Source& by);
    Result<> ask(const request::PointAxes& wanted, const Source& by);
    void gone(const Source& client) override;
    void positionRead(std::uint64_t clientId) override;

protected:
    [[nodiscard]] bool serves(const Source& by) const override { return by.kind == SourceKind::Client; }
};

}  // namespace boresight::sources
