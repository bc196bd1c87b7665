// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/profile_saver.h"

#include "core/profile/commissioning.h"
#include "core/profile/profile_diff.h"
#include "core/profile/profile_file.h"
#include "core/profile/profile_history.h"
#include "core/profile/profile_store.h"
#include "tests/fakes/text_of.h"
#include "tests/fakes/wait_until.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <array>
#include <map>

namespace boresight::app {
namespace {

profile::Profile realMount(const char* name = "Roof")
{
    profile::Profile real;
    real.mount.name = name;
    real.bus = "fdcanusb:/dev/mount";
    real.pointing.azimuthOffset = 12_deg;
    real.azimuth.geometry.offset = 3_deg;
    return real;
}

// As an operator who leaves nothing as it is.
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

// Why it was not saved.
void note(const ProfileSaver& saver, QString& reason)
{
    QObject::connect(
        &saver, &ProfileSaver::failed, &saver, [&reason](const QString& text) { reason = text; }, Qt::DirectConnection);
}

// As a file says them: it has fewer digits.
void expectAlike(const profile::Profile& a, const profile::Profile& b)
{
    EXPECT_EQ(profile::changedKeys(a, b), std::vector<std::string>());
}

struct Rig
{
    QTemporaryDir folder;
    Options options = {.profile = {}, .profilePath = {}, .configDir = config(), .stateDir = state()};

    [[nodiscard]] QString config() const { return folder.filePath(QStringLiteral("config")); }
    [[nodiscard]] QString state() const { return folder.filePath(QStringLiteral("state")); }
    [[nodiscard]] profile::ProfileStore store() const { return profile::ProfileStore(config()); }
    [[nodiscard]] profile::Profile loaded() const { return *profile::loadProfile(options.profilePath); }

    // As the current mount of the store, and the program is started with it.
    void keep(const profile::Profile& profile)
    {
        options.profilePath = *store().add(profile);
        ASSERT_TRUE(store().setCurrent(options.profilePath));
        options.profile = profile;
    }
    void simulate()  // by the command line
    {
        options.simulation = Simulation::Reference;
    }
    // What the program begins with when it is started like this.
    [[nodiscard]] profile::Profile first() const { return ProfileSaver(options).first(); }

    // The saver is gone, and so all is written, when this returns why it was not.
    [[nodiscard]] QString save(const profile::Profile& wanted) const
    {
        QString reason;
        {
            ProfileSaver saver(options);
            note(saver, reason);
            saver.save(wanted);
        }
        return reason;
    }

