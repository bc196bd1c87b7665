// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/north/kept_points.h"

#include "core/alarms/catalogue.h"
#include "tests/core/north/north_rig.h"

#include <gtest/gtest.h>

namespace boresight {
namespace {

using namespace boresight::literals;

// North lies at 20° of the azimuth axis.
NewPoint keptPoint(Angle azimuth)
{
    return {.axes = {.azimuth = azimuth, .elevation = 30_deg},
            .truth = {.azimuth = azimuth + 20_deg, .elevation = 30_deg},
            .sigma = 0.03_deg,
            .label = QStringLiteral("landmark")};
}

TEST(KeptPoints, SixtyAreEnough)
{
    NorthRig rig;
    calibration::CalibrationRecord record{.title = QStringLiteral("Points"), .mount = rig.mount.today()};
    record.points.resize(59);
    rig.file.keepPoints(record);
    KeptPoints many(rig.control, rig.file, rig.mount, rig.model, rig.clock, rig.log);
    EXPECT_TRUE(many.hasRoom());
    many.add(keptPoint(60_deg));
    EXPECT_FALSE(many.hasRoom());
    ASSERT_TRUE(many.drop(0));
    EXPECT_TRUE(many.hasRoom());
}

TEST(KeptPoints, EveryChangeIsKeptAndFitted)
{
    NorthRig rig;
    rig.points.add(keptPoint(100_deg));
    EXPECT_EQ(1U, rig.file.points().size());
    ASSERT_TRUE(rig.points.book().fitted());
    EXPECT_TRUE(rig.points.contradictModel());
    rig.profile.pointing.azimuthOffset = 380_deg;
    rig.inForce.apply(rig.profile);
    EXPECT_FALSE(rig.points.contradictModel()) << "any turn of it is the same north";
    ASSERT_TRUE(rig.points.use(0, false));
    EXPECT_FALSE(rig.file.points().front().isUsed);
    EXPECT_FALSE(rig.points.book().fitted());
    rig.points.clear();
    EXPECT_TRUE(rig.file.points().empty());
}

TEST(KeptPoints, ThoseOfAnEarlierRunCountOnceBothDrivesAreRead)
{
    NorthRig rig;
    rig.points.add(keptPoint(100_deg));
    rig.StationRig::mount.learn(Axis::Azimuth, std::nullopt);
    MountIdentity mount(rig.control, rig.inForce);
    EXPECT_TRUE(mount.update());
    KeptPoints again(rig.control, rig.file, mount, rig.model, rig.clock, rig.log);
    EXPECT_EQ(1U, again.book().points().size());
    EXPECT_FALSE(again.book().fitted());
    EXPECT_FALSE(again.countRestored());
    rig.learn(Axis::Azimuth, rig.factsOf(Axis::Azimuth));
    EXPECT_TRUE(mount.update());
    EXPECT_TRUE(again.countRestored());
    EXPECT_TRUE(again.book().fitted());
    EXPECT_FALSE(again.countRestored()) << "once only";
}

TEST(KeptPoints, ThoseOfAnotherDriveAreLeftOutOnce)
{
    NorthRig rig;
    rig.points.add(keptPoint(100_deg));
    EXPECT_FALSE(rig.points.leaveOutOthers());
    drive_check::DriveFacts other = rig.factsOf(Axis::Elevation);
    other.uuid = QStringLiteral("e0000000-0000-0000-0000-000000000009");
    rig.learn(Axis::Elevation, other);
    ASSERT_TRUE(rig.mount.update());
    EXPECT_TRUE(rig.points.leaveOutOthers());
    EXPECT_FALSE(rig.points.book().points().front().isUsed);
    EXPECT_TRUE(rig.control.alarms().active(alarmEntry("points.other-drive")));
    EXPECT_FALSE(rig.points.leaveOutOthers());
    ASSERT_TRUE(rig.points.use(0, true));
    EXPECT_FALSE(rig.control.alarms().active(alarmEntry("points.other-drive"))) << "the operator knows better";
    EXPECT_FALSE(rig.points.leaveOutOthers());
}

}  // namespace
}  // namespace boresight
