// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/profile_saver.h"

#include "core/profile/commissioning.h"
#include "core/profile/profile_file.h"
#include "core/profile/profile_history.h"
#include "core/profile/profile_store.h"

#include <QEventLoop>
#include <QTemporaryDir>
#include <QTimer>

#include <gtest/gtest.h>

namespace boresight::app {
namespace {

struct Rig
{
    QTemporaryDir folder;
    profile::Profile inForce;
    bool onlySimulated = false;

    [[nodiscard]] QString file() const { return folder.filePath(QStringLiteral("mount.toml")); }

    // The saver is gone, and so all is written, when this returns why it was not, or not all of it.
    QString save(const QString& path, const profile::Profile& wanted) const
    {
        QString reason;
        {
            ProfileSaver saver(folder.path(), path, inForce);
            if (onlySimulated) {
                saver.keepSimulated();
            }
            QObject::connect(
                &saver, &ProfileSaver::failed, &saver, [&](const QString& text) { reason = text; },
                Qt::DirectConnection);
            saver.save(wanted);
        }
        return reason;
    }
};

TEST(ProfileSaver, WritesWhatTheOperatorChangedAndNotWhatTheCommandLineOverrode)
{
    Rig rig;
    rig.onlySimulated = true;
    profile::Profile kept;
    kept.bus = "fdcanusb:/dev/mount";
    ASSERT_TRUE(profile::saveProfile(kept, rig.file()));
    profile::Profile wanted = rig.inForce;  // started with --simulate
    wanted.jog.slow = 0.7_deg_s;
    rig.save(rig.file(), wanted);
    const auto now = profile::loadProfile(rig.file());
    ASSERT_TRUE(now);
    EXPECT_EQ(now->jog.slow, 0.7_deg_s);
    EXPECT_EQ(now->bus, "fdcanusb:/dev/mount");
}

// Story: after an Apply on the simulated mount the real one pointed by the simulated north.
// REQ-PROFILE-17a
TEST(ProfileSaver, WhatWasFoundOfTheSimulatedMountIsNotTheRealOnes)
{
    Rig rig;
    rig.onlySimulated = true;
    profile::Profile kept;
    kept.bus = "fdcanusb:/dev/mount";
    kept.pointing.azimuthOffset = 12_deg;
    ASSERT_TRUE(profile::saveProfile(kept, rig.file()));
    rig.inForce = kept;
    rig.inForce.bus = "simulated";
    profile::Profile wanted = rig.inForce;
    wanted.jog.slow = 0.7_deg_s;
    wanted.pointing.azimuthOffset = 37_deg;
    wanted.sensor.deviation.a1 = 3_deg;
    wanted.sensor.mounting.azimuthOffset = 5_deg;
    const QString reason = rig.save(rig.file(), wanted);
    kept.jog.slow = 0.7_deg_s;
    EXPECT_EQ(kept, *profile::loadProfile(rig.file()));
    EXPECT_TRUE(reason.contains(QStringLiteral("keeps its own bus, motors, zeros and the ends")))
        << reason.toStdString();
    // A mount that is simulated by its own profile keeps what is found of it.
    ASSERT_TRUE(profile::saveProfile(rig.inForce, rig.file()));
    rig.save(rig.file(), wanted);
    EXPECT_EQ(wanted, *profile::loadProfile(rig.file()));
}

// Story: level set in the guide with --simulate was the real mount's zero at the next start, its ends with it; and a
// direction confirmed by looking at the simulated mount let the real one go as fast as it can.
// REQ-PROFILE-17a
TEST(ProfileSaver, ZeroMotorsAndDirectionsOfTheSimulatedMountAreNotTheRealOnes)
{
    Rig rig;
    rig.onlySimulated = true;
    profile::Profile kept;
    kept.bus = "fdcanusb:/dev/mount";
    kept.mount.directions = profile::Directions::Unconfirmed;
    ASSERT_TRUE(profile::saveProfile(kept, rig.file()));
    rig.inForce = kept;
    rig.inForce.bus = "simulated";
    profile::Profile wanted = rig.inForce;
    profile::setReading(wanted, Axis::Elevation, 3_deg, 10_deg, profile::Ends::StayOnTheMount);
    profile::reverse(wanted, Axis::Azimuth, std::nullopt);
    profile::swapMotors(wanted);
    wanted.mount.directions = profile::Directions::Confirmed;
    EXPECT_NE(rig.save(rig.file(), wanted), QString());
    EXPECT_EQ(kept, *profile::loadProfile(rig.file()));
    // Ends that were typed are the real mount's, whichever is connected.
    wanted = rig.inForce;
    profile::setTravel(wanted, Axis::Azimuth, {.min = -10_deg, .max = 270_deg});
    EXPECT_EQ(rig.save(rig.file(), wanted), QString());
    profile::setTravel(kept, Axis::Azimuth, {.min = -10_deg, .max = 270_deg});
    EXPECT_EQ(kept, *profile::loadProfile(rig.file()));
}

// Story: level was set with --simulate, and left out; the end typed afterwards, counted from it, was the real mount's.
TEST(ProfileSaver, EndsCountedFromTheSimulatedZeroAreNotTheRealOnes)
{
    Rig rig;
    rig.onlySimulated = true;
    profile::Profile kept;
    kept.bus = "fdcanusb:/dev/mount";
    ASSERT_TRUE(profile::saveProfile(kept, rig.file()));
    rig.inForce = kept;
    rig.inForce.bus = "simulated";
    profile::setReading(rig.inForce, Axis::Elevation, 3_deg, 10_deg, profile::Ends::KeepTheirNumbers);
    profile::Profile wanted = rig.inForce;
    profile::setTravel(wanted, Axis::Azimuth, {.min = -10_deg, .max = 270_deg});
    profile::setTravel(wanted, Axis::Elevation, {.min = 5_deg, .max = 80_deg});
    EXPECT_NE(rig.save(rig.file(), wanted), QString());
    profile::setTravel(kept, Axis::Azimuth, {.min = -10_deg, .max = 270_deg});
    EXPECT_EQ(kept, *profile::loadProfile(rig.file()));
}

// Story: "Use the sensor" with --simulate failed to save, and the version before was lost.
TEST(ProfileSaver, TheSimulatedSensorIsNotTheRealMounts)
{
    Rig rig;
    rig.onlySimulated = true;
    profile::Profile kept;
    kept.bus = "fdcanusb:/dev/mount";
    ASSERT_TRUE(profile::saveProfile(kept, rig.file()));
    kept.jog.slow = 0.7_deg_s;
    ASSERT_TRUE(profile::saveKeepingPrevious(kept, rig.file()));
    rig.inForce = kept;
    rig.inForce.bus = "simulated";
    profile::Profile wanted = rig.inForce;
    wanted.sensor.source = profile::SensorSource::Simulated;
    const QString reason = rig.save(rig.file(), wanted);
    EXPECT_TRUE(reason.contains(QStringLiteral("until the program ends"))) << reason.toStdString();
    EXPECT_EQ(kept, *profile::loadProfile(rig.file()));
    EXPECT_EQ(profile::loadProfile(profile::previousOf(rig.file()))->jog.slow, profile::Profile{}.jog.slow)
        << "the last change can still be taken back";
    // A real sensor is the profile's, whichever mount it was set with.
    wanted.sensor.source = profile::SensorSource::Mqtt;
    EXPECT_EQ(rig.save(rig.file(), wanted), QString());
    EXPECT_EQ(profile::loadProfile(rig.file())->sensor.source, profile::SensorSource::Mqtt);
}

// Story: with --simulate a real bus was typed for later, and at the next start the real antenna ran at full rate by the
// simulated zero and north.
// REQ-PROFILE-17a
TEST(ProfileSaver, ABusForLaterLeavesTheSimulatedMountInTheFile)
{
    Rig rig;
    rig.onlySimulated = true;
    rig.inForce.pointing.azimuthOffset = 37.4_deg;
    rig.inForce.azimuth.geometry.offset = 5_deg;
    rig.inForce.sensor.deviation.a1 = 3_deg;
    rig.inForce.sensor.source = profile::SensorSource::Simulated;
    const profile::Profile simulated = rig.inForce;
    ASSERT_TRUE(profile::saveProfile(simulated, rig.file()));
    profile::Profile wanted = simulated;
    wanted.bus = "socketcan:can0";
    wanted.sensor.source = profile::SensorSource::None;
    wanted.jog.slow = 0.7_deg_s;
    const QString reason = rig.save(rig.file(), wanted);
    EXPECT_TRUE(reason.contains(QStringLiteral("set back in its file"))) << reason.toStdString();
    profile::Profile real;
    real.bus = "socketcan:can0";
    real.mount.directions = profile::Directions::Unconfirmed;
    real.jog.slow = 0.7_deg_s;
    EXPECT_EQ(real, *profile::loadProfile(rig.file()));
    // What is found until the end is the simulated mount's, and the file is another's.
    rig.inForce = wanted;
    wanted.pointing.azimuthOffset = 12_deg;
    wanted.jog.slow = 0.5_deg_s;
    EXPECT_TRUE(rig.save(rig.file(), wanted).contains(QStringLiteral("until the program ends")));
    real.jog.slow = 0.5_deg_s;
    EXPECT_EQ(real, *profile::loadProfile(rig.file()));
    // The bus is taken back: the file stays the real mount's, and that is told.
    rig.inForce = wanted;
    wanted.bus = "simulated";
    EXPECT_TRUE(rig.save(rig.file(), wanted).contains(QStringLiteral("keeps its own bus")));
    EXPECT_EQ(real, *profile::loadProfile(rig.file()));
}

// REQ-PROFILE-17a
TEST(ProfileSaver, ABusForLaterLeavesTheSimulatedMountInTheFirstFileToo)
{
    Rig rig;
    rig.onlySimulated = true;
    profile::Profile wanted = rig.inForce;
    wanted.bus = "socketcan:can0";
    EXPECT_NE(rig.save({}, wanted), QString());
    const auto current = profile::ProfileStore(rig.folder.path()).findCurrent();
    ASSERT_TRUE(current && *current);
    wanted.mount.directions = profile::Directions::Unconfirmed;
    EXPECT_EQ(wanted, *profile::loadProfile(**current));
}

// Story: with --simulate another adapter was typed, and then Undo: the calibrated mount's file named the simulated bus,
// and all that was found of it was set back when its own was typed again.
// REQ-PROFILE-17a
// REQ-PROFILE-17c
TEST(ProfileSaver, ABusForLaterThatIsTakenBackDoesNotMakeARealMountsFileTheSimulatedOnes)
{
    Rig rig;
    rig.onlySimulated = true;
    profile::Profile kept;
    kept.bus = "socketcan:can0";
    ASSERT_TRUE(profile::saveProfile(kept, rig.file()));
    rig.inForce.pointing.azimuthOffset = 12_deg;
    const profile::Profile simulated = rig.inForce;
    profile::Profile later = simulated;
    later.bus = "socketcan:can1";
    EXPECT_EQ(rig.save(rig.file(), later), QString());
    rig.inForce = later;
    const QString reason = rig.save(rig.file(), simulated);
    kept.bus = "socketcan:can1";
    EXPECT_TRUE(reason.contains(QStringLiteral("keeps its own bus"))) << reason.toStdString();
    EXPECT_EQ(kept, *profile::loadProfile(rig.file()));
}

// The file of the simulated mount, started with --bus: the next start would take its north for the simulated one's.
// REQ-PROFILE-17a
TEST(ProfileSaver, WhatIsFoundOfARealMountMakesTheFileItsOwn)
{
    Rig rig;
    profile::Profile tried;
    tried.pointing = {.azimuthOffset = 37.4_deg, .elevationOffset = 1_deg};
    tried.sensor.source = profile::SensorSource::Simulated;
    ASSERT_TRUE(profile::saveProfile(tried, rig.file()));
    rig.inForce.bus = "fdcanusb:/dev/mount";
    rig.inForce.mount.directions = profile::Directions::Unconfirmed;
    profile::Profile wanted = rig.inForce;
    wanted.jog.slow = 0.7_deg_s;
    EXPECT_EQ(rig.save(rig.file(), wanted), QString());
    tried.jog.slow = 0.7_deg_s;
    EXPECT_EQ(tried, *profile::loadProfile(rig.file())) << "a setting makes it nobody else's";
    rig.inForce = wanted;
    wanted.mount.directions = profile::Directions::Confirmed;
    EXPECT_EQ(rig.save(rig.file(), wanted), QString());
    EXPECT_EQ(wanted, *profile::loadProfile(rig.file()));
    rig.inForce = wanted;
    wanted.pointing.azimuthOffset = 12_deg;
    EXPECT_EQ(rig.save(rig.file(), wanted), QString());
    EXPECT_EQ(wanted, *profile::loadProfile(rig.file()));
}

// Story: started with --bus, another adapter was typed in the table: the file had a real bus and the simulated north.
// REQ-PROFILE-17a
TEST(ProfileSaver, AnotherBusMakesTheSimulatedMountsFileARealOnes)
{
    Rig rig;
    profile::Profile tried;
    tried.pointing.azimuthOffset = 37.4_deg;
    ASSERT_TRUE(profile::saveProfile(tried, rig.file()));
    rig.inForce.bus = "fdcanusb:/dev/mount";
    rig.inForce.mount.directions = profile::Directions::Unconfirmed;
    profile::Profile wanted = rig.inForce;
    wanted.bus = "socketcan:can1";
    EXPECT_EQ(rig.save(rig.file(), wanted), QString());
    EXPECT_EQ(wanted, *profile::loadProfile(rig.file()));
}

// Chosen in the table and not connected yet: what is typed meanwhile is the real mount's.
TEST(ProfileSaver, WhatIsTypedForARealMountBeforeTheReconnectIsKept)
{
    Rig rig;
    ASSERT_TRUE(profile::saveProfile(rig.inForce, rig.file()));
    profile::Profile wanted = rig.inForce;
    wanted.bus = "socketcan:can1";
    wanted.mount.directions = profile::Directions::Unconfirmed;
    {
        ProfileSaver saver(rig.folder.path(), rig.file(), rig.inForce);
        saver.save(wanted);
        wanted.azimuth.id = 7;
        wanted.pointing.azimuthOffset = 12_deg;
        saver.save(wanted);
    }
    EXPECT_EQ(wanted, *profile::loadProfile(rig.file()));
}

// A real mount works on until the reconnect.
TEST(ProfileSaver, TheSimulatedMountThatWasChosenStaysChosen)
{
    Rig rig;
    rig.inForce.bus = "fdcanusb:/dev/mount";
    rig.inForce.pointing.elevationOffset = 1_deg;
    ASSERT_TRUE(profile::saveProfile(rig.inForce, rig.file()));
    profile::Profile wanted = rig.inForce;
    {
        ProfileSaver saver(rig.folder.path(), rig.file(), rig.inForce);
        wanted.bus = "simulated";
        saver.save(wanted);
        wanted.pointing.azimuthOffset = 12_deg;
        saver.save(wanted);
    }
    EXPECT_EQ(wanted, *profile::loadProfile(rig.file()));
}

// The simulated mount is tried for a while, and Undo brings the real one back: only the bus is another on the way.
TEST(ProfileSaver, ARealMountComesBackFromTheSimulatedOneWhole)
{
    Rig rig;
    profile::Profile real = rig.inForce;
    real.bus = "fdcanusb:/dev/mount";
    real.azimuth.geometry.offset = 12_deg;
    real.pointing.azimuthOffset = 37.4_deg;
    real.mount.directions = profile::Directions::Confirmed;
    ASSERT_TRUE(profile::saveProfile(real, rig.file()));
    {
        ProfileSaver saver(rig.folder.path(), rig.file(), real);
        profile::Profile simulated = real;
        simulated.bus = "simulated";
        saver.save(simulated);
        saver.save(real);
    }
    EXPECT_EQ(real, *profile::loadProfile(rig.file()));
}

TEST(ProfileSaver, TheFirstChangeWithoutAFileMakesTheFirstMount)
{
    Rig rig;
    profile::Profile wanted;
    wanted.mount.name = "Roof";
    rig.save({}, wanted);
    const auto current = profile::ProfileStore(rig.folder.path()).findCurrent();
    ASSERT_TRUE(current && *current);
    EXPECT_EQ(profile::loadProfile(**current)->mount.name, "Roof");
}

TEST(ProfileSaver, AfterAnotherMountWasConnectedItsFileIsWritten)
{
    Rig rig;
    const profile::ProfileStore store(rig.folder.path());
    profile::Profile roof;
    roof.mount.name = "Roof";
    profile::Profile field;
    field.mount.name = "Field";
    const auto roofFile = store.add(roof);
    const auto fieldFile = store.add(field);
    ASSERT_TRUE(roofFile && fieldFile);
    {
        ProfileSaver saver(rig.folder.path(), *roofFile, roof);
        saver.follow(field);
        profile::Profile changed = field;
        changed.park.azimuth = 77_deg;
        saver.save(changed);
    }
    EXPECT_EQ(profile::loadProfile(*fieldFile)->park.azimuth, 77_deg);
    EXPECT_EQ(*profile::loadProfile(*roofFile), roof);
    EXPECT_EQ(*store.findCurrent(), fieldFile.value()) << "the next start begins where the operator was";
}

TEST(ProfileSaver, ANewNameMustNotBeAnotherMounts)
{
    Rig rig;
    const profile::ProfileStore store(rig.folder.path());
    profile::Profile roof;
    roof.mount.name = "Roof";
    profile::Profile field;
    field.mount.name = "Field";
    const auto roofFile = store.add(roof);
    ASSERT_TRUE(roofFile && store.add(field));
    QString reason;
    {
        ProfileSaver saver(rig.folder.path(), *roofFile, roof);
        QObject::connect(
            &saver, &ProfileSaver::failed, &saver, [&](const QString& text) { reason = text; }, Qt::DirectConnection);
        profile::Profile renamed = roof;
        renamed.mount.name = "Field";
        saver.save(renamed);
    }
    EXPECT_TRUE(reason.contains(QStringLiteral("there is a mount \"Field\" already"))) << reason.toStdString();
    EXPECT_EQ(profile::loadProfile(*roofFile)->mount.name, "Roof");
}

TEST(ProfileSaver, SaysWhyItCouldNot)
{
    Rig rig;
    ProfileSaver saver(rig.folder.path(), rig.folder.filePath(QStringLiteral("gone.toml")), rig.inForce);
    QEventLoop loop;
    QString reason;
    QObject::connect(&saver, &ProfileSaver::failed, &loop, [&](const QString& text) {
        reason = text;
        loop.quit();
    });
    QTimer::singleShot(5000, &loop, &QEventLoop::quit);
    profile::Profile wanted;
    wanted.jog.slow = 0.7_deg_s;
    saver.save(wanted);
    loop.exec();
    EXPECT_TRUE(reason.contains(QStringLiteral("gone.toml"))) << reason.toStdString();
}

}  // namespace
}  // namespace boresight::app