    // Every file of the real mounts, byte for byte.
    [[nodiscard]] std::map<QString, QByteArray> realFiles() const
    {
        std::map<QString, QByteArray> all;
        QDirIterator files(config(), QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
        while (files.hasNext()) {
            QFile file(files.next());
            EXPECT_TRUE(file.open(QIODevice::ReadOnly));
            all[file.fileName()] = file.readAll();
        }
        return all;
    }
};

// Story: after an Apply on the simulated mount the real one pointed by the simulated north. Level set in the guide with
// --simulate was the real mount's zero at the next start, its ends with it; and a direction confirmed by looking at the
// simulated mount let the real one go as fast as it can.
// REQ-PROFILE-17a
TEST(ProfileSaver, NothingOfASimulationReachesAFileOfARealMount)
{
    Rig rig;
    rig.keep(realMount("Field"));
    rig.keep(realMount());
    const auto before = rig.realFiles();
    rig.simulate();
    profile::Profile wanted = rig.first();
    EXPECT_EQ(wanted, realMount()) << "the mount as it is";
    {
        ProfileSaver saver(rig.options);
        QObject::connect(
            &saver, &ProfileSaver::failed, &saver, [](const QString& text) { ADD_FAILURE() << text.toStdString(); },
            Qt::DirectConnection);
        for (const char* const part : {"", " and again"}) {
            changeAndFindEverything(wanted);
            wanted.mount.name += part;
            saver.save(wanted);
            EXPECT_EQ(saver.next(wanted), wanted) << "a reconnect";
        }
        // Another mount of the list, and nobody looks at its bus.
        profile::Profile field = saver.next(realMount("Field"));
        EXPECT_EQ(field, realMount("Field"));
        changeAndFindEverything(field);
        saver.save(field);
        expectAlike(saver.next(realMount()), wanted);  // back to the first one, as it was left
    }
    EXPECT_EQ(rig.realFiles(), before);
    expectAlike(rig.first(), wanted);  // and so in the next simulation
    const auto copy = profile::loadProfile(rig.state() + QStringLiteral("/simulated/Roof.toml"));
    ASSERT_TRUE(copy) << textOf(copy.error());
    EXPECT_EQ(copy->bus, "simulated")
        << "started with this file, the real mount would have the north of the simulation";
    rig.options.profile = realMount();
    rig.options.simulation = Simulation::Off;
    EXPECT_EQ(rig.first(), realMount());
    EXPECT_EQ(rig.realFiles(), before);
}

// Else the simulation would go on with limits that the mount no longer has.
// REQ-PROFILE-17a
TEST(ProfileSaver, AChangedProfileIsSimulatedAnew)
{
    Rig rig;
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
    // Story: the first change of the new copy overwrote the old one.
    changed.jog.fast = 4_deg_s;
    EXPECT_EQ(rig.save(changed), QString());
    const auto old = profile::loadProfile(rig.state() + QStringLiteral("/simulated/Roof.toml.old"));
    ASSERT_TRUE(old) << textOf(old.error());
    EXPECT_EQ(old->pointing, wanted.pointing);
}

// Two files may have the same mount's name, and so the same file of the simulation.
// REQ-PROFILE-17a
TEST(ProfileSaver, TheSimulationOfAnotherFileIsNotThisOnes)
{
    Rig rig;
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

TEST(ProfileSaver, WhatTheCommandLineSaysIsSimulatedAndNotKept)
{
    Rig rig;
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

// Story: the port of one first start was that of all the following ones.
TEST(ProfileSaver, WhatTheCommandLineSaysAtAFirstStartIsNotKept)
{
    Rig rig;
    rig.options.profile.sensor.source = profile::SensorSource::Simulated;
    rig.options.profile.rotctld.listen.port = 0;
    rig.options.overridden = {"rotctld.listen"};
    EXPECT_EQ(rig.first(), rig.options.profile);
    rig.options.profile.rotctld.listen = profile::Profile{}.rotctld.listen;
    rig.options.overridden.clear();
    EXPECT_EQ(rig.first(), rig.options.profile);
}

// Story: with the adapter chosen in the guide, the server went to another port than --listen says.
TEST(ProfileSaver, WhatTheCommandLineSaysHoldsAlsoWhenTheSimulationIsLeft)
{
    Rig rig;
    rig.options.profile.rotctld.listen.port = 0;
    rig.options.overridden = {"rotctld.listen"};
    ProfileSaver saver(rig.options);
    profile::Profile wanted = saver.first();
    wanted.bus = "socketcan:can0";
    EXPECT_EQ(saver.next(wanted).rotctld.listen.port, 0);
    const auto current = rig.store().findCurrent();
    ASSERT_TRUE(current && *current);
    EXPECT_EQ(profile::loadProfile(**current)->rotctld.listen, profile::Profile{}.rotctld.listen);
}

TEST(ProfileSaver, AFirstStartIsSimulatedAndComesBackAsItWasLeft)
{
    Rig rig;
    rig.options.profile.mount.directions = profile::Directions::Unconfirmed;
    profile::Profile wanted = rig.first();
    EXPECT_EQ(wanted, rig.options.profile);
    wanted.mount.directions = profile::Directions::Confirmed;
    wanted.pointing.azimuthOffset = 37.4_deg;
    EXPECT_EQ(rig.save(wanted), QString());
    EXPECT_TRUE(rig.realFiles().empty());
    EXPECT_EQ(rig.first(), wanted);
}

// Story: the bus chosen in the guide took the simulated mount's north along, and the real one pointed 37.4° beside.
// REQ-PROFILE-17a
TEST(ProfileSaver, ARealBusLeavesTheSimulationBehind)
{
    Rig rig;
    {
        ProfileSaver saver(rig.options);
        profile::Profile wanted = saver.first();
        changeAndFindEverything(wanted);
        saver.save(wanted);
        profile::useBus(wanted, "socketcan:can0", std::array{4, 9});
        wanted.park.azimuth = 20_deg;  // typed together with the bus
        wanted.mount.directions = profile::Directions::Confirmed;
        profile::Profile real;
        real.bus = "socketcan:can0";
        real.mount.directions = profile::Directions::Unconfirmed;
        real.azimuth.id = 4;
        real.elevation.id = 9;
        real.park.azimuth = 20_deg;
        EXPECT_EQ(saver.next(wanted), real);
        const auto current = rig.store().findCurrent();
        ASSERT_TRUE(current && *current);
        EXPECT_EQ(profile::loadProfile(**current), real);
        // From here on it is a mount as any other.
        real.pointing.azimuthOffset = 5_deg;
        saver.save(real);
        EXPECT_EQ(saver.next(real), real);
        EXPECT_EQ(profile::loadProfile(**current), real);
    }
}

// A file of an older version, which kept there what was found of the simulated mount.
// REQ-PROFILE-17a
TEST(ProfileSaver, AFileThatNamesNoRealBusIsSimulatedAndGetsTheBus)
{
    Rig rig;
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
    {
        ProfileSaver saver(rig.options);
        EXPECT_EQ(saver.first(), wanted);
        wanted.bus = "socketcan:can0";
        profile::Profile real;
        real.bus = "socketcan:can0";
        real.mount.directions = profile::Directions::Unconfirmed;
        real.jog.slow = 0.7_deg_s;
        EXPECT_EQ(saver.next(wanted), real);
        EXPECT_EQ(rig.loaded(), real);
    }
}

// Story: a file with a slip of the pen was overwritten with the built-in reference mount.
// REQ-PROFILE-17a
TEST(ProfileSaver, AFileThatCannotBeReadIsNotTakenForARealMounts)
{
    Rig rig;
    rig.keep(profile::Profile{});
    QString reason;
    ProfileSaver saver(rig.options);
    note(saver, reason);
    QFile file(rig.options.profilePath);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("[jog\n");
    file.close();
    const auto before = rig.realFiles();
    const profile::Profile simulated = saver.first();
    profile::Profile wanted = simulated;
    wanted.bus = "socketcan:can0";
    EXPECT_EQ(saver.next(wanted), simulated);
    EXPECT_TRUE(reason.contains(rig.options.profilePath)) << reason.toStdString();
    EXPECT_EQ(rig.realFiles(), before);
}

// Story: the name typed together with the bus was another mount's, and then two files had it.
TEST(ProfileSaver, WithTheNameOfAnotherMountTheSimulationIsNotLeft)
{
    Rig rig;
    rig.keep(realMount("Field"));
    rig.keep(profile::Profile{});
    const auto before = rig.realFiles();
    QString reason;
    ProfileSaver saver(rig.options);
    note(saver, reason);
    const profile::Profile simulated = saver.first();
    profile::Profile wanted = simulated;
    wanted.bus = "socketcan:can0";
    wanted.mount.name = "Field";
    EXPECT_EQ(saver.next(wanted), simulated);
    EXPECT_TRUE(reason.contains(QStringLiteral("there is a mount \"Field\" already"))) << reason.toStdString();
    EXPECT_EQ(rig.realFiles(), before);
}

// Story: what was typed together with the bus was dropped without a word, because it went with the simulation's ends
// only.
TEST(ProfileSaver, WhatDoesNotGoWithTheMountsOwnProfileIsReported)
{
    Rig rig;
    rig.keep(profile::Profile{});
    const auto before = rig.realFiles();
    QString reason;
    ProfileSaver saver(rig.options);
    note(saver, reason);
    profile::Profile simulated = saver.first();
    profile::setTravel(simulated, Axis::Azimuth, {.min = -90_deg, .max = 700_deg});
    saver.save(simulated);
    profile::Profile wanted = simulated;
    wanted.bus = "socketcan:can0";
    wanted.park.azimuth = 600_deg;
    EXPECT_EQ(saver.next(wanted), simulated);
    EXPECT_TRUE(reason.startsWith(QStringLiteral("park."))) << reason.toStdString();
    EXPECT_EQ(rig.realFiles(), before);
}

// Story: switched to, such a mount was the current one, with which the program does not start.
TEST(ProfileSaver, AMountOfTheListThatCannotBeARealOneIsNotConnected)
{
    Rig rig;
    profile::Profile field = realMount("Field");
    field.sensor.source = profile::SensorSource::Simulated;
    rig.keep(field);
    rig.keep(realMount());
    QString reason;
    ProfileSaver saver(rig.options);
    note(saver, reason);
    EXPECT_EQ(saver.next(field), realMount());
    EXPECT_TRUE(reason.startsWith(QStringLiteral("sensor.source: "))) << reason.toStdString();
    EXPECT_EQ(*rig.store().findCurrent(), rig.options.profilePath);
}

// The list is that of the real mounts, and one of them may be switched to.
// REQ-PROFILE-17a
TEST(ProfileSaver, AnotherMountOfTheListLeavesTheSimulationAsItIs)
{
    Rig rig;
    rig.keep(realMount());
    rig.keep(profile::Profile{});
    {
        ProfileSaver saver(rig.options);
        profile::Profile wanted = saver.first();
        wanted.pointing.azimuthOffset = 37.4_deg;
        saver.save(wanted);
        EXPECT_EQ(saver.next(realMount()), realMount());
        EXPECT_EQ(saver.next(profile::Profile{}), wanted) << "and back";
    }
    EXPECT_EQ(rig.loaded(), profile::Profile{});
}

// The file of the simulated mount, started with --bus: the next start would take its north for the simulated one's.
// REQ-PROFILE-17a
TEST(ProfileSaver, WhatIsFoundOfARealMountMakesTheFileItsOwn)
{
    Rig rig;
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

// Story: started with --bus, another adapter was typed in the table: the file had a real bus and the simulated north.
// REQ-PROFILE-17a
TEST(ProfileSaver, AnotherBusMakesTheSimulatedMountsFileARealOnes)
{
    Rig rig;
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

TEST(ProfileSaver, WritesWhatTheOperatorChangedAndNotWhatTheCommandLineOverrode)
{
    Rig rig;
    rig.keep(realMount());
    rig.options.profile.bus = "socketcan:can7";
    profile::Profile wanted = rig.options.profile;
    wanted.jog.slow = 0.7_deg_s;
    EXPECT_EQ(rig.save(wanted), QString());
    EXPECT_EQ(rig.loaded().jog.slow, 0.7_deg_s);
    EXPECT_EQ(rig.loaded().bus, "fdcanusb:/dev/mount");
}

TEST(ProfileSaver, TheFirstChangeWithoutAFileMakesTheFirstMount)
{
    Rig rig;
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

TEST(ProfileSaver, AfterAnotherMountWasConnectedItsFileIsWritten)
{
    Rig rig;
    rig.keep(realMount("Field"));
    const QString fieldFile = rig.options.profilePath;
    rig.keep(realMount());
    {
        ProfileSaver saver(rig.options);
        profile::Profile changed = saver.next(realMount("Field"));
        EXPECT_EQ(changed, realMount("Field"));
        changed.park.azimuth = 77_deg;
        saver.save(changed);
    }
    EXPECT_EQ(profile::loadProfile(fieldFile)->park.azimuth, 77_deg);
    EXPECT_EQ(rig.loaded(), realMount());
    EXPECT_EQ(*rig.store().findCurrent(), fieldFile) << "the next start begins where the operator was";
}

TEST(ProfileSaver, ANewNameMustNotBeAnotherMounts)
{
    Rig rig;
    rig.keep(realMount("Field"));
    rig.keep(realMount());
    profile::Profile renamed = realMount();
    renamed.mount.name = "Field";
    const QString reason = rig.save(renamed);
    EXPECT_TRUE(reason.contains(QStringLiteral("there is a mount \"Field\" already"))) << reason.toStdString();
    EXPECT_EQ(rig.loaded().mount.name, "Roof");
}

TEST(ProfileSaver, SaysWhyItCouldNot)
{
    Rig rig;
    rig.options.profile = realMount();
    rig.options.profilePath = rig.folder.filePath(QStringLiteral("gone.toml"));
    QString reason;
    ProfileSaver saver(rig.options);
    QObject::connect(&saver, &ProfileSaver::failed, [&reason](const QString& text) { reason = text; });
    profile::Profile wanted = realMount();
    wanted.jog.slow = 0.7_deg_s;
    saver.save(wanted);
    ASSERT_TRUE(fakes::waitUntil([&reason] { return !reason.isEmpty(); }));
    EXPECT_TRUE(reason.contains(QStringLiteral("gone.toml"))) << reason.toStdString();
}

}  // namespace
}  // namespace boresight::app
