// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/diagnostics/bundle.h"

#include "core/profile/profile_file.h"
#include "tests/fakes/text_of.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <algorithm>

namespace boresight::diagnostics {
namespace {

// 2026-11-21T18:17:30Z
const UtcTime kWhen{std::chrono::seconds{1795285050}};

struct Rig
{
    Rig()
    {
        snapshot.stateDir = folder.filePath(QStringLiteral("state"));
        EXPECT_TRUE(QDir().mkpath(snapshot.stateDir));
        profile::Profile inForce;
        inForce.mount.name = "Roof";
        snapshot.applied = inForce;
        snapshot.applied.control.tickHz = 100;
        snapshot.status.profile = std::make_shared<const profile::Profile>(inForce);
        snapshot.status.waitingKeys = {"control.tick_hz"};
        snapshot.status.utc = kWhen;
        snapshot.when = kWhen;
        DriveStatus& drive = snapshot.status.drives.emplace().azimuth;
        drive.id = 1;
        drive.identity = {.uuid = QStringLiteral("0a1b2c3d-0000-0000-0000-000000000001"),
                          .firmware = QStringLiteral("1.1.0"),
                          .registerMap = 5};
        drive.protections.push_back({.key = QStringLiteral("servo.timeout_mode"),
                                     .wanted = QStringLiteral("10"),
                                     .found = QStringLiteral("12"),
                                     .verdict = Verdict::Dangerous});
        drive.crashStop = CrashStop{.drive = drive.identity.uuid,
                                    .rate = 2_deg_s,
                                    .angle = 0.42_deg,
                                    .time = std::chrono::milliseconds(310),
                                    .when = kWhen};
        snapshot.status.alarms.push_back({.what = QStringLiteral("No reply from elevation."),
                                          .remedy = QStringLiteral("Check its cable."),
                                          .since = kWhen});
    }

    void put(const char* name, const QByteArray& bytes) const
    {
        QFile file(snapshot.stateDir + QLatin1Char('/') + QLatin1String(name));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(bytes);
    }
    [[nodiscard]] QString archive() const { return folder.filePath(QStringLiteral("bundle.tar.gz")); }
    // Unpacks the archive with the tar of the system, as its receiver would.
    [[nodiscard]] QDir unpacked() const
    {
        QProcess tar;
        tar.start(QStringLiteral("tar"), {QStringLiteral("-xzf"), archive(), QStringLiteral("-C"), folder.path()});
        EXPECT_TRUE(tar.waitForFinished());
        EXPECT_EQ(tar.exitCode(), 0) << tar.readAllStandardError().toStdString();
        return QDir(folder.filePath(QStringLiteral("boresight-20261121T181730Z")));
    }
    [[nodiscard]] static QByteArray read(const QDir& dir, const char* name)
    {
        QFile file(dir.filePath(QLatin1String(name)));
        EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << name;
        return file.readAll();
    }

