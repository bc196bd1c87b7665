// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/profile/horizon_text.h"

#include "core/base/control_characters.h"
#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/pointing/skyline.h"
#include "core/profile/setting.h"

#include <QStringList>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace boresight::profile {

namespace {

constexpr std::size_t kErrorsTold = 20;  // a file of another kind may have an error in every line

struct Numbers
{
    double azimuth = 0.0;
    double elevation = 0.0;
};

std::vector<std::string> split(std::string_view text, std::string_view separators)
{
    std::vector<std::string> parts;
    for (std::size_t start = 0; start < text.size();) {
        const std::size_t end = std::min(text.find_first_of(separators, start), text.size());
        if (end > start) {
            parts.emplace_back(text.substr(start, end - start));
        }
        start = end + 1;
    }
    return parts;
}

std::optional<double> numberOf(std::string text)
{
    std::ranges::replace(text, ',', '.');
    return parseFinite(text);
}

std::optional<Numbers> numbersOf(const std::string& line)
{
    std::vector<std::string> parts = split(line, " \t;");
    if (parts.size() == 1) {
        parts = split(parts.front(), ",");
    } else if (parts.size() == 3 && parts[1] == ",") {
        parts.erase(parts.begin() + 1);
    }
    if (parts.size() != 2) {
        return std::nullopt;
    }
    if (parts[0].ends_with(',')) {
        parts[0].pop_back();
    } else if (parts[1].starts_with(',')) {
        parts[1].erase(0, 1);
    }
    const auto azimuth = numberOf(parts[0]);
    const auto elevation = numberOf(parts[1]);
    return azimuth && elevation ? std::optional(Numbers{*azimuth, *elevation}) : std::nullopt;
}

bool isHeading(const std::string& line)
{
    return line.find_first_of("0123456789") == std::string::npos;
}

QString whatIsWrong(const Numbers& numbers)
{
    if (numbers.azimuth < 0.0 || numbers.azimuth > 360.0) {
        return Text::tr("azimuths count from north, 0…360");
    }
    return std::abs(numbers.elevation) > 90.0 ? Text::tr("an elevation is within -90…90") : QString();
}

class HorizonReader
{
public:
    explicit HorizonReader(QString fileName) : m_fileName(std::move(fileName)) {}

    void readLine(std::string line)
    {
        ++m_lineNumber;
        line.erase(std::min(line.find('#'), line.size()));
        line.erase(line.find_last_not_of(" \t\r") + 1);
        if (line.empty()) {
            return;
        }
        const bool isFirst = !m_hasContent;
        m_hasContent = true;
        if (const auto numbers = numbersOf(line)) {
            take(*numbers);
        } else if (!isFirst || !isHeading(line)) {
            constexpr std::size_t kShown = 40;
            addError(Text::tr("azimuth and elevation are expected, like \"120.5 7\", not \"%1\"")
                         .arg(toQString(line.substr(0, kShown))));
        }
    }

    [[nodiscard]] Result<HorizonText> result()
    {
        if (m_errorCount > kErrorsTold) {
            m_errors << Text::tr("… and %1 more").arg(m_errorCount - kErrorsTold);
        }
        if (m_errorCount > 0) {
            return failure(ErrorCode::InvalidInput, m_errors.join(u'\n'));
        }
        if (m_highest.empty() || m_highest.size() > kMaxHorizonPoints) {
            return failure(ErrorCode::InvalidInput,
                           Text::tr("%1: %2 points. A horizon has 1 to %3 points")
                               .arg(m_fileName, QString::number(m_highest.size()), QString::number(kMaxHorizonPoints)));
        }
        HorizonText text{.points = {}, .merged = m_merged};
        for (const auto& [azimuth, elevation] : m_highest) {
            text.points.push_back({Angle::fromDegrees(azimuth), Angle::fromDegrees(elevation)});
        }
        return text;
    }

private:
    void take(const Numbers& numbers)
    {
        if (const QString wrong = whatIsWrong(numbers); !wrong.isEmpty()) {
            return addError(wrong);
        }
        constexpr double kPerDegree = 1e6;  // a profile has no azimuth above 359.999999°
        const double azimuth = std::round(numbers.azimuth * kPerDegree) / kPerDegree;
        const auto [point, isNew] = m_highest.emplace(azimuth < 360.0 ? azimuth : 0.0, numbers.elevation);
        if (!isNew && point->second != numbers.elevation) {
            point->second = std::max(point->second, numbers.elevation);
            ++m_merged;
        }
    }

    void addError(const QString& reason)
    {
        if (++m_errorCount <= kErrorsTold) {
            m_errors << QStringLiteral("%1:%2: %3").arg(m_fileName, QString::number(m_lineNumber), printable(reason));
        }
    }

    QString m_fileName;
    std::size_t m_lineNumber = 0;
    bool m_hasContent = false;
    std::map<double, double> m_highest;  // elevation by azimuth
    int m_merged = 0;
    QStringList m_errors;
    std::size_t m_errorCount = 0;
};

std::string line(double azimuth, double elevation)
{
    return toText(azimuth) + " " + toText(elevation) + "\n";
}

}  // namespace

Result<HorizonText> parseHorizon(std::string_view text, const QString& fileName)
{
    constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
    if (text.starts_with(kByteOrderMark)) {
        text.remove_prefix(kByteOrderMark.size());
    }
    HorizonReader reader(fileName);
    for (std::size_t start = 0; start < text.size();) {
        const std::size_t end = std::min(text.find('\n', start), text.size());
        reader.readLine(std::string(text.substr(start, end - start)));
        start = end + 1;
    }
    return reader.result();
}

std::string toHorizonText(const std::vector<pointing::HorizonPoint>& horizon, const std::string& mountName)
{
    std::string text = "# Horizon of " + printable(mountName) +
                       ": azimuth from north, elevation, in degrees; straight lines between\n";
    if (horizon.empty()) {
        return text;
    }
    const double north = pointing::Skyline(horizon).at(Angle{}).degrees();
    if (horizon.front().azimuth > Angle{}) {
        text += line(0.0, north);
    }
    for (const pointing::HorizonPoint& point : horizon) {
        text += line(point.azimuth.degrees(), point.elevation.degrees());
    }
    return text + line(360.0, north);
}

}  // namespace boresight::profile
