// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/profile/profile_store.h"

#include "core/base/file_name.h"
#include "core/base/text.h"
#include "core/profile/profile_file.h"
#include "core/profile/profile_history.h"
#include "core/profile/small_file.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <cstdio>

namespace boresight::profile {

namespace {

const QString kToml = QStringLiteral(".toml");

QString firstLine(const Result<QByteArray>& bytes)
{
    return bytes ? QString::fromUtf8(*bytes).section(QLatin1Char('\n'), 0, 0).trimmed() : QString();
}

// Replaces an existing `to` in one step. QFile::rename refuses to replace a file.
bool renameOver(const QString& from, const QString& to)
{
    return std::rename(QFile::encodeName(from).constData(), QFile::encodeName(to).constData()) == 0;
}

}  // namespace

ProfileStore::ProfileStore(const QString& folder) : m_folder(folder), m_profiles(folder + QStringLiteral("/profiles"))
{}

std::vector<StoredProfile> ProfileStore::list() const
{
    const QString current = firstLine(readFile(currentFile()));
    std::vector<StoredProfile> all;
    const auto files = QDir(m_profiles).entryInfoList({QLatin1Char('*') + kToml}, QDir::Files, QDir::Name);
    for (const QFileInfo& file : files) {
        StoredProfile stored{.path = file.filePath(),
                             .mountName = file.completeBaseName(),
                             .isCurrent = file.fileName() == current || files.size() == 1,
                             .problem = {}};
        if (const auto profile = loadProfile(stored.path)) {
            stored.mountName = QString::fromStdString(profile->mount.name);
        } else {
            stored.problem = profile.error().text;
        }
        all.push_back(stored);
    }
    std::ranges::stable_sort(
        all, [](const QString& a, const QString& b) { return QString::compare(a, b, Qt::CaseInsensitive) < 0; },
        &StoredProfile::mountName);
    return all;
}

Result<std::optional<QString>> ProfileStore::findCurrent() const
{
    const QString single = m_folder + QStringLiteral("/profile.toml");
    if (QFileInfo::exists(single)) {
        return takeIn(single).map([](const QString& path) { return std::optional(path); });
    }
    const std::vector<StoredProfile> all = list();
    const auto current = std::ranges::find(all, true, &StoredProfile::isCurrent);
    if (current != all.end()) {
        return current->path;
    }
    if (all.empty()) {
        return std::nullopt;
    }
    return failure(ErrorCode::InvalidInput,
                   Text::tr("%1 has several profiles, and %2 names none of them. Choose one with --profile.")
                       .arg(m_profiles, currentFile()));
}

Result<> ProfileStore::setCurrent(const QString& path) const
{
    return checkIsMine(path).and_then(
        [&] { return writeFile(currentFile(), QFileInfo(path).fileName().toUtf8() + '\n'); });
}

Result<QString> ProfileStore::add(const Profile& profile) const
{
    return checkNameIsFree(profile.mount.name, {}).and_then([&]() -> Result<QString> {
        if (!QDir().mkpath(m_profiles)) {
            return failure(ErrorCode::Io, Text::tr("%1: The folder cannot be created.").arg(m_profiles));
        }
        const QString path = freePath(QString::fromStdString(profile.mount.name));
        return saveProfile(profile, path).map([&] { return path; });
    });
}

Result<QString> ProfileStore::duplicate(const QString& path, const QString& newMountName) const
{
    return loadProfile(path).and_then([&](Profile profile) {
        profile.mount.name = newMountName.toStdString();
        return add(profile);
    });
}

Result<QString> ProfileStore::importFile(const QString& source) const
{
    return loadProfile(source).and_then([&](const Profile& profile) { return add(profile); });
}

Result<> ProfileStore::save(const Profile& profile, const QString& path) const
{
    return checkNameIsFree(profile.mount.name, path).and_then([&] { return saveKeepingPrevious(profile, path); });
}

Result<> ProfileStore::exportFile(const QString& path, const QString& target) const
{
    return readFile(path).and_then([&](const QByteArray& bytes) { return writeFile(target, bytes, readersOf(path)); });
}

Result<Profile> ProfileStore::undo(const QString& path) const
{
    return loadProfile(previousOf(path))
        .and_then([&](const Profile& previous) { return checkNameIsFree(previous.mount.name, path); })
        .and_then([&] { return undoLastChange(path); });
}

Result<> ProfileStore::remove(const QString& path) const
{
    if (const auto isMine = checkIsMine(path); !isMine) {
        return isMine;
    }
    for (const StoredProfile& stored : list()) {
        if (stored.isCurrent && QFileInfo(stored.path) == QFileInfo(path)) {
            return failure(
                ErrorCode::Refused,
                Text::tr("\"%1\" is the mount in use. Switch to another mount first.").arg(stored.mountName));
        }
    }
    QString kept = path + QStringLiteral(".removed");
    for (int number = 2; QFileInfo::exists(kept); ++number) {
        kept = path + QStringLiteral(".removed%1").arg(number);
    }
    if (!QFile::rename(path, kept)) {
        return failure(ErrorCode::Io, Text::tr("%1: cannot be renamed to %2").arg(path, kept));
    }
    // Without this, another mount that later gets this file name would take FILE~ for its own previous version.
    QFile::rename(previousOf(path), previousOf(kept));
    return {};
}

QString ProfileStore::currentFile() const
{
    return m_profiles + QStringLiteral("/current");
}

// The position journal of the mount has a file of the same name. A file of this name can exist although no mount has
// this name: a renamed mount keeps its old file.
QString ProfileStore::freePath(const QString& mountName) const
{
    const QString base = m_profiles + QLatin1Char('/') + safeFileName(mountName);
    QString path = base + kToml;
    for (int number = 2; QFileInfo::exists(path); ++number) {
        path = base + QStringLiteral("-%1").arg(number) + kToml;
    }
    return path;
}

Result<> ProfileStore::checkIsMine(const QString& path) const
{
    const QFileInfo file(path);
    if (!file.isFile() || file.suffix() != QLatin1String("toml") || QFileInfo(file.path()) != QFileInfo(m_profiles)) {
        return failure(ErrorCode::NoDevice, Text::tr("%1: there is no such profile").arg(path));
    }
    return {};
}

Result<> ProfileStore::checkNameIsFree(const std::string& mountName, const QString& ownPath) const
{
    for (const StoredProfile& stored : list()) {
        const bool isOwn = !ownPath.isEmpty() && QFileInfo(stored.path) == QFileInfo(ownPath);
        if (!isOwn && stored.problem.isEmpty() && stored.mountName.toStdString() == mountName) {
            return failure(ErrorCode::Refused,
                           Text::tr("A mount \"%1\" already exists (%2). Give this mount another name.")
                               .arg(toQString(mountName), stored.path));
        }
    }
    return {};
}

Result<QString> ProfileStore::takeIn(const QString& single) const
{
    return loadProfile(single).and_then([&](const Profile& profile) -> Result<QString> {
        const QString name = QString::fromStdString(profile.mount.name);
        const std::vector<StoredProfile> all = list();
        const auto known = std::ranges::find(all, name, &StoredProfile::mountName);
        QDir().mkpath(m_profiles);
        const QString path = known != all.end() ? known->path : freePath(name);
        const Result<> kept = known == all.end() ? Result<>{} : readFile(path).and_then([&](const QByteArray& bytes) {
            return writeFile(previousOf(path), bytes, readersOf(path));
        });
        if (!kept || !renameOver(single, path)) {
            return single;  // if the folder cannot be written to, the file is used where it is
        }
        return setCurrent(path).map([&] { return path; });
    });
}

}  // namespace boresight::profile
