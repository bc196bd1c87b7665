// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gpredict/gpredict_satellites.h"

#include "core/base/numbers.h"
#include "core/base/trimmed.h"
#include "core/gpredict/key_file.h"
#include "core/profile/small_file.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>
#include <cmath>

namespace boresight::profile {

namespace {

constexpr int kFirstYearOfTheCentury = 57;  // year of Sputnik: 57 to 99 are 19xx
constexpr std::size_t kYearColumn = 18;     // from 0
constexpr std::size_t kDayColumn = 20;
constexpr std::size_t kDayColumns = 12;

}  // namespace

std::optional<UtcTime> elementEpoch(std::string_view line)
{
    if (line.size() < kDayColumn + kDayColumns || line.front() != '1') {
        return std::nullopt;
    }
    const auto shortYear = parseFinite(trimmed(line.substr(kYearColumn, 2)));
    const auto day = parseFinite(trimmed(line.substr(kDayColumn, kDayColumns)));
    if (!shortYear || *shortYear < 0.0 || *shortYear != std::floor(*shortYear) || !day || *day < 1.0 || *day >= 367.0) {
        return std::nullopt;
    }
    const int year = static_cast<int>(*shortYear) + (*shortYear < kFirstYearOfTheCentury ? 2000 : 1900);
    const std::chrono::sys_days newYear = std::chrono::year(year) / std::chrono::January / 1;
    const std::chrono::duration<double, std::chrono::days::period> since(*day - 1.0);
    return UtcTime(newYear) + std::chrono::round<UtcTime::duration>(since);
}

GpredictSatellites findGpredictSatellites(const QString& folder)
{
    GpredictSatellites found{.folder = folder + QStringLiteral("/satdata")};
    for (const QFileInfo& file : QDir(found.folder).entryInfoList({QStringLiteral("*.sat")}, QDir::Files)) {
        ++found.files;
        const auto text = readFile(file.filePath());
        const auto line =
            text ? keyFileValue(*text, QStringLiteral("Satellite"), QStringLiteral("TLE1")) : std::nullopt;
        const auto epoch = line ? elementEpoch(line->toStdString()) : std::nullopt;
        found.newest = std::max(found.newest, epoch);  // an empty optional is less than any time
    }
    return found;
}

}  // namespace boresight::profile
