// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/kept_profile.h"

#include "core/profile/profile_file.h"
#include "core/profile/profile_store.h"
#include "tests/app/profile_rig.h"

#include <gtest/gtest.h>

namespace boresight::app {
namespace {

// The file of the simulated mount was used with --bus. At the next start its north would be taken for that of the
// simulated mount.
// REQ-PROFILE-17a
TEST(KeptProfile, WhatIsFoundOfARealMountMakesTheFileItsOwn)
{
    ProfileRig rig;
    profile::Profile tried;
    tried.pointing = {.azimuthOffset = 37.4_deg, .elevationOffset = 1_deg};
    tried.sensor.source = profile::SensorSource::Simulated;
    rig.keep(tried);
    rig.options.profile = {};
    rig.options.profile.bus = "fdcanusb:/dev/mount";
    rig.options.profile.mount.directions = profile::Directions::Unconfirmed;
    profile::Profile wanted = rig.options.profile;
    wanted.jog.slow = 0.7_deg_s;
    EXPECT_EQ(rig.save(wanted), QString());
    tried.jog.slow = 0.7_deg_s;
    EXPECT_EQ(tried, rig.loaded()) << "a setting makes it nobody else's";
    rig.options.profile = wanted;
    wanted.mount.directions = profile::Directions::Confirmed;
    EXPECT_EQ(rig.save(wanted), QString());
    EXPECT_EQ(wanted, rig.loaded());
    rig.options.profile = wanted;
    wanted.pointing.azimuthOffset = 12_deg;
    EXPECT_EQ(rig.save(wanted), QString());
    EXPECT_EQ(wanted, rig.loaded());
}

// Story: after a start with --bus another adapter was typed in the table. The file then had a real bus and the
// simulated north.
// REQ-PROFILE-17a
TEST(KeptProfile, AnotherBusMakesTheSimulatedMountsFileARealOnes)
{
    ProfileRig rig;
    profile::Profile tried;
    tried.pointing.azimuthOffset = 37.4_deg;
    rig.keep(tried);
    rig.options.profile = {};
    rig.options.profile.bus = "fdcanusb:/dev/mount";
    rig.options.profile.mount.directions = profile::Directions::Unconfirmed;
    profile::Profile wanted = rig.options.profile;
    wanted.bus = "socketcan:can1";
    EXPECT_EQ(rig.save(wanted), QString());
    EXPECT_EQ(wanted, rig.loaded());
}

TEST(KeptProfile, WritesWhatTheOperatorChangedAndNotWhatTheCommandLineOverrode)
{
    ProfileRig rig;
    rig.keep(realMount());
    rig.options.profile.bus = "socketcan:can7";
    profile::Profile wanted = rig.options.profile;
    wanted.jog.slow = 0.7_deg_s;
    EXPECT_EQ(rig.save(wanted), QString());
    EXPECT_EQ(rig.loaded().jog.slow, 0.7_deg_s);
    EXPECT_EQ(rig.loaded().bus, "fdcanusb:/dev/mount");
}

TEST(KeptProfile, TheFirstChangeWithoutAFileMakesTheFirstMount)
{
    ProfileRig rig;
    rig.options.profile = realMount();  // by --bus
    rig.options.profile.rotctld.listen.port = 0;
    rig.options.overridden = {"rotctld.listen"};
    profile::Profile wanted = rig.options.profile;
    wanted.jog.slow = 0.7_deg_s;
    EXPECT_EQ(rig.save(wanted), QString());
    const auto current = rig.store().findCurrent();
    ASSERT_TRUE(current && *current);
    wanted.rotctld.listen = profile::Profile{}.rotctld.listen;
    EXPECT_EQ(profile::loadProfile(**current), wanted) << "and what the command line overrides is not in it";
}

TEST(KeptProfile, ANewNameMustNotBeAnotherMounts)
{
    ProfileRig rig;
    rig.keep(realMount("Field"));
    rig.keep(realMount());
    profile::Profile renamed = realMount();
    renamed.mount.name = "Field";
    const QString reason = rig.save(renamed);
    EXPECT_TRUE(reason.contains(QStringLiteral("A mount \"Field\" already exists"))) << reason.toStdString();
    EXPECT_EQ(rig.loaded().mount.name, "Roof");
}

}  // namespace
}  // namespace boresight::app
