// SPDX-License-Identifier: GPL-3.0-or-later
// The operator entered the cable wrap of the azimuth, and it may be wrong. The real stops are in
// tests/system/wrong_wrap_test.cpp.
#include "tests/core/control/station_rig.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace boresight {
namespace {

// The drives know their positions only within a multiple of 3.6°, and there is no journal.
struct EnteredRig : StationRig
{
    explicit EnteredRig(Angle place)
        : StationRig(profile::Profile{}, {.problem = QStringLiteral("The journal file is missing."),
                                          .standingAt = {std::nullopt, 10_deg},
                                          .looked = fakes::ManualClock().utc()})
    {
        azimuth.home = moteus::HomeState::Rotor;
        run(Seconds(2.0));
        EXPECT_TRUE(ask(request::ChooseTurn{Axis::Azimuth, place}));
        run(Seconds(0.5));
        EXPECT_TRUE(control.status().azimuth.turnKnown);
    }

    // More than the guard permits, less than a gust may need.
    void pull() { azimuth.torque = 0.5 * profile.azimuth.maxTorque; }
    [[nodiscard]] bool isAsked() const { return control.isTurnAsked(Axis::Azimuth); }
};

// REQ-AXES-963 (EnteredWrap.*): A cable wrap that the operator entered can be wrong. Where the end of the
// cable would be nearer than 20° on another wrap, which the motion so far does not exclude, 40 % of the torque stops
// the mount. The operator is then asked for the wrap again, and only a slow jog moves the axis. At the stop of a cable
// that was entered one wrap too far, the axis ends at most 2° after the contact, and the drive stops pushing within 0.3
// s.
TEST(EnteredWrap, ACableThatPullsStopsTheMountAndPutsTheWrapInDoubt)
{
    EnteredRig rig(36_deg);
    ASSERT_TRUE(rig.point(90.0, 45.0, kOperator));
    rig.settle();
    rig.pull();
    rig.run(Seconds(0.3));
    EXPECT_EQ(rig.state(), StationState::Fault);
    const auto alarms = rig.control.status().alarms;
    EXPECT_TRUE(std::ranges::any_of(alarms, [](const Alarm& one) {
        return one.active && one.name == QStringLiteral("axis.torque-guard") &&
               one.what.endsWith(QStringLiteral(". Its entered cable wrap may be wrong."));
    }));
    rig.azimuth.torque = 0.0;
    rig.run(Seconds(2.0));
    EXPECT_TRUE(rig.isAsked());
    const double stood = rig.azimuth.travelled;
    EXPECT_FALSE(rig.point(60.0, 45.0));
    ASSERT_TRUE(rig.ask(request::Rearm{}));
    rig.run(Seconds(2.0));
    EXPECT_FALSE(rig.point(60.0, 45.0, kOperator)) << "the wrap is unknown";
    EXPECT_NEAR(rig.azimuth.travelled, stood, 1e-4) << "nothing moves by itself";
}

// At 60° the axis would be at 420° on the other wrap, and the cable would not pull yet.
TEST(EnteredWrap, IsNotInDoubtWhereTheOtherEndIsFar)
{
    EnteredRig rig(36_deg);
    ASSERT_TRUE(rig.point(60.0, 45.0, kOperator));
    rig.settle();
    rig.pull();
    rig.run(Seconds(1.0));
    EXPECT_FALSE(rig.control.faultLatched());
    EXPECT_FALSE(rig.isAsked());
}

// At 200° no other wrap lies within the travel from -90° to 450°.
TEST(EnteredWrap, IsNotInDoubtAnyMoreWhereNoOtherIsPossible)
{
    EnteredRig rig(36_deg);
    ASSERT_TRUE(rig.point(200.0, 45.0, kOperator));
    rig.settle();
    ASSERT_TRUE(rig.point(90.0, 45.0, kOperator));
    rig.settle();
    rig.pull();
    rig.run(Seconds(1.0));
    EXPECT_FALSE(rig.control.faultLatched());
    EXPECT_FALSE(rig.isAsked());
}

}  // namespace
}  // namespace boresight