    QTemporaryDir folder;
    Snapshot snapshot;
};

// REQ-DIAGNOSTICS-01: The archive is a .tar.gz with one folder, and `tar` unpacks it. Its README.txt names and
// describes every file.
TEST(DiagnosticsBundle, IsUnpackedByTarAndTellsWhatEachFileIs)
{
    Rig rig;
    rig.put("events.log", "2026-11-21T18:17:00.000Z station: every drive answers\n");
    ASSERT_TRUE(writeBundle(rig.archive(), collect(rig.snapshot), kWhen));
    const QDir dir = rig.unpacked();
    const QByteArray readme = Rig::read(dir, "README.txt");
    EXPECT_TRUE(readme.contains("2026-11-21T18:17:30Z (UTC)"));
    const QStringList files = dir.entryList(QDir::Files);
    EXPECT_GE(files.size(), 7);
    for (const QString& file : files) {
        EXPECT_TRUE(file == QLatin1String("README.txt") || readme.contains('\n' + file.toUtf8() + "\n    "))
            << file.toStdString();
    }
    EXPECT_EQ(proposedName(kWhen), QStringLiteral("boresight-20261121T181730Z.tar.gz"));
}

// REQ-DIAGNOSTICS-02: The archive holds: versions of program, Qt, kernel and drive firmware, the drive configuration as
// read, crash-stop tests, the profile in effect and the one that waits, state, clients and alarms, logs, the position
// journal, the time in UTC.
TEST(DiagnosticsBundle, HasWhatABugReportNeeds)
{
    Rig rig;
    rig.put("events.log", "the log\n");
    rig.put("events.log.1", "the older log\n");
    rig.put("Roof.memory.json", "{\"journal\": 1}");
    rig.snapshot.status.azimuth.starts = MotorStarts{.lastMinute = 7, .total = 132, .coast = 1_deg};
    ASSERT_TRUE(writeBundle(rig.archive(), collect(rig.snapshot), kWhen));
    const QDir dir = rig.unpacked();
    EXPECT_EQ(Rig::read(dir, "events.log"), "the log\n");
    EXPECT_EQ(Rig::read(dir, "events.log.1"), "the older log\n");
    EXPECT_EQ(Rig::read(dir, "Roof.memory.json"), "{\"journal\": 1}");
    EXPECT_EQ(*profile::loadProfile(dir.filePath(QStringLiteral("profile.toml"))), *rig.snapshot.status.profile);
    EXPECT_EQ(*profile::loadProfile(dir.filePath(QStringLiteral("profile-waiting.toml"))), rig.snapshot.applied);
    const QByteArray versions = Rig::read(dir, "versions.txt");
    for (const char* const part : {"Boresight " BORESIGHT_VERSION, "Qt 6.", "kernel: linux ", "firmware 1.1.0",
                                   "elevation drive: id 0, firmware unknown", "libarchive"}) {
        EXPECT_TRUE(versions.contains(part)) << part << " in\n" << versions.toStdString();
    }
    const QByteArray drives = Rig::read(dir, "drives.txt");
    EXPECT_TRUE(drives.contains("UNSAFE  servo.timeout_mode  found 12  wanted 10")) << drives.toStdString();
    EXPECT_TRUE(drives.contains("stopped from 2.00°/s after 0.42° and 310 ms")) << drives.toStdString();
    const QByteArray station = Rig::read(dir, "station.txt");
    EXPECT_TRUE(station.contains(": No reply from elevation. Check its cable.\n"));
    EXPECT_TRUE(
        station.contains("azimuth motor: 7 starts in the last minute, 132 since the mount was connected, coasts "
                         "1.000°\n"))
        << station.toStdString();
    EXPECT_FALSE(station.contains("elevation motor"));
}

// This holds for every file in the archive.
// REQ-DIAGNOSTICS-03: The archive holds no passwords.
TEST(DiagnosticsBundle, HasNoPasswords)
{
    Rig rig;
    rig.snapshot.applied.mqtt.user = "mount";
    rig.snapshot.applied.mqtt.password = "s3cret";
    rig.snapshot.status.profile = std::make_shared<const profile::Profile>(rig.snapshot.applied);
    const auto files = collect(rig.snapshot);
    for (const BundleFile& one : files) {
        EXPECT_FALSE(one.file.bytes.contains("s3cret")) << one.file.name.toStdString();
    }
    const auto shown =
        std::ranges::find(files, QStringLiteral("profile.toml"), [](const BundleFile& one) { return one.file.name; });
    ASSERT_NE(shown, files.end());
    EXPECT_TRUE(shown->file.bytes.contains("password = \"(hidden)\"\n"));
}

// REQ-DIAGNOSTICS-04: A state folder without files, or with an unreadable file, does not prevent the archive.
TEST(DiagnosticsBundle, AMissingLogIsLeftOutAndAnUnreadableOneIsTold)
{
    Rig rig;
    // a folder cannot be read as a file
    ASSERT_TRUE(QDir().mkpath(rig.snapshot.stateDir + QStringLiteral("/events.log")));
    ASSERT_TRUE(writeBundle(rig.archive(), collect(rig.snapshot), kWhen));
    const QDir dir = rig.unpacked();
    EXPECT_TRUE(Rig::read(dir, "events.log").startsWith("could not be read: "));
    EXPECT_FALSE(dir.exists(QStringLiteral("events.log.1")));
}

// REQ-DIAGNOSTICS-05: A place that cannot be written to is reported with path and reason. An existing file stays.
TEST(DiagnosticsBundle, AnUnwritablePlaceIsToldAndLeavesWhatWasThere)
{
    Rig rig;
    const QString nowhere = rig.folder.filePath(QStringLiteral("none/bundle.tar.gz"));
    const auto written = writeBundle(nowhere, collect(rig.snapshot), kWhen);
    ASSERT_FALSE(written);
    EXPECT_EQ(textOf(written.error()), nowhere.toStdString() + ": No such file or directory");
    ASSERT_TRUE(QDir().mkpath(rig.archive()));
    EXPECT_FALSE(writeBundle(rig.archive(), collect(rig.snapshot), kWhen));
    EXPECT_TRUE(QDir(rig.archive()).exists());
}

}  // namespace
}  // namespace boresight::diagnostics
