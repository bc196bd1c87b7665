// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/element_files/element_files.h"

#include "core/base/text.h"
#include "core/element_files/gpredict_module.h"
#include "core/elements/element_reader.h"
#include "core/orbit/sgp4.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

namespace boresight::orbit {

namespace {

constexpr qint64 kMostBytes = kMostElementMegabytes * (qint64(1) << 20);
// A file without any good set is probably not a file of elements and would report a problem for each line.
constexpr std::size_t kMostProblemsWithoutASet = 20;

struct FileSet
{
    ElementSet set;
    QString file;
};

struct FileReading
{
    std::vector<FileSet> sets;
    QStringList problems;
};

// A pipe or a device would block the reader, and so the end of the program.
bool isNoFile(const QString& path)
{
    const QFileInfo there(path);
    return there.exists() && !there.isFile() && !there.isDir();
}

QStringList filesOf(const QString& path, QStringList& problems)
{
    if (isNoFile(path)) {
        problems.append(Text::tr("%1: This is a pipe or a device. Name a file or a folder.").arg(path));
        return {};
    }
    if (path.endsWith(QStringLiteral(".mod"))) {
        const GpredictModule module = readGpredictModule(path);
        problems.append(module.problems);
        return module.files;
    }
    if (!QFileInfo(path).isDir()) {
        return {path};
    }
    const QStringList endings{QStringLiteral("*.tle"), QStringLiteral("*.3le"),  QStringLiteral("*.txt"),
                              QStringLiteral("*.omm"), QStringLiteral("*.json"), QStringLiteral("*.csv"),
                              QStringLiteral("*.xml"), QStringLiteral("*.kvn"),  QStringLiteral("*.sat")};
    // If this is the folder of Gpredict itself, its elements are in the subfolder satdata.
    const QString satdata = path + QStringLiteral("/satdata");
    const QDir folder(QFileInfo(satdata).isDir() ? satdata : path);
    QStringList files;
    for (const QString& name : folder.entryList(endings, QDir::Files, QDir::Name)) {
        files.append(folder.filePath(name));
    }
    if (files.isEmpty()) {
        problems.append(Text::tr("%1: There is no file of elements in this folder.").arg(path));
    }
    return files;
}

void addProblems(const QString& path, const ElementList& list, QStringList& problems)
{
    const std::size_t listed =
        list.sets.empty() ? std::min(kMostProblemsWithoutASet, list.problems.size()) : list.problems.size();
    for (std::size_t i = 0; i < listed; ++i) {
        problems.append(QStringLiteral("%1:%2: %3").arg(path).arg(list.problems[i].line).arg(list.problems[i].reason));
    }
    const std::size_t further = list.furtherProblems + list.problems.size() - listed;
    if (further > 0) {
        problems.append(Text::tr("%1: %2 further problems are not listed.").arg(path).arg(further));
    }
    if (list.sets.empty()) {
        problems.append(Text::tr("%1: There is no element set in this file.").arg(path));
    }
}

void readFile(const QString& path, FileReading& all)
{
    QFile file(path);
    const bool isOpen = file.open(QIODevice::ReadOnly);
    const QByteArray bytes = isOpen ? file.read(kMostBytes + 1) : QByteArray();
    if (!isOpen || file.error() != QFileDevice::NoError) {
        all.problems.append(QStringLiteral("%1: %2").arg(path, file.errorString()));
        return;
    }
    if (bytes.size() > kMostBytes) {
        all.problems.append(
            Text::tr("%1: The file is larger than %2 MB. Split it.").arg(path).arg(kMostElementMegabytes));
        return;
    }
    ElementList list = readElements(std::string_view(bytes.data(), static_cast<std::size_t>(bytes.size())));
    addProblems(path, list, all.problems);
    for (ElementSet& set : list.sets) {
        all.sets.push_back({std::move(set), path});
    }
}

// The distance in km between two sets of one satellite at the epoch of the newer set. 0 if the age of the older set can
// explain the distance: elements become wrong by 1 to 3 km a day, and faster in dense air.
double disagreement(const ElementSet& newer, const ElementSet& older)
{
    constexpr double kPermitted = 100.0;  // km
    const double days = minutesBetween(older.epoch, newer.epoch) / kMinutesPerDay;
    const OrbitResult here = Sgp4(newer).propagate(newer.epoch);
    const OrbitResult there = Sgp4(older).propagate(newer.epoch);
    const double apart = here && there ? length(here->position - there->position) : 0.0;
    return apart > kPermitted * (1.0 + days) * (1.0 + days) ? apart : 0.0;
}

// Among equal epochs the first set wins. A satellite whose sources disagree is reported once.
std::vector<ElementSet> theNewest(std::vector<FileSet> found, QStringList& problems)
{
    const auto isBefore = [](const FileSet& a, const FileSet& b) {
        return a.set.number != b.set.number ? a.set.number < b.set.number
                                            : minutesBetween(a.set.epoch, b.set.epoch) < 0.0;
    };
    std::ranges::stable_sort(found, isBefore);
    std::vector<ElementSet> newest;
    QString file;
    bool isReported = false;
    for (FileSet& one : found) {
        if (newest.empty() || newest.back().number != one.set.number) {
            newest.push_back(std::move(one.set));
            file = one.file;
            isReported = false;
            continue;
        }
        const double apart = isReported ? 0.0 : disagreement(newest.back(), one.set);
        if (apart > 0.0) {
            isReported = true;
            problems.append(Text::tr("%1: This file and %4 place satellite %2 %3 km apart. Boresight uses %4.")
                                .arg(one.file)
                                .arg(one.set.number)
                                .arg(std::llround(apart))
                                .arg(file));
        }
    }
    return newest;
}

}  // namespace

ElementFiles readElementFiles(const QStringList& paths)
{
    FileReading all;
    for (const QString& path : paths) {
        for (const QString& file : filesOf(path, all.problems)) {
            readFile(file, all);
        }
    }
    ElementFiles files;
    files.sets = theNewest(std::move(all.sets), all.problems);
    files.problems = std::move(all.problems);
    return files;
}

}  // namespace boresight::orbit
