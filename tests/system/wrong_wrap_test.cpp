// SPDX-License-Identifier: GPL-3.0-or-later
// The mount was without power, and the operator enters the wrong cable wrap. The axis then runs towards the real end of
// its cable, where Boresight believes in 143° of free way. Judged by the true position of the antenna.
#include "tests/system/simulated_station.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace boresight::system_test {
namespace {

using sim::FaultKind;

constexpr double kHardStop = -98.0;  // of the simulated azimuth (core/sim/reference_mount.cpp)
constexpr Seconds kLongestUnwrap{40.0};

// The mount loses its power at 405°. Somebody turns the azimuth back by one turn, to 45°. The journal has 405°, the
// drive reports the same within its turn, and the operator enters 405°.
class WrongWrap : public ::testing::Test
{
protected:
    void SetUp() override
    {
        ASSERT_EQ(rig.ask(request::PointAxes{{405_deg, 50_deg}}), "");
        ASSERT_TRUE(rig.settle());
        rig.run(Seconds(1.0));
        const auto off = rig.link->inject({.kind = FaultKind::PowerLoss, .axis = Axis::Azimuth, .value = 45.0});
        rig.run(Seconds(3.0));
        rig.link->pair().faults().remove(off);
        ASSERT_TRUE(rig.runUntil([this] { return isAsked(Axis::Azimuth) && isAsked(Axis::Elevation); }, Seconds(10.0)));
        ASSERT_NEAR(azimuth(), 45.0, 0.1);
        ASSERT_EQ(rig.ask(request::Rearm{}), "");
        rig.run(Seconds(1.0));
        ASSERT_EQ(enter(Axis::Elevation, rig.truth().elevation), "");
        ASSERT_EQ(enter(Axis::Azimuth, 405_deg), "");
        ASSERT_TRUE(rig.runUntil([this] { return rig.ready(); }, Seconds(15.0)));
        ASSERT_NEAR(rig.status().azimuth.actual->degrees(), 405.0, 0.1);
    }

    [[nodiscard]] bool isAsked(Axis axis) const
    {
        const StationStatus status = rig.status();
        return (axis == Axis::Azimuth ? status.drives->azimuth : status.drives->elevation).turnQuestion.has_value();
    }
    [[nodiscard]] std::string enter(Axis axis, Angle place)
    {
        const std::string refusal = rig.ask(request::ChooseTurn{axis, place});
        rig.run(Seconds(0.5));
        return refusal;
    }
    [[nodiscard]] double azimuth() const { return rig.truth(Axis::Azimuth); }
    [[nodiscard]] bool isFault() const { return rig.status().state == StationState::Fault; }
    [[nodiscard]] bool unwrapIsStopped()
    {
        return rig.ask(request::Unwind{}).empty() && rig.runUntil([this] { return isFault(); }, kLongestUnwrap);
    }

    // A client keeps asking, and the antenna stays where it is.
    void expectNothingMoves()
    {
        const auto client = rig.connect();
        const double stood = azimuth();
        double farthest = 0.0;
        for (int i = 0; i < 10; ++i) {
            EXPECT_THAT(client->ask("P 200 60\n"), ::testing::StartsWith("RPRT -"));
            rig.run(Seconds(1.0));
            farthest = std::max(farthest, std::abs(azimuth() - stood));
        }
        EXPECT_LT(farthest, 0.3);
    }

    SimulatedStation rig{anyPort(), sim::commissionedPair({.azimuth = 390_deg, .elevation = 50_deg})};
};

// REQ-AXES-963 (WrongWrap.*)
TEST_F(WrongWrap, TheHardStopEndsTheUnwrap)
{
    int ticksAtTheStop = 0;
    rig.onTick = [&] { ticksAtTheStop += azimuth() < kHardStop + 0.1 ? 1 : 0; };
    ASSERT_TRUE(unwrapIsStopped());
    rig.onTick = {};
    EXPECT_GT(azimuth(), kHardStop - 2.0);
    EXPECT_LT(ticksAtTheStop * SimulatedStation::kTick.count(), 0.3) << "found before the missing motion";
    EXPECT_TRUE(rig.alarmSays(QStringLiteral("Its entered cable wrap may be wrong")));
    rig.run(Seconds(2.0));
    EXPECT_LT(std::abs(rig.link->truth(Axis::Azimuth).torque), 10.0) << "the drive does not push on";
    EXPECT_TRUE(rig.runUntil([this] { return isAsked(Axis::Azimuth); }, Seconds(10.0))) << "the wrap is in doubt";
    expectNothingMoves();

    ASSERT_EQ(rig.ask(request::Rearm{}), "");
    rig.run(Seconds(1.0));
    expectNothingMoves();
    EXPECT_THAT(rig.ask(request::Unwind{}), ::testing::HasSubstr("cable wrap of the azimuth drive is unknown"));

    // The operator jogs back from the stop and enters the right place.
    for (int i = 0; i < 100; ++i) {
        ASSERT_EQ(rig.ask(request::Jog{{.azimuth = 2_deg_s}}), "");
        rig.run(Seconds(0.1));
    }
    rig.run(Seconds(2.0));
    EXPECT_GT(azimuth(), kHardStop + 15.0);
    ASSERT_EQ(enter(Axis::Azimuth, rig.truth().azimuth), "");
    ASSERT_TRUE(rig.runUntil([this] { return rig.ready(); }, Seconds(15.0)));
    ASSERT_EQ(rig.ask(request::PointAxes{{45_deg, 50_deg}}), "");
    ASSERT_TRUE(rig.settle());
    EXPECT_NEAR(azimuth(), 45.0, 0.1);
}

// A cable gets tight over some degrees before the stop.
TEST_F(WrongWrap, ACableThatGetsTightEndsTheUnwrapBeforeTheHardStop)
{
    constexpr double kTightAt = -80.0;
    constexpr double kStiffness = 5.0;  // Nm/°
    sim::FaultSchedule::Handle pull{};
    rig.onTick = [&] {
        rig.link->pair().faults().remove(pull);
        pull = rig.link->inject({.kind = FaultKind::Wind,
                                 .axis = Axis::Azimuth,
                                 .value = kStiffness * std::max(0.0, kTightAt - azimuth())});
    };
    ASSERT_TRUE(unwrapIsStopped());
    EXPECT_TRUE(rig.alarmSays(QStringLiteral("Its entered cable wrap may be wrong")));
    rig.run(Seconds(2.0));
    EXPECT_GT(azimuth(), kHardStop + 8.0);
    EXPECT_TRUE(rig.runUntil([this] { return isAsked(Axis::Azimuth); }, Seconds(10.0)));
    expectNothingMoves();
    rig.onTick = {};
}

}  // namespace
}  // namespace boresight::system_test
