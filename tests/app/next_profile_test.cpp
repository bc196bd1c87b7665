// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/next_profile.h"

#include "core/profile/commissioning.h"
#include "core/profile/profile_diff.h"
#include "core/profile/profile_file.h"
#include "core/profile/profile_store.h"
#include "tests/app/profile_rig.h"
#include "tests/fakes/text_of.h"

#include <QFile>

#include <gtest/gtest.h>

#include <array>

namespace boresight::app {
namespace {

// As an operator who changes everything.
void changeAndFindEverything(profile::Profile& profile)
{
    profile::setReading(profile, Axis::Elevation, 3_deg, 10_deg, profile::Ends::StayOnTheMount);
    profile::setReading(profile, Axis::Azimuth, 10_deg, 47_deg, profile::Ends::StayOnTheMount);
    profile::reverse(profile, Axis::Azimuth, std::nullopt);
    profile::swapMotors(profile);
    profile::setTravel(profile, Axis::Azimuth, {.min = -10_deg, .max = 270_deg});
    profile::setNorth(profile, {.azimuth = 20_deg, .elevation = 20_deg}, 57.4_deg);
    profile.pointing.tiltEast = 1_deg;
    profile.sensor.source = profile::SensorSource::Simulated;
    profile.sensor.mounting.azimuthOffset = 5_deg;
    profile.sensor.deviation.a1 = 3_deg;
    profile.mount.directions = profile.mount.directions == profile::Directions::Confirmed
                                   ? profile::Directions::Unconfirmed
                                   : profile::Directions::Confirmed;
    profile.mount.name += " renamed";
    profile.jog.slow = 0.7_deg_s;
    profile.limits.horizon = {{.azimuth = 10_deg, .elevation = -5_deg}, {.azimuth = 20_deg, .elevation = -7_deg}};
    profile.presets = {{"north", {0_deg, 0_deg}}};
    profile.site = {.known = true, .latitude = 38.7_deg, .longitude = -9.1_deg, .heightMetres = 100.0};
    profile.rotctld.maxClients = 7;
}

// Compared as in a file, which has fewer digits.
void expectAlike(const profile::Profile& a, const profile::Profile& b)
{
    EXPECT_EQ(profile::changedKeys(a, b), std::vector<std::string>());
}

// Story: after an Apply on the simulated mount the real one used the simulated north. A level set in the guide with
// --simulate became the zero of the real mount at the next start, with its ends. Directions confirmed on the simulated
// mount let the real one move at full speed.
// REQ-PROFILE-17a
TEST(NextProfile, NothingOfASimulationReachesAFileOfARealMount)
{
    ProfileRig rig;
    rig.keep(realMount("Field"));
    rig.keep(realMount());
    const auto before = rig.realFiles();
    rig.simulate();
    profile::Profile wanted = rig.first();
    EXPECT_EQ(wanted, realMount()) << "the mount as it is";
    Profiles profiles(rig.options);
    for (const char* const part : {"", "keeps trying"}) {
        changeAndFindEverything(wanted);
        wanted.mount.name += part;
        profiles.save(wanted);
        EXPECT_EQ(profiles.next(wanted), wanted) << "a reconnect";
    }
    // Another mount of the list, whose bus is not used.
    profile::Profile field = profiles.next(realMount("Field"));
    EXPECT_EQ(field, realMount("Field"));
    changeAndFindEverything(field);
    profiles.save(field);
    expectAlike(profiles.next(realMount()), wanted);  // back to the first one, unchanged
    EXPECT_EQ(profiles.reason, QString());
    EXPECT_EQ(rig.realFiles(), before);
    expectAlike(rig.first(), wanted);  // and the same in the next simulation
    const auto copy = profile::loadProfile(rig.state() + QStringLiteral("/simulated/Roof.toml"));
    ASSERT_TRUE(copy) << textOf(copy.error());
    EXPECT_EQ(copy->bus, "simulated")
        << "started with this file, the real mount would have the north of the simulation";
    rig.options.profile = realMount();
    rig.options.simulation = Simulation::Off;
    EXPECT_EQ(rig.first(), realMount());
    EXPECT_EQ(rig.realFiles(), before);
}

// A simulation with the old profile would have limits that the mount does not have any more.
// REQ-PROFILE-17a
TEST(NextProfile, AChangedProfileIsSimulatedAnew)
{
    ProfileRig rig;
    rig.keep(realMount());
    rig.simulate();
    profile::Profile wanted = rig.first();
    wanted.pointing.azimuthOffset = 37.4_deg;
    EXPECT_EQ(rig.save(wanted), QString());
    EXPECT_EQ(rig.first(), wanted);
    profile::Profile changed = realMount();
    changed.jog.slow = 0.7_deg_s;
    ASSERT_TRUE(profile::saveProfile(changed, rig.options.profilePath));
    EXPECT_EQ(rig.first(), changed);
    // Story: the first change of the new copy overwrote the old copy.
    changed.jog.fast = 4_deg_s;
    EXPECT_EQ(rig.save(changed), QString());
    const auto old = profile::loadProfile(rig.state() + QStringLiteral("/simulated/Roof.toml.old"));
    ASSERT_TRUE(old) << textOf(old.error());
    EXPECT_EQ(old->pointing, wanted.pointing);
}

// Story: a mount was changed and simulated alternately. Only the last simulation but one was kept.
TEST(NextProfile, EverySimulationOfAProfileThatHasChangedIsKept)
{
    ProfileRig rig;
    rig.keep(realMount());
    rig.simulate();
    for (const auto speed : {0.7_deg_s, 0.8_deg_s}) {
        profile::Profile wanted = rig.first();
        wanted.pointing.azimuthOffset = 37.4_deg;
        EXPECT_EQ(rig.save(wanted), QString());
        profile::Profile changed = realMount();
        changed.jog.slow = speed;
        ASSERT_TRUE(profile::saveProfile(changed, rig.options.profilePath));
    }
    EXPECT_EQ(rig.first().jog.slow, 0.8_deg_s);
    const QString old = rig.state() + QStringLiteral("/simulated/Roof.toml.old");
    const auto eldest = profile::loadProfile(old);
    const auto second = profile::loadProfile(old + QLatin1Char('2'));
    ASSERT_TRUE(eldest && second);
    EXPECT_EQ(eldest->pointing.azimuthOffset, 37.4_deg);
    EXPECT_EQ(eldest->jog.slow, realMount().jog.slow);
    EXPECT_EQ(second->jog.slow, 0.7_deg_s);
    // A simulation without changes is not kept as an old copy.
    ASSERT_TRUE(profile::saveProfile(realMount(), rig.options.profilePath));
    EXPECT_EQ(rig.first(), realMount());
    EXPECT_FALSE(QFile::exists(old + QLatin1Char('3')));
}

// Two files may have the same mount name, and so the same file for the simulation.
// REQ-PROFILE-17a
TEST(NextProfile, TheSimulationOfAnotherFileIsNotThisOnes)
{
    ProfileRig rig;
    rig.keep(realMount());
    rig.simulate();
    profile::Profile wanted = rig.first();
    wanted.pointing.azimuthOffset = 37.4_deg;
    EXPECT_EQ(rig.save(wanted), QString());
    profile::Profile other = realMount();
    other.elevation.geometry.travel.max = 80_deg;
    rig.options.profilePath = rig.folder.filePath(QStringLiteral("other.toml"));
    ASSERT_TRUE(profile::saveProfile(other, rig.options.profilePath));
    EXPECT_EQ(rig.first(), other);
}

TEST(NextProfile, WhatTheCommandLineSaysIsSimulatedAndNotKept)
{
    ProfileRig rig;
    rig.keep(realMount());
    rig.options.profile.rotctld.listen.port = 0;
    rig.options.overridden = {"rotctld.listen"};
    rig.simulate();
    profile::Profile wanted = rig.first();
    EXPECT_EQ(wanted.rotctld.listen.port, 0);
    wanted.jog.slow = 0.7_deg_s;
    EXPECT_EQ(rig.save(wanted), QString());
    rig.options.overridden.clear();
    EXPECT_EQ(rig.first().rotctld.listen.port, realMount().rotctld.listen.port);
    EXPECT_EQ(rig.first().jog.slow, 0.7_deg_s);
}

// Story: the port of one first start was used for all following starts.
TEST(NextProfile, WhatTheCommandLineSaysAtAFirstStartIsNotKept)
{
    ProfileRig rig;
    rig.options.profile.sensor.source = profile::SensorSource::Simulated;
    rig.options.profile.rotctld.listen.port = 0;
    rig.options.overridden = {"rotctld.listen"};
    EXPECT_EQ(rig.first(), rig.options.profile);
    rig.options.profile.rotctld.listen = profile::Profile{}.rotctld.listen;
    rig.options.overridden.clear();
    EXPECT_EQ(rig.first(), rig.options.profile);
}

// Story: when the adapter was chosen in the guide, the server changed to another port than the one of --listen.
TEST(NextProfile, WhatTheCommandLineSaysHoldsAlsoWhenTheSimulationIsLeft)
{
    ProfileRig rig;
    rig.options.profile.rotctld.listen.port = 0;
    rig.options.overridden = {"rotctld.listen"};
    Profiles profiles(rig.options);
    profile::Profile wanted = profiles.first;
    wanted.bus = "socketcan:can0";
    EXPECT_EQ(profiles.next(wanted).rotctld.listen.port, 0);
    const auto current = rig.store().findCurrent();
    ASSERT_TRUE(current && *current);
    EXPECT_EQ(profile::loadProfile(**current)->rotctld.listen, profile::Profile{}.rotctld.listen);
}

TEST(NextProfile, AFirstStartIsSimulatedAndComesBackAsItWasLeft)
{
    ProfileRig rig;
    rig.options.profile.mount.directions = profile::Directions::Unconfirmed;
    profile::Profile wanted = rig.first();
    EXPECT_EQ(wanted, rig.options.profile);
    wanted.mount.directions = profile::Directions::Confirmed;
    wanted.pointing.azimuthOffset = 37.4_deg;
    EXPECT_EQ(rig.save(wanted), QString());
    EXPECT_TRUE(rig.realFiles().empty());
    EXPECT_EQ(rig.first(), wanted);
}

// Story: the bus was chosen in the guide. The north of the simulated mount was taken along, and the real mount pointed
// 37.4° wrong.
// REQ-PROFILE-17a
TEST(NextProfile, ARealBusLeavesTheSimulationBehind)
{
    ProfileRig rig;
    Profiles profiles(rig.options);
    profile::Profile wanted = profiles.first;
    changeAndFindEverything(wanted);
    profiles.save(wanted);
    profile::useBus(wanted, "socketcan:can0", std::array{4, 9});
    wanted.park.azimuth = 20_deg;  // typed together with the bus
    wanted.mount.directions = profile::Directions::Confirmed;
    profile::Profile real;
    real.bus = "socketcan:can0";
    real.mount.directions = profile::Directions::Unconfirmed;
    real.azimuth.id = 4;
    real.elevation.id = 9;
    real.park.azimuth = 20_deg;
    EXPECT_EQ(profiles.next(wanted), real);
    const auto current = rig.store().findCurrent();
    ASSERT_TRUE(current && *current);
    EXPECT_EQ(profile::loadProfile(**current), real);
    // From here on it is an ordinary real mount.
    real.pointing.azimuthOffset = 5_deg;
    profiles.save(real);
    EXPECT_EQ(profiles.next(real), real);
    EXPECT_EQ(profile::loadProfile(**current), real);
}

// A file of an older version, which stored the calibration of the simulated mount in it.
// REQ-PROFILE-17a
TEST(NextProfile, AFileThatNamesNoRealBusIsSimulatedAndGetsTheBus)
{
    ProfileRig rig;
    profile::Profile tried;
    tried.pointing.azimuthOffset = 37.4_deg;
    tried.azimuth.geometry.offset = 5_deg;
    tried.sensor.source = profile::SensorSource::Simulated;
    tried.jog.slow = 0.7_deg_s;
    rig.keep(tried);
    const auto before = rig.realFiles();
    profile::Profile wanted = rig.first();
    EXPECT_EQ(wanted, tried);
    wanted.pointing.azimuthOffset = 40_deg;
    EXPECT_EQ(rig.save(wanted), QString());
    EXPECT_EQ(rig.realFiles(), before);
    Profiles profiles(rig.options);
    EXPECT_EQ(profiles.first, wanted);
    wanted.bus = "socketcan:can0";
    profile::Profile real;
    real.bus = "socketcan:can0";
    real.mount.directions = profile::Directions::Unconfirmed;
    real.jog.slow = 0.7_deg_s;
    EXPECT_EQ(profiles.next(wanted), real);
    EXPECT_EQ(rig.loaded(), real);
}

// Story: a file with a typing error was overwritten with the built-in reference mount.
// REQ-PROFILE-17a
TEST(NextProfile, AFileThatCannotBeReadIsNotTakenForARealMounts)
{
    ProfileRig rig;
    rig.keep(profile::Profile{});
    Profiles profiles(rig.options);
    QFile file(rig.options.profilePath);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("[jog\n");
    file.close();
    const auto before = rig.realFiles();
    const profile::Profile simulated = profiles.first;
    profile::Profile wanted = simulated;
    wanted.bus = "socketcan:can0";
    EXPECT_EQ(profiles.next(wanted), simulated);
    EXPECT_TRUE(profiles.reason.contains(rig.options.profilePath)) << profiles.reason.toStdString();
    EXPECT_EQ(rig.realFiles(), before);
}

// Story: the name typed together with the bus belonged to another mount, and then two files had this name.
TEST(NextProfile, WithTheNameOfAnotherMountTheSimulationIsNotLeft)
{
    ProfileRig rig;
    rig.keep(realMount("Field"));
    rig.keep(profile::Profile{});
    const auto before = rig.realFiles();
    Profiles profiles(rig.options);
    const profile::Profile simulated = profiles.first;
    profile::Profile wanted = simulated;
    wanted.bus = "socketcan:can0";
    wanted.mount.name = "Field";
    EXPECT_EQ(profiles.next(wanted), simulated);
    EXPECT_TRUE(profiles.reason.contains(QStringLiteral("A mount \"Field\" already exists")))
        << profiles.reason.toStdString();
    EXPECT_EQ(rig.realFiles(), before);
}

// Story: settings typed together with the bus were dropped without a report, because they were valid only with the ends
// of the simulation.
TEST(NextProfile, WhatDoesNotGoWithTheMountsOwnProfileIsReported)
{
    ProfileRig rig;
    rig.keep(profile::Profile{});
    const auto before = rig.realFiles();
    Profiles profiles(rig.options);
    profile::Profile simulated = profiles.first;
    profile::setTravel(simulated, Axis::Azimuth, {.min = -90_deg, .max = 700_deg});
    profiles.save(simulated);
    profile::Profile wanted = simulated;
    wanted.bus = "socketcan:can0";
    wanted.park.azimuth = 600_deg;
    EXPECT_EQ(profiles.next(wanted), simulated);
    EXPECT_TRUE(profiles.reason.startsWith(QStringLiteral("park."))) << profiles.reason.toStdString();
    EXPECT_EQ(rig.realFiles(), before);
}

// Story: such a mount was selected and became the current one. After that the program did not start any more.
TEST(NextProfile, AMountOfTheListThatCannotBeARealOneIsNotConnected)
{
    ProfileRig rig;
    profile::Profile field = realMount("Field");
    field.sensor.source = profile::SensorSource::Simulated;
    rig.keep(field);
    rig.keep(realMount());
    Profiles profiles(rig.options);
    EXPECT_EQ(profiles.next(field), realMount());
    EXPECT_TRUE(profiles.reason.startsWith(QStringLiteral("sensor.source: "))) << profiles.reason.toStdString();
    EXPECT_EQ(*rig.store().findCurrent(), rig.options.profilePath);
}

// The list contains the real mounts, and the operator may switch to one of them.
// REQ-PROFILE-17a
TEST(NextProfile, AnotherMountOfTheListLeavesTheSimulationAsItIs)
{
    ProfileRig rig;
    rig.keep(realMount());
    rig.keep(profile::Profile{});
    Profiles profiles(rig.options);
    profile::Profile wanted = profiles.first;
    wanted.pointing.azimuthOffset = 37.4_deg;
    profiles.save(wanted);
    EXPECT_EQ(profiles.next(realMount()), realMount());
    EXPECT_EQ(profiles.next(profile::Profile{}), wanted) << "and back";
    EXPECT_EQ(rig.loaded(), profile::Profile{});
}

TEST(NextProfile, AfterAnotherMountWasConnectedItsFileIsWritten)
{
    ProfileRig rig;
    rig.keep(realMount("Field"));
    const QString fieldFile = rig.options.profilePath;
    rig.keep(realMount());
    Profiles profiles(rig.options);
    profile::Profile changed = profiles.next(realMount("Field"));
    EXPECT_EQ(changed, realMount("Field"));
    changed.park.azimuth = 77_deg;
    profiles.save(changed);
    EXPECT_EQ(profile::loadProfile(fieldFile)->park.azimuth, 77_deg);
    EXPECT_EQ(rig.loaded(), realMount());
    EXPECT_EQ(*rig.store().findCurrent(), fieldFile) << "the next start begins where the operator was";
}

}  // namespace
}  // namespace boresight::app
