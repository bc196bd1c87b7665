// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus/faults.h"
#include "tests/system/simulated_station.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

// Faults at the mast, with a client that keeps asking for motion. The antenna stops. The operator reads what happened,
// what Boresight did and what to do. Nothing moves by itself afterwards. Judged by the true position of the antenna.
// The clock is turned by hand.
namespace boresight::system_test {
namespace {

constexpr Angle kStill = Angle::fromDegrees(0.03);  // backlash: the drive settles on the other side of it

const char* const kFar = "P 200 60\n";
const char* const kFarther = "P 230 40\n";

// A mount that is moving, and its client.
class FaultTest : public ::testing::Test
{
protected:
    FaultTest() : client(rig.connect())
    {
        EXPECT_EQ(client->ask(kFar), "RPRT 0\n");
        rig.run(Seconds(3.0));
        EXPECT_GT(abs(rig.link->truth(Axis::Azimuth).rate), 5_deg_s);
    }

    // The client keeps asking as Gpredict would. The antenna must stay where it is.
    void expectNothingMovesFor(Seconds time, const std::string& answer)
    {
        const AxisPosition here = rig.truth();
        Angle worst;
        for (Seconds passed{0.0}; passed < time; passed += Seconds(0.8)) {
            EXPECT_EQ(client->ask(kFarther), answer);
            rig.run(Seconds(0.8));
            worst = std::max(worst, rig.farthestFrom(here));
        }
        EXPECT_LT(worst, kStill);
    }
    void expectMotionAgain()
    {
        EXPECT_EQ(client->ask(kFarther), "RPRT 0\n");
        EXPECT_TRUE(rig.settle());
        EXPECT_LT(rig.farthestFrom({.azimuth = (230_deg).nearestTo(rig.truth().azimuth), .elevation = 40_deg}),
                  0.1_deg);
    }
    sim::FaultSchedule::Handle inject(sim::FaultKind kind, std::optional<Axis> axis, std::optional<double> value = {})
    {
        return rig.link->inject({.kind = kind, .axis = axis, .value = value});
    }
    void end(sim::FaultSchedule::Handle handle) { rig.link->pair().faults().remove(handle); }

