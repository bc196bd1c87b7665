// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/diagnostics/bundle.h"

#include "core/base/file_name.h"
#include "core/base/version.h"
#include "core/diagnostics/report.h"
#include "core/profile/profile_file.h"
#include "core/profile/setting.h"

#include <QFile>
#include <QFileInfo>

namespace boresight::diagnostics {

namespace {

QString compact(UtcTime when)
{
    return utcText(when).remove(QLatin1Char('-')).remove(QLatin1Char(':'));
}

void addText(std::vector<BundleFile>& files, const QString& name, const QString& text, const QString& about)
{
    files.push_back({.file = {.name = name, .bytes = text.toUtf8()}, .about = about});
}

// A file that exists but cannot be read is mentioned.
void addFile(std::vector<BundleFile>& files, const QString& path, const QString& about)
{
    QFile file(path);
    const QString name = QFileInfo(path).fileName();
    if (file.open(QIODevice::ReadOnly)) {
        files.push_back({.file = {.name = name, .bytes = file.readAll()}, .about = about});
    } else if (file.exists()) {
        addText(files, name, QStringLiteral("could not be read: %1\n").arg(file.errorString()), about);
    }
}

QString profileText(const profile::Profile& profile)
{
    return QString::fromStdString(profile::toToml(profile::withoutSecrets(profile)));
}

QString readme(const std::vector<BundleFile>& files, UtcTime when)
{
    QString text =
        QStringLiteral(
            "Diagnostics of Boresight %1, saved %2 (UTC).\n\nSend this archive with a bug report. It contains no "
            "passwords. The logs name the\naddresses of the rotctld clients. The profile has the site of the mount. "
            "Check the\nfiles before you send them. Add what happened, and what you expected.\n\n")
            .arg(QString::fromUtf8(kVersion.data(), int(kVersion.size())), utcText(when));
    for (const BundleFile& one : files) {
        text += QStringLiteral("%1\n    %2\n").arg(one.file.name, one.about);
    }
    return text;
}

}  // namespace

QString proposedName(UtcTime when)
{
    return QStringLiteral("boresight-%1.tar.gz").arg(compact(when));
}

std::vector<BundleFile> collect(const Snapshot& snapshot)
{
    std::vector<BundleFile> files;
    const profile::Profile& inForce = *snapshot.status.profile;
    addText(files, QStringLiteral("versions.txt"), versionsText(snapshot.status),
            QStringLiteral("Versions of the program, its libraries, the system and the drives' firmware."));
    addText(files, QStringLiteral("station.txt"), stationText(snapshot.status),
            QStringLiteral("State of the station, its axes, clients and alarms."));
    addText(files, QStringLiteral("drives.txt"), drivesText(snapshot.status),
            QStringLiteral("Settings of the drives as the drive check read them, and the last crash-stop tests."));
    addText(files, QStringLiteral("profile.toml"), profileText(inForce),
            QStringLiteral("The settings of the mount that were in force."));
    if (!snapshot.status.waitingKeys.empty()) {
        addText(files, QStringLiteral("profile-waiting.toml"), profileText(snapshot.applied),
                QStringLiteral("The settings of the mount, with those that wait for a reconnect."));
    }
    const QString folder = snapshot.stateDir + QLatin1Char('/');
    const QString memory =
        folder + safeFileName(QString::fromStdString(inForce.mount.name)) + QStringLiteral(".memory.json");
    addFile(files, memory, QStringLiteral("The position journal and the results of the crash-stop tests."));
    addFile(files, memory + QStringLiteral(".previous"),
            QStringLiteral("The previous version of the position journal."));
    addFile(files, folder + QStringLiteral("events.log"), QStringLiteral("The log, times in UTC."));
    addFile(files, folder + QStringLiteral("events.log.1"), QStringLiteral("The log before events.log began."));
    return files;
}

Result<> writeBundle(const QString& path, const std::vector<BundleFile>& files, UtcTime when)
{
    const QString folder = QStringLiteral("boresight-%1/").arg(compact(when));
    std::vector<ArchiveFile> all{{folder + QStringLiteral("README.txt"), readme(files, when).toUtf8()}};
    for (const BundleFile& one : files) {
        all.push_back({folder + one.file.name, one.file.bytes});
    }
    return writeArchive(path, all, when);
}

}  // namespace boresight::diagnostics
