// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus/codec.h"
#include "core/sim/reference_mount.h"
#include "core/sim/reply_edit.h"
#include "core/sim/simulated_pair.h"

#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <numeric>
#include <string>

// Replies with wrong content, from another sender, twice, or too late, as they arrive.
namespace boresight::sim {
namespace {

using moteus::Register;
using testing::ElementsAre;

constexpr Seconds kTick{0.02};

class SpoiledReplies : public testing::Test
{
protected:
    void inject(FaultKind kind, std::optional<double> value = std::nullopt, Axis axis = Axis::Azimuth)
    {
        pair.faults().add({.kind = kind, .axis = axis, .value = value});
    }
    // Sends a query a tick later and returns the replies that arrive.
    std::vector<moteus::Reply> ask(std::uint8_t id)
    {
        now += kTick;
        std::vector<moteus::Reply> replies;
        for (const PairReply& reply : pair.exchange(question(id), now)) {
            replies.push_back(moteus::decodeReply(reply.frame).value());
        }
        return replies;
    }
    moteus::Reply askOne(std::uint8_t id)
    {
        const auto replies = ask(id);
        EXPECT_EQ(replies.size(), 1U);
        return replies.at(0);
    }
    static CanFrame question(std::uint8_t id)
    {
        return moteus::encode({.destination = id, .query = moteus::rotatorQuery()}).value();
    }
    static double degrees(const moteus::Reply& reply, Axis axis)
    {
        return referenceAxis(axis).toAngle(reply.value(Register::Position).value_or(NAN)).degrees();
    }

