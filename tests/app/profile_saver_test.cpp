// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/profile_saver.h"

#include "core/profile/profile_file.h"
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

    [[nodiscard]] QString file() const { return folder.filePath(QStringLiteral("mount.toml")); }

    // The saver is gone, and so all is written, when this returns.
    void save(const QString& path, const profile::Profile& wanted) const
    {
        ProfileSaver saver(folder.path(), path, inForce);
        saver.save(wanted);
    }
};

TEST(ProfileSaver, WritesWhatTheOperatorChangedAndNotWhatTheCommandLineOverrode)
{
    Rig rig;
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
TEST(ProfileSaver, WhatWasFoundOfTheSimulatedMountIsNotTheRealOnes)
{
    Rig rig;
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
    QString reason;
    {
        ProfileSaver saver(rig.folder.path(), rig.file(), rig.inForce);
        QObject::connect(
            &saver, &ProfileSaver::failed, &saver, [&](const QString& text) { reason = text; }, Qt::DirectConnection);
        saver.save(wanted);
    }
    kept.jog.slow = 0.7_deg_s;
    EXPECT_EQ(kept, *profile::loadProfile(rig.file()));
    EXPECT_TRUE(reason.contains(QStringLiteral("keeps its own north"))) << reason.toStdString();
    // A mount that is simulated by its own profile keeps what is found of it.
    ASSERT_TRUE(profile::saveProfile(rig.inForce, rig.file()));
    rig.save(rig.file(), wanted);
    EXPECT_EQ(wanted, *profile::loadProfile(rig.file()));
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
