// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/azel/azel_feed.h"
#include "core/ephemeris/almanac.h"

#include <QDateTime>

#include <optional>

// Writes azel.dat as WSJT-X does, for a station at `site`.
namespace boresight::fakes {

class AzelWriter
{
public:
    explicit AzelWriter(const Site& site) : m_almanac(site) {}

    [[nodiscard]] SkyPointing moon(UtcTime utc) { return m_almanac.place(ephemeris::Body::Moon, utc).direction; }

    [[nodiscard]] QByteArray textAt(UtcTime utc)
    {
        const UtcTime second = std::chrono::floor<std::chrono::seconds>(utc);
        return line(second, moon(second), "Moon") +
               line(second, m_almanac.place(ephemeris::Body::Sun, second).direction, "Sun") +
               line(second, {}, "Source") + " 1296,  2189.0,   -4.41,  1625.0,   -9.79,Doppler" + flag + "\n";
    }

    [[nodiscard]] azel::AzelReading readingAt(UtcTime utc)
    {
        return {.path = QStringLiteral("/wsjtx/azel.dat"),
                .text = azel::readAzelText(textAt(utc).toStdString()),
                .written = utc};
    }

    QByteArray flag = ", R";
    std::optional<SkyPointing> moonInstead = {};  // as computed for another locator

private:
    [[nodiscard]] QByteArray line(UtcTime utc, const SkyPointing& place, const char* name) const
    {
        const bool isMoon = qstrcmp(name, "Moon") == 0;
        const SkyPointing shown = isMoon ? moonInstead.value_or(place) : place;
        const auto time = std::chrono::floor<std::chrono::seconds>(utc.time_since_epoch()).count();
        return QDateTime::fromSecsSinceEpoch(time, Qt::UTC).toString(QStringLiteral("HH:mm:ss")).toLatin1() + "," +
               QByteArray::number(shown.azimuth.degrees(), 'f', 1).rightJustified(5) + "," +
               QByteArray::number(shown.elevation.degrees(), 'f', 1).rightJustified(5) + "," + name + "\n";
    }

    ephemeris::Almanac m_almanac;
};

}  // namespace boresight::fakes
