// SPDX-License-Identifier: GPL-3.0-or-later
// Faults on request: of the line, the drives, the supply and the axes.
#include "tests/core/sim/simulated_link_rig.h"

namespace boresight {
namespace {

using moteus::Mode;
using moteus::Register;
using sim::FaultKind;

// REQ-SIM-10 (SimulatedLinkTest.*): Each fault can be requested, at a time, for a duration, or switched on and off.
TEST_F(SimulatedLinkTest, SilenceIsSilentButTheDriveActs)
{
    const auto handle = inject(FaultKind::Silence);
    EXPECT_FALSE(ask(1, moteus::Brake{}));
    EXPECT_TRUE(ask(2));
    clock.advance(Seconds(0.1));
    EXPECT_EQ(link.truth(Axis::Azimuth).mode, Mode::Brake);
    link.pair().faults().remove(handle);
    EXPECT_TRUE(ask(1));
}

TEST_F(SimulatedLinkTest, SilenceEndsByItself)
{
    link.inject({.kind = FaultKind::Silence, .duration = Seconds(3.0)});
    clock.advance(Seconds(2.9));
    EXPECT_FALSE(ask(1));
    clock.advance(Seconds(0.2));
    EXPECT_TRUE(ask(1));
}

TEST_F(SimulatedLinkTest, LateReplyArrivesLateAndIsStampedThen)
{
    inject(FaultKind::LateReply, 0.5);
    EXPECT_FALSE(ask(1));
    clock.advance(Seconds(0.49));
    link.deliver();
    EXPECT_TRUE(received.empty());
    clock.advance(Seconds(0.02));
    link.deliver();
    ASSERT_EQ(received.size(), 1u);
    EXPECT_EQ(received.front().received, clock.now());
}

TEST_F(SimulatedLinkTest, LostRepliesFollowTheirProbability)
{
    inject(FaultKind::LostReply, 0.3);
    int answered = 0;
    for (int i = 0; i < 1000; ++i) {
        answered += ask(1) ? 1 : 0;
    }
    EXPECT_NEAR(answered, 700, 50);
}

TEST_F(SimulatedLinkTest, CutCableMeansTheDriveHearsNothing)
{
    inject(FaultKind::LostCommand, 1.0);
    EXPECT_FALSE(ask(1, moteus::Brake{}));
    clock.advance(Seconds(0.1));
    EXPECT_EQ(link.truth(Axis::Azimuth).mode, Mode::Stopped);
}

TEST_F(SimulatedLinkTest, CorruptFramesAreCounted)
{
    inject(FaultKind::CorruptLine, 1.0);
    EXPECT_FALSE(ask(1));
    EXPECT_EQ(link.status().dropped, 1u);
}

TEST_F(SimulatedLinkTest, DuplicateIdDestroysBothReplies)
{
    inject(FaultKind::DuplicateId, std::nullopt, Axis::Elevation);
    EXPECT_FALSE(ask(1));
    EXPECT_FALSE(ask(2));
}

TEST_F(SimulatedLinkTest, DriveFaultComesAtOnceAndReturnsOnEnabling)
{
    const auto handle = inject(FaultKind::DriveFault, 33.0);
    clock.advance(Seconds(0.01));
    EXPECT_EQ(ask(1)->fault(), 33);
    ask(1, moteus::Stop{});
    clock.advance(Seconds(0.01));
    EXPECT_EQ(ask(1)->mode(), Mode::Stopped);
    ask(1, moveTo(0.0));
    clock.advance(Seconds(0.01));
    EXPECT_EQ(ask(1)->mode(), Mode::Fault);
    link.pair().faults().remove(handle);
    ask(1, moteus::Stop{});
    clock.advance(Seconds(0.01));
    ask(1, moveTo(0.0));
    clock.advance(Seconds(0.05));
    EXPECT_EQ(ask(1)->mode(), Mode::Position);
}

// Story: an injected limit put the drive into fault mode. A real drive works on and reports the limit that is active.
TEST_F(SimulatedLinkTest, ALimitIsToldWhileTheDriveWorksOn)
{
    inject(FaultKind::DriveFault, 100.0);
    clock.advance(Seconds(0.01));
    EXPECT_EQ(ask(1)->mode(), Mode::Stopped);
    EXPECT_EQ(ask(1)->fault(), 0) << "a drive that is off is held back by nothing";
    drive(1.0, 1, moveTo(0.01));
    const auto reply = ask(1);
    EXPECT_EQ(reply->mode(), Mode::Position);
    EXPECT_EQ(reply->fault(), 100);
    EXPECT_NEAR(*reply->value(Register::Position), 0.01, 1e-3);
}

// REQ-SIM-09: After power-up the home state is 1 and the position is within half a turn of the rotor. With an output
// encoder only the direction is known.
TEST_F(SimulatedLinkTest, PowerCycleForgetsTheTurn)
{
    drive(4.0, 1, moveTo(0.3));
    link.inject({.kind = FaultKind::PowerLoss, .axis = Axis::Azimuth, .duration = Seconds(2.0), .value = 200.0});
    clock.advance(Seconds(1.0));
    EXPECT_FALSE(ask(1));
    EXPECT_FALSE(ask(2)) << "one supply for both";
    clock.advance(Seconds(1.5));
    const auto reply = ask(1);
    ASSERT_TRUE(reply);
    EXPECT_EQ(reply->mode(), Mode::Stopped);
    EXPECT_EQ(reply->homeState(), moteus::HomeState::Rotor);
    EXPECT_LE(std::abs(*reply->value(Register::Position)), 0.5 / 100.0 + 2e-5) << "within half a rotor turn";
    EXPECT_NEAR(link.truth(Axis::Azimuth).angle.degrees(), 200.0, 0.02);
    // After an approximate position was set, the drive knows the exact position again.
    ask(1, moteus::SetOutputNearest{200.5 / 360.0});
    EXPECT_EQ(ask(1)->homeState(), moteus::HomeState::Output);
    EXPECT_NEAR(*ask(1)->value(Register::Position) * 360.0, 200.0, 0.02);
}

// REQ-SIM-09
TEST_F(SimulatedLinkTest, OutputEncoderKnowsTheDirectionButNotTheTurn)
{
    sim::PairSettings settings = sim::commissionedPair({.azimuth = 405.0_deg, .elevation = 50.0_deg});
    settings.azimuth.config.motorPosition.referenceSource = 1;
    SimulatedLink other(clock, settings);
    other.inject({.kind = FaultKind::PowerLoss, .duration = Seconds(1.0)});
    clock.advance(Seconds(2.0));
    sim::SimulatedMoteus& drive = other.pair().drive(Axis::Azimuth);
    EXPECT_NEAR(drive.reportedPosition() * 360.0, 45.0, 0.05);
    EXPECT_NEAR(other.truth(Axis::Azimuth).angle.degrees(), 405.0, 0.05);
}

TEST_F(SimulatedLinkTest, WindPushesAndTheDriveLeansAgainstIt)
{
    drive(1.0, 1, moveTo(0.0));
    link.inject({.kind = FaultKind::Wind, .axis = Axis::Azimuth, .duration = Seconds(2.0), .value = 40.0});
    drive(1.9, 1, moveTo(0.0));
    EXPECT_NEAR(link.truth(Axis::Azimuth).torque, -40.0, 5.0);
    EXPECT_NEAR(link.truth(Axis::Azimuth).angle.degrees(), 0.0, 0.05);
    drive(2.0, 1, moveTo(0.0));
    EXPECT_NEAR(link.truth(Axis::Azimuth).torque, 0.0, 6.0);
}

TEST_F(SimulatedLinkTest, StallShowsAsTorque)
{
    drive(0.5, 1, moveTo(0.0));
    inject(FaultKind::Stall);
    drive(3.0, 1, moveTo(0.02));
    EXPECT_NEAR(link.truth(Axis::Azimuth).angle.degrees(), 0.0, 0.1);
    EXPECT_EQ(ask(1)->fault(), static_cast<int>(sim::ActiveLimit::MaxCurrent));
}

// The integrator of the drive keeps its value: a command to stay where the axis is does not clear it.
// REQ-SIM-10b: The integrator of the drive keeps pushing a stalled axis when the drive is commanded to stay where the
// axis is.
TEST_F(SimulatedLinkTest, AStalledAxisIsPushedOnWhenItIsOrderedToStayWhereItIs)
{
    drive(0.5, 1, moveTo(0.0));
    const auto stall = inject(FaultKind::Stall);
    drive(3.0, 1, moveTo(0.02));
    const double here = *ask(1)->value(Register::Position);
    drive(0.3, 1, moveTo(here));
    EXPECT_GT(link.truth(Axis::Azimuth).torque, 40.0);
    link.pair().faults().remove(stall);
    drive(5.0, 1, moveTo(here));
    EXPECT_NEAR(link.truth(Axis::Azimuth).torque, 0.0, 6.0) << "it goes only by moving";
}

TEST_F(SimulatedLinkTest, JamStopsTheAxisWhereItIs)
{
    inject(FaultKind::Jam, 30.0);
    drive(4.0, 1, moveTo(0.2));
    EXPECT_NEAR(link.truth(Axis::Azimuth).angle.degrees(), 30.0, 0.1);
}

TEST_F(SimulatedLinkTest, SupplyOutOfRangeFaultsAnActiveDrive)
{
    drive(0.5, 1, moveTo(0.0));
    const auto handle = inject(FaultKind::SupplyVoltage, 47.0);
    drive(0.1, 1, moveTo(0.0));
    EXPECT_EQ(ask(1)->fault(), 34);
    EXPECT_EQ(link.truth(Axis::Elevation).mode, Mode::Stopped) << "a stopped board does not check";
    link.pair().faults().remove(handle);
}

TEST_F(SimulatedLinkTest, OtherRegisterMapVersion)
{
    EXPECT_EQ(ask(1, Register::RegisterMapVersion), 5.0);
    inject(FaultKind::RegisterMap, 4.0);
    clock.advance(Seconds(0.01));
    EXPECT_EQ(ask(1, Register::RegisterMapVersion), 4.0);
    EXPECT_EQ(ask(2, Register::RegisterMapVersion), 5.0);
}

TEST_F(SimulatedLinkTest, BusOffRefusesFramesAndRecovers)
{
    const auto handle = inject(FaultKind::BusOff);
    const CanFrame frame = encoded({.destination = 1, .query = moteus::basicQuery()});
    EXPECT_FALSE(link.send(std::span(&frame, 1)));
    EXPECT_EQ(link.status().state, LinkState::Down);
    link.pair().faults().remove(handle);
    EXPECT_TRUE(ask(1));
    EXPECT_EQ(link.status().state, LinkState::Up);
}

TEST_F(SimulatedLinkTest, AdapterThatRefusesSendsNothingAndSaysSo)
{
    const auto handle = inject(FaultKind::AdapterError);
    EXPECT_FALSE(ask(1));
    EXPECT_EQ(link.status().state, LinkState::Up);
    EXPECT_EQ(link.status().busErrors, 1U);
    EXPECT_EQ(link.status().text, QStringLiteral("simulated: the adapter refuses every frame (injected)"));
    link.pair().faults().remove(handle);
    EXPECT_TRUE(ask(1));
    EXPECT_EQ(link.status().text, QString());
}

TEST_F(SimulatedLinkTest, AdapterThatAcknowledgesNothingStillSends)
{
    inject(FaultKind::MissingOk);
    EXPECT_TRUE(ask(1));
    EXPECT_EQ(link.status().busErrors, 1U);
    EXPECT_EQ(link.status().text, QStringLiteral("simulated: the adapter acknowledges nothing (injected)"));
}

}  // namespace
}  // namespace boresight
