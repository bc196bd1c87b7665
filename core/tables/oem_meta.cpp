// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tables/oem_meta.h"

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/base/trimmed.h"
#include "core/elements/element_check.h"
#include "core/elements/iso_epoch.h"
#include "core/tables/row_polynomial.h"

#include <algorithm>
#include <utility>

namespace boresight::tables {
namespace {

constexpr std::array<std::string_view, 12> kMetaKeys{
    "OBJECT_NAME", "OBJECT_ID",          "CENTER_NAME",       "REF_FRAME", "REF_FRAME_EPOCH", "TIME_SYSTEM",
    "START_TIME",  "USEABLE_START_TIME", "USEABLE_STOP_TIME", "STOP_TIME", "INTERPOLATION",   "INTERPOLATION_DEGREE"};
constexpr int kUsualDegree = 7;  // error below a metre for low orbits with one row per minute

// GRC and TDR turn with the true equator and Greenwich. This is ITRF without polar motion.
constexpr std::array kFrames{std::pair{"EFG", OrbitFrame::Earth},       std::pair{"ECEF", OrbitFrame::Earth},
                             std::pair{"GRC", OrbitFrame::Earth},       std::pair{"TDR", OrbitFrame::Earth},
                             std::pair{"WGS84", OrbitFrame::Earth},     std::pair{"WGS-84", OrbitFrame::Earth},
                             std::pair{"GTOD", OrbitFrame::Earth},      std::pair{"EME2000", OrbitFrame::Celestial},
                             std::pair{"J2000", OrbitFrame::Celestial}, std::pair{"GCRF", OrbitFrame::Celestial},
                             std::pair{"ICRF", OrbitFrame::Celestial},  std::pair{"TEME", OrbitFrame::Teme},
                             std::pair{"TEMEOFDATE", OrbitFrame::Teme}, std::pair{"TOD", OrbitFrame::OfDate}};

tl::unexpected<Error> badMeta(const QString& reason)
{
    return failure(ErrorCode::InvalidInput, reason);
}

std::size_t indexOf(std::string_view key)
{
    return static_cast<std::size_t>(std::ranges::find(kMetaKeys, key) - kMetaKeys.begin());
}

std::string capital(std::string_view text)
{
    std::string all(text);
    std::ranges::transform(all, all.begin(),
                           [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
    return all;
}

}  // namespace

std::optional<OemEntry> oemEntry(std::string_view line)
{
    const std::size_t equals = line.find('=');
    if (equals == std::string_view::npos) {
        return std::nullopt;
    }
    return OemEntry{.key = trimmed(line.substr(0, equals)), .value = trimmed(line.substr(equals + 1))};
}

Result<> OemMeta::take(std::string_view line)
{
    const auto entry = oemEntry(line);
    if (!entry) {
        return badMeta(Text::tr("\"%1\" is not a line of the form KEY = value.").arg(orbit::quoted(line)));
    }
    const std::size_t index = indexOf(entry->key);
    if (index == kKeys) {
        return badMeta(Text::tr("The key \"%1\" is not one of an OEM.").arg(orbit::quoted(entry->key)));
    }
    if (m_values[index]) {
        return badMeta(Text::tr("The file has the key %1 twice in one segment.").arg(toQString(entry->key)));
    }
    m_values[index] = std::string(entry->value);
    return {};
}

std::string_view OemMeta::value(std::string_view key) const
{
    const auto& found = m_values[indexOf(key)];
    return found ? std::string_view(*found) : std::string_view();
}

TimeSystem OemMeta::timeSystem() const
{
    return tables::timeSystem(value("TIME_SYSTEM")).value_or(TimeSystem::Utc);
}

Result<> OemMeta::isComplete() const
{
    for (const char* const key : {"OBJECT_NAME", "CENTER_NAME", "REF_FRAME", "TIME_SYSTEM"}) {
        if (value(key).empty()) {
            return badMeta(Text::tr("The key %1 is missing above.").arg(QLatin1String(key)));
        }
    }
    if (capital(value("CENTER_NAME")) != "EARTH") {
        return badMeta(Text::tr("The centre is \"%1\". Boresight reads only orbits with CENTER_NAME = EARTH.")
                           .arg(orbit::quoted(value("CENTER_NAME"))));
    }
    if (!tables::timeSystem(value("TIME_SYSTEM"))) {
        return badMeta(Text::tr("The time system is \"%1\". Boresight reads UTC, TAI, GPS and TT.")
                           .arg(orbit::quoted(value("TIME_SYSTEM"))));
    }
    return {};
}

// A frame of a fixed epoch differs from file to file, so it is not supported.
Result<OrbitFrame> OemMeta::frame() const
{
    const std::string name = capital(value("REF_FRAME"));
    const auto* const found = std::ranges::find_if(kFrames, [&](const auto& one) { return name == one.first; });
    if (found == kFrames.end() && !name.starts_with("ITRF")) {
        return badMeta(Text::tr("The frame is \"%1\". Boresight reads ITRF, EME2000, GCRF, ICRF, TEME and TOD.")
                           .arg(orbit::quoted(value("REF_FRAME"))));
    }
    const OrbitFrame frame = found == kFrames.end() ? OrbitFrame::Earth : found->second;
    if ((frame == OrbitFrame::Teme || frame == OrbitFrame::OfDate) && !value("REF_FRAME_EPOCH").empty()) {
        return badMeta(
            Text::tr("The frame %1 has the fixed date REF_FRAME_EPOCH. Boresight reads this frame only with the "
                     "date of each row. Use GCRF.")
                .arg(toQString(name)));
    }
    return frame;
}

Result<AtomicTime> OemMeta::time(std::string_view key, AtomicTime otherwise) const
{
    if (value(key).empty()) {
        return otherwise;
    }
    const auto date = orbit::parseIsoEpoch(value(key));
    if (!date) {
        return badMeta(Text::tr("%1 is \"%2\". It must be a time like 2024-05-10T04:50:02.5.")
                           .arg(toQString(key), orbit::quoted(value(key))));
    }
    return atomicTime(*date, timeSystem());
}

Result<> OemMeta::setDegree(OrbitSegment& segment) const
{
    const std::string method = capital(value("INTERPOLATION"));
    const std::string_view written = value("INTERPOLATION_DEGREE");
    const auto given = written.empty() ? std::optional<std::int64_t>(kUsualDegree) : parseInteger(written);
    if (!given || *given < 1 || *given > kMostDegree) {
        return badMeta(Text::tr("INTERPOLATION_DEGREE is \"%1\". It must be a number from 1 to %2.")
                           .arg(orbit::quoted(written))
                           .arg(kMostDegree));
    }
    const auto degree = static_cast<std::size_t>(*given);
    if (method.empty() || method == "HERMITE") {
        segment.usesVelocities = true;
        segment.nodes = std::max<std::size_t>((degree + 2) / 2, 2);
    } else if (method == "LAGRANGE") {
        segment.usesVelocities = false;
        segment.nodes = degree + 1;
    } else if (method == "LINEAR") {
        segment.usesVelocities = false;
        segment.nodes = 2;
    } else {
        return badMeta(Text::tr("INTERPOLATION is \"%1\". Boresight supports HERMITE, LAGRANGE and LINEAR.")
                           .arg(orbit::quoted(value("INTERPOLATION"))));
    }
    return {};
}

Result<OrbitSegment> OemMeta::segment() const
{
    OrbitSegment segment;
    const auto setTime = [&](AtomicTime& member, std::string_view key, AtomicTime otherwise) {
        return time(key, otherwise).map([&](AtomicTime read) { member = read; });
    };
    return isComplete()
        .and_then([&] { return frame(); })
        .map([&](OrbitFrame read) { segment.frame = read; })
        .and_then([&] { return setTime(segment.from, "START_TIME", AtomicTime::min()); })
        .and_then([&] { return setTime(segment.to, "STOP_TIME", AtomicTime::max()); })
        .and_then([&] { return setTime(segment.from, "USEABLE_START_TIME", segment.from); })
        .and_then([&] { return setTime(segment.to, "USEABLE_STOP_TIME", segment.to); })
        .and_then([&] { return setDegree(segment); })
        .map([&] { return segment; });
}

}  // namespace boresight::tables
