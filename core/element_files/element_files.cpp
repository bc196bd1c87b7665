// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/element_files/element_files.h"

#include "core/base/text.h"
#include "core/elements/element_reader.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <string_view>

namespace boresight::orbit {

namespace {

constexpr qint64 kMegabyte = 1 << 20;
constexpr qint64 kMostMegabytes = 64;  // 30,000 satellites as JSON: 15 MB

QStringList filesOf(const QString& path)
{
    if (!QFileInfo(path).isDir()) {
        return {path};
    }
    const QStringList endings{QStringLiteral("*.tle"), QStringLiteral("*.3le"),  QStringLiteral("*.txt"),
                              QStringLiteral("*.omm"), QStringLiteral("*.json"), QStringLiteral("*.csv"),
                              QStringLiteral("*.xml"), QStringLiteral("*.kvn")};
    QStringList files;
    for (const QString& name : QDir(path).entryList(endings, QDir::Files, QDir::Name)) {
        files.append(QDir(path).filePath(name));
    }
    return files;
}

void readFile(const QString& path, ElementFiles& all)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        all.problems.append(QStringLiteral("%1: %2").arg(path, file.errorString()));
        return;
    }
    const QByteArray bytes = file.read(kMostMegabytes * kMegabyte + 1);
    if (file.error() != QFileDevice::NoError) {
        all.problems.append(QStringLiteral("%1: %2").arg(path, file.errorString()));
        return;
    }
    if (bytes.size() > kMostMegabytes * kMegabyte) {
        all.problems.append(Text::tr("%1: The file is larger than %2 MB.").arg(path).arg(kMostMegabytes));
        return;
    }
    ElementList list = readElements(std::string_view(bytes.data(), static_cast<std::size_t>(bytes.size())));
    for (const ElementProblem& problem : list.problems) {
        all.problems.append(QStringLiteral("%1:%2: %3").arg(path).arg(problem.line).arg(problem.reason));
    }
    if (list.furtherProblems > 0) {
        all.problems.append(Text::tr("%1: %2 further problems are not listed.").arg(path).arg(list.furtherProblems));
    }
    if (list.sets.empty() && list.problems.empty()) {
        all.problems.append(Text::tr("%1: There is no element set in this file.").arg(path));
    }
    std::ranges::move(list.sets, std::back_inserter(all.sets));
}

// The first of them if the epochs are the same.
void keepTheNewest(std::vector<ElementSet>& sets)
{
    const auto isBefore = [](const ElementSet& a, const ElementSet& b) {
        return a.number != b.number ? a.number < b.number : minutesBetween(a.epoch, b.epoch) < 0.0;
    };
    std::ranges::stable_sort(sets, isBefore);
    const auto rest = std::ranges::unique(sets, {}, &ElementSet::number);
    sets.erase(rest.begin(), rest.end());
}

}  // namespace

ElementFiles readElementFiles(const QStringList& paths)
{
    ElementFiles all;
    for (const QString& path : paths) {
        const QStringList files = filesOf(path);
        if (files.isEmpty()) {
            all.problems.append(Text::tr("%1: There is no file of elements in this folder.").arg(path));
        }
        for (const QString& file : files) {
            readFile(file, all);
        }
    }
    keepTheNewest(all.sets);
    return all;
}

}  // namespace boresight::orbit
