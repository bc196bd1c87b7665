// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/rotctld/line_protocol.h"
#include "core/rotctld/rotator.h"

#include <optional>

// The position of an axis that a command of a client does not contain. A real controller has a set-point for each axis,
// and one set-point stays when the other is sent. So the last target of the client is kept while the mount follows it.
// After somebody has moved or stopped the mount, the axis stays where it is measured. Station thread.
namespace boresight::rotctld {

class HeldTarget
{
public:
    // The rotator outlives this.
    explicit HeldTarget(Rotator& rotator) : m_rotator(rotator) {}

    [[nodiscard]] Result<SkyPointing> place(const Client& client);
    // The target with these angles of the client. An azimuth outside the limits is moved by 360° if that brings it
    // inside. An axis without an angle keeps its position.
    [[nodiscard]] Result<SkyPointing> completed(const Client& client, std::optional<Angle> azimuth,
                                                std::optional<Angle> elevation);
    // Points there, and keeps the place if the rotator accepts it. Fills in the outcome, except its result.
    Result<> pointTo(const Client& client, const Result<SkyPointing>& place, LineOutcome& outcome);
    // A client has commanded something else.
    void forget() { m_sent.reset(); }

private:
    struct Sent
    {
        Client client;
        SkyPointing place;
    };

    Rotator& m_rotator;
    std::optional<Sent> m_sent;
};

}  // namespace boresight::rotctld