    SimulatedPair pair{commissionedPair({.azimuth = 100.0_deg, .elevation = 30.0_deg})};
    Seconds now{0.0};
};

// REQ-SIM-10a (SpoiledReplies.*): Replies come with a false, unset, infinite or missing position, without voltage or
// temperatures, under another id, exchanged, doubled, or stale. A part of the replies is changed at random, determined
// by the seed alone. An encoder slips.
TEST_F(SpoiledReplies, AFalsePositionIsInTheReplyOnly)
{
    inject(FaultKind::FalsePosition, 90.0);
    inject(FaultKind::FalsePosition, -60.0, Axis::Elevation);
    EXPECT_NEAR(degrees(askOne(1), Axis::Azimuth), 190.0, 0.05);
    EXPECT_NEAR(degrees(askOne(2), Axis::Elevation), -30.0, 0.05);
    EXPECT_NEAR(pair.drive(Axis::Azimuth).reportedPosition() * 360.0, 100.0, 0.05) << "the drive knows better";
    EXPECT_NEAR(pair.truth(Axis::Azimuth).angle.degrees(), 100.0, 0.02);
}

TEST_F(SpoiledReplies, APositionIsNaNInfiniteOrMissing)
{
    const auto bits = [this](FaultKind kind) {
        pair.faults().clear();
        inject(kind);
        now += kTick;
        return valueIn(pair.exchange(question(1), now).at(0).frame, Register::Position);
    };
    EXPECT_TRUE(std::isnan(bits(FaultKind::PositionNaN).value()));
    EXPECT_TRUE(std::isinf(bits(FaultKind::PositionInfinite).value()));
    EXPECT_FALSE(bits(FaultKind::PositionMissing));
    const moteus::Reply missing = askOne(1);
    EXPECT_EQ(missing.mode(), moteus::Mode::Stopped);
    EXPECT_EQ(missing.values.size(), 1U);
    EXPECT_EQ(missing.end, moteus::ParseEnd::Complete);
}

TEST_F(SpoiledReplies, VoltageAndTemperaturesAreNaN)
{
    inject(FaultKind::SupplyNaN);
    EXPECT_FALSE(askOne(1).value(Register::Voltage));
    EXPECT_TRUE(askOne(1).value(Register::Temperature));
    inject(FaultKind::TemperatureNaN);
    const moteus::Reply reply = askOne(1);
    EXPECT_FALSE(reply.value(Register::Temperature));
    EXPECT_FALSE(reply.value(Register::MotorTemperature));
    EXPECT_NEAR(degrees(reply, Axis::Azimuth), 100.0, 0.05);
}

TEST_F(SpoiledReplies, OneCarriesAnotherId)
{
    inject(FaultKind::ForeignId, 7.0);
    EXPECT_EQ(askOne(1).source, 7);
    EXPECT_EQ(askOne(2).source, 2);
}

TEST_F(SpoiledReplies, BothAreExchanged)
{
    pair.faults().add({.kind = FaultKind::ExchangedReplies});
    const moteus::Reply ofAzimuth = askOne(1);
    EXPECT_EQ(ofAzimuth.source, 2);
    EXPECT_NEAR(degrees(ofAzimuth, Axis::Azimuth), 100.0, 0.05);
    EXPECT_EQ(askOne(2).source, 1);
}

TEST_F(SpoiledReplies, EachComesTwice)
{
    inject(FaultKind::DoubledReply);
    const auto replies = ask(1);
    ASSERT_EQ(replies.size(), 2U);
    EXPECT_EQ(replies[0].value(Register::Position), replies[1].value(Register::Position));
    EXPECT_EQ(ask(2).size(), 1U);
}

TEST_F(SpoiledReplies, AStaleOneSaysWhatWasTrueThen)
{
    const auto move = moteus::encode(
        {.destination = 1,
         .command = moteus::PositionCommand{.position = 1.0, .watchdogTimeout = 9.0, .velocityLimit = 10.0 / 360.0},
         .replyWanted = false});
    static_cast<void>(pair.exchange(move.value(), now));
    std::vector<double> told;
    for (int i = 0; i < 100; ++i) {
        told.push_back(degrees(askOne(1), Axis::Azimuth));
    }
    ASSERT_GT(told.back() - told[49], 5.0);
    inject(FaultKind::StaleReply, 1.0);
    EXPECT_EQ(degrees(askOne(1), Axis::Azimuth), told[50]);
    EXPECT_EQ(degrees(askOne(1), Axis::Azimuth), told[51]);
}

TEST_F(SpoiledReplies, AShareIsEditedInEveryWay)
{
    inject(FaultKind::EditedReply, 0.1);
    std::map<std::string, int> seen;
    constexpr int kQuestions = 20000;
    for (int i = 0; i < kQuestions; ++i) {
        now += Seconds(0.001);
        const auto replies = pair.exchange(question(1), now);
        const CanFrame& frame = replies.at(0).frame;
        const auto position = valueIn(frame, Register::Position);
        const auto source = moteus::decodeReply(frame).value().source;
        ++seen[replies.size() == 2                                  ? "doubled"
               : source == 2                                        ? "exchanged"
               : source != 1                                        ? "foreign"
               : !position                                          ? "missing"
               : std::isnan(*position)                              ? "NaN"
               : std::isinf(*position)                              ? "infinite"
               : std::isnan(*valueIn(frame, Register::Voltage))     ? "supply"
               : std::isnan(*valueIn(frame, Register::Temperature)) ? "temperature"
               : std::abs(*position * 360.0 - 100.0) > 0.009        ? "false"
                                                                    : "as it was"];
    }
    const int asItWas = seen["as it was"] - kQuestions / 100;  // the stale replies of an axis that stands still
    EXPECT_NEAR(asItWas, 0.9 * kQuestions, 200);
    for (const auto& [kind, count] : seen) {
        EXPECT_GT(count, 130) << kind;
    }
    EXPECT_EQ(seen.size(), 10U);
}

TEST_F(SpoiledReplies, TheSameSeedEditsTheSame)
{
    const auto run = [](std::uint32_t seed) {
        PairSettings settings = commissionedPair();
        settings.seed = seed;
        SimulatedPair mount(settings);
        mount.faults().add({.kind = FaultKind::EditedReply, .value = 0.5});
        std::vector<std::uint32_t> ids;
        for (int i = 1; i < 200; ++i) {
            for (const PairReply& reply : mount.exchange(question(1), kTick * i)) {
                ids.push_back(reply.frame.id);
            }
        }
        return ids;
    };
    EXPECT_EQ(run(1), run(1));
    EXPECT_NE(run(1), run(2));
}

TEST_F(SpoiledReplies, ASlipOfTheEncoderStaysAndIsDrivenBack)
{
    const CanFrame hold = moteus::encode({.destination = 1,
                                          .command = moteus::PositionCommand{.position = 100.0 / 360.0,
                                                                             .maximumTorque = 50.0,
                                                                             .watchdogTimeout = 99.0},
                                          .replyWanted = false})
                              .value();
    static_cast<void>(pair.exchange(hold, now));
    now = Seconds(1.0);
    pair.faults().add({.kind = FaultKind::EncoderSlip,
                       .axis = Axis::Azimuth,
                       .at = Seconds(1.0),
                       .duration = Seconds(0.1),
                       .value = 2.0});
    pair.advanceTo(Seconds(1.002));
    EXPECT_NEAR(pair.drive(Axis::Azimuth).reportedPosition() * 360.0, 102.0, 0.1);
    EXPECT_NEAR(pair.truth(Axis::Azimuth).angle.degrees(), 100.0, 0.1);
    pair.advanceTo(Seconds(4.0));
    EXPECT_NEAR(pair.drive(Axis::Azimuth).reportedPosition() * 360.0, 100.0, 0.05) << "the drive holds what it counts";
    EXPECT_NEAR(pair.truth(Axis::Azimuth).angle.degrees(), 98.0, 0.1);
}

}  // namespace
}  // namespace boresight::sim