    SimulatedStation rig;
    std::unique_ptr<fakes::TcpPeer> client;
};

TEST_F(FaultTest, ASilentBusStopsTheMountAndNothingMovesWhenItIsBack)
{
    const auto cut = inject(sim::FaultKind::LostCommand, {}, 1.0);
    rig.run(Seconds(0.2));  // the watchdog time of 0.1 s and the drive's own ramp
    const AxisPosition stopped = rig.truth();
    rig.run(Seconds(0.2));
    EXPECT_TRUE(rig.alarmSays(QStringLiteral("Neither drive replies")));
    EXPECT_FALSE(rig.alarmSays(QStringLiteral("The azimuth drive does not reply")));
    rig.run(Seconds(0.5));
    EXPECT_EQ(client->ask("p\n", 2).substr(0, 4) == "RPRT", false) << "0.9 s old is still a position";
    rig.run(Seconds(0.2));
    EXPECT_EQ(client->ask("p\n"), "RPRT -6\n");
    EXPECT_EQ(client->ask(kFarther), "RPRT -6\n");
    rig.run(Seconds(1.9));
    EXPECT_LT(rig.farthestFrom(stopped), 0.1_deg);

    end(cut);
    EXPECT_TRUE(rig.runUntil([this] { return rig.ready(); }, Seconds(5.0))) << "the drives are checked again";
    EXPECT_EQ(client->ask("p\n", 2).find("RPRT"), std::string::npos) << "the connection has outlived the silence";
    expectNothingMovesFor(Seconds(10.0), "RPRT -9\n");
    EXPECT_EQ(rig.status().state, StationState::Fault);
    EXPECT_EQ(client->ask("R 1\n"), "RPRT 0\n");
    rig.run(Seconds(0.5));
    EXPECT_EQ(rig.status().state, StationState::Standby);
    EXPECT_LT(rig.farthestFrom(stopped), 0.1_deg) << "re-arming moves nothing";
    expectMotionAgain();
}

TEST_F(FaultTest, ADriveThatTimedOutHoldsAndIsReArmedByTheOperator)
{
    const auto deaf = inject(sim::FaultKind::LostCommand, Axis::Elevation, 1.0);
    rig.run(Seconds(0.16));  // shorter than a silence: the drive comes back in its time-out mode
    end(deaf);
    rig.run(Seconds(2.0));
    EXPECT_TRUE(rig.alarmSays(QStringLiteral("elevation drive timed out")));
    expectNothingMovesFor(Seconds(5.0), "RPRT -9\n");
    EXPECT_EQ(rig.link->truth(Axis::Azimuth).mode, moteus::Mode::Position) << "the healthy axis is held";
    EXPECT_EQ(rig.ask(request::Rearm{}), "");
    rig.run(Seconds(0.5));
    EXPECT_EQ(client->ask(kFarther), "RPRT -9\n") << "the operator has re-armed: the clients wait";
    EXPECT_EQ(rig.ask(request::GiveAuthority{}), "");
    expectMotionAgain();
}

// Story: re-arming left the drive in mode 0, and an elevation axis with too light a counterweight fell to its stop. The
// drive still needs 13 ms to enable.
TEST(UnbalancedElevation, DoesNotFallWhenItIsReArmed)
{
    sim::PairSettings pair = sim::commissionedPair({.azimuth = 0_deg, .elevation = 0_deg});
    pair.elevation.plant.gravityTorque = 15.0;  // twice what friction can hold
    // it rests on a stop 1° below its travel until the program starts
    pair.elevation.plant.stopMax = -0.25 + 1.0 / 360.0;
    SimulatedStation rig(anyPort(), pair);
    const auto client = rig.connect();
    ASSERT_EQ(client->ask("P 10 45\n"), "RPRT 0\n");
    ASSERT_TRUE(rig.settle());
    const auto cut = rig.link->inject({.kind = sim::FaultKind::LostCommand, .axis = {}, .value = 1.0});
    rig.run(Seconds(2.0));
    rig.link->pair().faults().remove(cut);
    rig.run(Seconds(0.5));
    ASSERT_EQ(rig.status().state, StationState::Fault);
    ASSERT_EQ(rig.ask(request::Rearm{}), "");
    Angle fallen;
    for (int i = 0; i < 200; ++i) {
        rig.tick();
        fallen = std::max(fallen, 45_deg - rig.truth().elevation);
    }
    EXPECT_LT(fallen, 1_deg);
    EXPECT_EQ(rig.status().state, StationState::Standby);
}

class DriveFault : public FaultTest, public ::testing::WithParamInterface<int>
{};

TEST_P(DriveFault, OfOneAxisHoldsTheOtherAndWaitsForReArming)
{
    const auto fault = inject(sim::FaultKind::DriveFault, Axis::Azimuth, GetParam());
    rig.run(Seconds(2.0));
    EXPECT_EQ(rig.status().state, StationState::Fault);
    EXPECT_TRUE(rig.alarmSays(QStringLiteral("azimuth drive reports fault %1: ").arg(GetParam())));
    EXPECT_EQ(rig.link->truth(Axis::Elevation).mode, moteus::Mode::Position) << "the healthy axis is held";
    EXPECT_EQ(client->ask("p\n", 2).find("RPRT"), std::string::npos) << "the position is known";
    expectNothingMovesFor(Seconds(4.0), "RPRT -9\n");

    EXPECT_EQ(rig.ask(request::Rearm{}), "");
    EXPECT_EQ(rig.ask(request::GiveAuthority{}), "");
    rig.run(Seconds(1.0));
    static_cast<void>(client->ask(kFarther));
    rig.run(Seconds(1.0));
    EXPECT_EQ(rig.status().state, StationState::Fault) << "the cause is still there";

    end(fault);
    EXPECT_EQ(client->ask("R 1\n"), "RPRT 0\n");
    rig.run(Seconds(1.0));
    EXPECT_EQ(rig.status().state, StationState::Standby);
    expectMotionAgain();
}

std::vector<int> faultCodes()
{
    std::vector<int> codes;
    for (int code = 32; code <= 50; ++code) {
        codes.push_back(code);
    }
    return codes;
}

INSTANTIATE_TEST_SUITE_P(Code, DriveFault, ::testing::ValuesIn(faultCodes()));

TEST_F(FaultTest, AfterALossOfPowerNothingIsPointedUntilThePositionIsKnown)
{
    // Somebody turns the azimuth by hand meanwhile: the drive wakes up on another turn of its rotor and cannot know
    // this.
    const double turned = rig.truth(Axis::Azimuth) + 50.0;
    const auto off = inject(sim::FaultKind::PowerLoss, Axis::Azimuth, turned);
    rig.run(Seconds(3.0));
    EXPECT_EQ(client->ask("p\n"), "RPRT -6\n");
    end(off);
    rig.run(Seconds(3.0));
    EXPECT_NEAR(rig.truth(Axis::Azimuth), turned, 0.1);
    expectNothingMovesFor(Seconds(4.0), "RPRT -9\n");
    EXPECT_EQ(client->ask("R 1\n"), "RPRT 0\n");
    rig.run(Seconds(1.0));
    expectNothingMovesFor(Seconds(4.0), "RPRT -9\n");
    EXPECT_THAT(rig.ask(request::PointAxes{{.azimuth = 230_deg, .elevation = 40_deg}}),
                ::testing::HasSubstr("The cable wrap of the azimuth drive is unknown"));

    // The jog keys move it, although the drive woke up outside its own position bounds.
    const AxisPosition here = rig.truth();
    for (int i = 0; i < 10; ++i) {
        EXPECT_EQ(rig.ask(request::Jog{{.elevation = 1_deg_s}}), "");
        rig.run(Seconds(0.1));
    }
    rig.run(Seconds(1.0));
    EXPECT_NE(rig.status().state, StationState::Fault);
    EXPECT_NEAR((rig.truth().elevation - here.elevation).degrees(), 1.0, 0.3);

    // The operator has looked at the mount.
    for (const Axis axis : {Axis::Azimuth, Axis::Elevation}) {
        EXPECT_EQ(rig.ask(request::ChooseTurn{axis, Angle::fromDegrees(rig.truth(axis))}), "");
        rig.run(Seconds(0.5));
    }
    EXPECT_TRUE(rig.ready());
    EXPECT_NEAR(rig.status().azimuth.actual->degrees(), rig.truth(Axis::Azimuth), 0.1);
    EXPECT_EQ(rig.ask(request::GiveAuthority{}), "");
    expectMotionAgain();
}

// Recovery settings for a station without an operator: the mount is re-armed, and nothing moves. The fault has already
// switched the output off. The re-arm leaves the drive off.
TEST(Recovery, ReArmsByTheProfileAndMovesNothing)
{
    profile::Profile profile = anyPort();
    profile.recovery.supply = profile::Retry::Once;
    profile.recovery.interval = Seconds(5.0);
    SimulatedStation rig(profile);
    ASSERT_EQ(rig.ask(request::PointAxes{{.azimuth = 40_deg, .elevation = 30_deg}}), "");
    ASSERT_TRUE(rig.settle());
    const auto fault = [&](double code) {
        rig.link->inject(
            {.kind = sim::FaultKind::DriveFault, .axis = Axis::Elevation, .duration = Seconds(0.1), .value = code});
        rig.run(Seconds(1.0));
        EXPECT_EQ(rig.status().state, StationState::Fault);
    };
    fault(40.0);
    const AxisPosition here = rig.truth();
    rig.run(Seconds(3.0));
    EXPECT_EQ(rig.status().state, StationState::Fault) << "not before the interval is over";
    rig.run(Seconds(3.0));
    EXPECT_EQ(rig.status().state, StationState::Standby);
    EXPECT_TRUE(rig.logSays(QStringLiteral("recovery policy")));
    EXPECT_LT(rig.farthestFrom(here), 1_deg);

    ASSERT_EQ(rig.ask(request::PointAxes{{.azimuth = 40_deg, .elevation = 30_deg}}), "");
    ASSERT_TRUE(rig.settle());
    fault(35.0);
    rig.run(Seconds(20.0));
    EXPECT_EQ(rig.status().state, StationState::Fault) << "never after a fault of the encoder";
}

TEST_F(FaultTest, AGustBendsThePathAndEndsWithoutHarm)
{
    ASSERT_TRUE(rig.settle());
    const AxisPosition here = rig.truth();
    rig.link->inject({.kind = sim::FaultKind::Wind, .duration = Seconds(3.0), .value = 20.0});
    Angle worst;
    rig.onTick = [&] { worst = std::max(worst, rig.farthestFrom(here)); };
    rig.run(Seconds(6.0));
    rig.onTick = nullptr;
    EXPECT_LT(worst, 1.5_deg);
    EXPECT_LT(rig.farthestFrom(here), 0.1_deg);
    EXPECT_NE(rig.status().state, StationState::Fault);
    RecordProperty("gust_worst_deg", QString::number(worst.degrees(), 'f', 3).toStdString());
    expectMotionAgain();
}

TEST_F(FaultTest, EveryStartOfAMotionIsExplained)
{
    // Azimuth is resolved to 0.0055°, so either text is right.
    EXPECT_TRUE(rig.logSays(QStringLiteral("moves the mount from 0.00° 10.00°: go to 200.00° 60.00°")) ||
                rig.logSays(QStringLiteral("moves the mount from 359.99° 10.00°: go to 200.00° 60.00°")));
}

// The first alarm that the operator reads must be the cause, in every order of events, also after an acknowledgement.
class RootCauseTest : public FaultTest
{
protected:
    [[nodiscard]] Alarm first() const { return rig.status().alarms.front(); }
    [[nodiscard]] bool stands(const QString& name) const
    {
        const std::vector<Alarm> alarms = rig.status().alarms;
        return std::ranges::any_of(alarms, [&](const Alarm& one) { return one.active && one.name == name; });
    }
    void expectFirst(const char* name)
    {
        EXPECT_EQ(first().name.toStdString(), name) << first().what.toStdString();
        EXPECT_EQ(rig.ask(request::AcknowledgeAlarms{}), "");
        rig.run(Seconds(2.0));
        EXPECT_EQ(first().name.toStdString(), name) << first().what.toStdString();
        EXPECT_TRUE(first().active);
    }
};

// REQ-ALARMS-302 (RootCauseTest.*)
TEST_F(RootCauseTest, AnAdapterThatIsGoneInMidPass)
{
    inject(sim::FaultKind::BusOff, {});
    rig.run(Seconds(3.0));
    EXPECT_FALSE(stands(QStringLiteral("drive.silent"))) << "one cause, one alarm";
    EXPECT_FALSE(stands(QStringLiteral("drives.silent")));
    expectFirst("bus.down");
}

TEST_F(RootCauseTest, AnAdapterThatIsGoneAfterAFault)
{
    inject(sim::FaultKind::DriveFault, Axis::Elevation, 38.0);
    rig.run(Seconds(1.0));
    EXPECT_EQ(first().name, QStringLiteral("drive.fault"));
    EXPECT_EQ(first().help, AlarmHelp::Rearm);
    inject(sim::FaultKind::BusOff, {});
    rig.run(Seconds(3.0));
    EXPECT_TRUE(stands(QStringLiteral("drive.fault")));
    expectFirst("bus.down");
}

TEST_F(RootCauseTest, OneDriveWithoutPower)
{
    inject(sim::FaultKind::BoardPowerLoss, Axis::Azimuth);
    rig.run(Seconds(3.0));
    EXPECT_EQ(first().about, QStringLiteral("azimuth")) << first().what.toStdString();
    expectFirst("drive.silent");
}

TEST_F(RootCauseTest, OverTemperatureThenSilence)
{
    inject(sim::FaultKind::DriveFault, Axis::Azimuth, 38.0);
    rig.run(Seconds(1.0));
    EXPECT_EQ(rig.ask(request::AcknowledgeAlarms{}), "");
    inject(sim::FaultKind::Silence, Axis::Azimuth);
    rig.run(Seconds(3.0));
    EXPECT_TRUE(stands(QStringLiteral("drive.no-reply")));
    expectFirst("drive.fault");
}

TEST_F(RootCauseTest, StopWhileFaulted)
{
    inject(sim::FaultKind::DriveFault, Axis::Azimuth, 38.0);
    rig.run(Seconds(1.0));
    EXPECT_EQ(rig.ask(request::Stop{}), "");
    rig.run(Seconds(0.5));
    EXPECT_TRUE(rig.status().stopLatched);
    expectFirst("drive.fault");
}

}  // namespace
}  // namespace boresight::system_test
