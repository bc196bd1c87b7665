// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/moteus/codec.h"
#include "core/sim_bus/simulated_link.h"
#include "tests/fakes/manual_clock.h"
#include "tests/fakes/text_of.h"

#include <QObject>

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

// The simulated pair of drives behind its link, queried and commanded frame by frame. The clock is turned by hand.
namespace boresight {

inline CanFrame encoded(const moteus::Request& request)
{
    const Result<CanFrame> frame = moteus::encode(request);
    EXPECT_TRUE(frame) << (frame ? "" : textOf(frame.error()));
    return frame.value_or(CanFrame{});
}

inline moteus::PositionCommand moveTo(double turns, double velocity = 0.0)
{
    return {.position = turns,
            .velocity = velocity,
            .watchdogTimeout = 0.1,
            .velocityLimit = 0.03,
            .accelerationLimit = 0.1};
}

class SimulatedLinkTest : public testing::Test
{
protected:
    SimulatedLinkTest()
    {
        EXPECT_TRUE(link.open());
        QObject::connect(&link, &CanLink::frameReceived, [this](const CanFrame& frame) { received.push_back(frame); });
    }

    // One exchange with one drive. Empty if the drive stays silent.
    std::optional<moteus::Reply> ask(std::uint8_t id, std::optional<moteus::Command> command = std::nullopt)
    {
        received.clear();
        const CanFrame frame =
            encoded({.destination = id, .command = std::move(command), .query = moteus::rotatorQuery()});
        EXPECT_TRUE(link.send(std::span(&frame, 1)));
        link.deliver();
        if (received.empty()) {
            return std::nullopt;
        }
        const Result<moteus::Reply> reply = moteus::decodeReply(received.front());
        return reply ? std::optional(*reply) : std::nullopt;
    }
    double ask(std::uint8_t id, moteus::Register reg)
    {
        const CanFrame frame = encoded({.destination = id, .query = {{reg, moteus::Resolution::Int32}}});
        received.clear();
        EXPECT_TRUE(link.send(std::span(&frame, 1)));
        link.deliver();
        return received.empty() ? NAN : moteus::decodeReply(received.front())->value(reg).value_or(NAN);
    }
    // Repeats a command at 50 Hz.
    void drive(double seconds, std::uint8_t id, const moteus::Command& command)
    {
        for (int i = 0; i < static_cast<int>(seconds * 50.0); ++i) {
            ask(id, command);
            clock.advance(Seconds(0.02));
        }
    }
    sim::FaultSchedule::Handle inject(sim::FaultKind kind, std::optional<double> value = std::nullopt,
                                      std::optional<Axis> axis = Axis::Azimuth)
    {
        return link.inject({.kind = kind, .axis = axis, .value = value});
    }

    fakes::ManualClock clock;
    SimulatedLink link{clock};
    std::vector<CanFrame> received;
};

}  // namespace boresight
