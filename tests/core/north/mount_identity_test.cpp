// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/north/mount_identity.h"

#include "tests/core/control/station_rig.h"

#include <gtest/gtest.h>

namespace boresight {
namespace {

using namespace boresight::literals;

TEST(MountIdentity, ADriveIsNewOnce)
{
    StationRig rig;
    rig.mount.learn(Axis::Elevation, std::nullopt);
    MountIdentity mount(rig.control, rig.inForce);
    EXPECT_TRUE(mount.update());
    EXPECT_FALSE(mount.update());
    EXPECT_FALSE(mount.bothRead());
    rig.learn(Axis::Elevation, rig.factsOf(Axis::Elevation));
    EXPECT_TRUE(mount.update());
    EXPECT_TRUE(mount.bothRead());
    EXPECT_EQ(rig.factsOf(Axis::Azimuth).uuid.toStdString(), mount.today().azimuthDrive);
    EXPECT_EQ(rig.factsOf(Axis::Elevation).uuid.toStdString(), mount.today().elevationDrive);
}

TEST(MountIdentity, ADriveThatIsSilentStaysTheSame)
{
    StationRig rig;
    MountIdentity mount(rig.control, rig.inForce);
    EXPECT_TRUE(mount.update());
    const calibration::RecordMount before = mount.today();
    rig.mount.learn(Axis::Azimuth, std::nullopt);
    EXPECT_FALSE(mount.update());
    EXPECT_TRUE(mount.bothRead());
    EXPECT_EQ(before, mount.today());
}

TEST(MountIdentity, ADriveWithoutAnIdentityIsReadButContradictsNothing)
{
    StationRig rig;
    MountIdentity mount(rig.control, rig.inForce);
    EXPECT_TRUE(mount.update());
    drive_check::DriveFacts nameless = rig.factsOf(Axis::Azimuth);
    nameless.uuid.clear();
    rig.learn(Axis::Azimuth, nameless);
    EXPECT_FALSE(mount.update());
    EXPECT_EQ(rig.factsOf(Axis::Azimuth).uuid.toStdString(), mount.today().azimuthDrive);

    MountIdentity other(rig.control, rig.inForce);
    EXPECT_TRUE(other.update());
    EXPECT_TRUE(other.bothRead());
}

TEST(MountIdentity, TheSiteIsThatOfTheProfile)
{
    StationRig rig;
    const MountIdentity mount(rig.control, rig.inForce);
    EXPECT_FALSE(mount.today().site);
    rig.profile.site = {.known = true, .latitude = 48.2_deg, .longitude = 16.37_deg, .heightMetres = 200.0};
    rig.inForce.apply(rig.profile);
    ASSERT_TRUE(mount.today().site);
    EXPECT_EQ(48.2_deg, mount.today().site->latitude);
}

}  // namespace
}  // namespace boresight
