// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/boresightctl/sky_choice.h"
#include "app/boresightctl/sky_time.h"
#include "app/boresightctl/subcommand.h"
#include "app/log_output.h"
#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/elements/text_lines.h"
#include "core/orbit/sgp4.h"
#include "core/orbit/topocentric.h"
#include "core/table_file/table_file.h"
#include "core/tables/table_path.h"

#include <QFile>

#include <chrono>
#include <cstdio>

namespace boresight::ctl {
namespace {

constexpr int kAngleDecimals = 6;
constexpr int kRangeDecimals = 6;
constexpr int kRateDecimals = 9;
constexpr int kDopplerDecimals = 12;  // the same precision as the range rate
constexpr int kBodyDecimals = 3;
constexpr qint64 kMostBytesOfTimes = 16 << 20;  // 16 MiB: 700,000 times
constexpr int kMostBadLines = 100;

struct SkyTimes
{
    std::vector<UtcTime> utcs;
    int badLines = 0;
};

// Reads to the end of the file or up to `most` bytes. A single read() of a pipe returns only what it holds already.
QByteArray upTo(qint64 most, QFile& file)
{
    constexpr qint64 kPiece = 1 << 16;
    QByteArray all;
    for (QByteArray piece = file.read(kPiece); !piece.isEmpty() && all.size() < most; piece = file.read(kPiece)) {
        all += piece;
    }
    return all;
}

Result<QByteArray> bytesOf(const QString& path)
{
    QFile file(path);
    const bool isOpen = path == QStringLiteral("-") ? file.open(stdin, QIODevice::ReadOnly | QIODevice::Unbuffered)
                                                    : file.open(QIODevice::ReadOnly);
    const QByteArray bytes = isOpen ? upTo(kMostBytesOfTimes + 1, file) : QByteArray();
    if (!isOpen || file.error() != QFileDevice::NoError) {
        return failure(ErrorCode::Io, QStringLiteral("%1: %2").arg(path, file.errorString()));
    }
    if (bytes.size() > kMostBytesOfTimes) {
        return failure(ErrorCode::Io, QStringLiteral("%1: the times are more than 16 MB. Split them").arg(path));
    }
    return bytes;
}

// Reads one time per line; a comma and the text after it are ignored. Blank lines, comments that begin with # and a
// line of column names above all times are left out.
SkyTimes timesOf(const QByteArray& bytes, const QString& path)
{
    SkyTimes times;
    orbit::TextLines lines(std::string_view(bytes.data(), static_cast<std::size_t>(bytes.size())));
    bool isFirst = true;
    while (lines.next()) {
        const std::string_view text = orbit::trimmed(lines.line().substr(0, lines.line().find(',')));
        if (text.empty() || text.front() == '#') {
            continue;
        }
        const Result<UtcTime> utc = parseSkyTime(text);
        const bool isName = isFirst && text.find_first_of("0123456789") == std::string_view::npos;
        isFirst = false;
        if (utc) {
            times.utcs.push_back(*utc);
        } else if (!isName) {
            ++times.badLines;
            if (times.badLines <= kMostBadLines) {
                app::printError(QStringLiteral("%1:%2: %3").arg(path).arg(lines.number()).arg(utc.error().text));
            }
        }
    }
    if (times.badLines > kMostBadLines) {
        app::printError(
            QStringLiteral("%1: %2 further lines are not times").arg(path).arg(times.badLines - kMostBadLines));
    }
    return times;
}

using Row = std::vector<std::string>;

Row directionRow(UtcTime utc, const SkyPointing& direction)
{
    return {skyTimeText(utc, 0), formatFixed(direction.azimuth.degrees(), kAngleDecimals),
            formatFixed(direction.elevation.degrees(), kAngleDecimals)};
}

// A time without an answer has a row without numbers, so that row N belongs to time N.
Row emptyRow(UtcTime utc, std::size_t columns)
{
    Row row(columns);
    row[0] = skyTimeText(utc, 0);
    return row;
}

// What is printed for each time.
struct SkyView
{
    const Site& site;
    const std::vector<UtcTime>& utcs;
    ephemeris::Refraction refraction;
    bool doppler;
};

RecordTable satelliteTable(const orbit::ElementSet& set, const SkyView& view, QString& problem)
{
    RecordTable table{
        .columns = {{"t_utc"}, {"az_deg", true}, {"el_deg", true}, {"range_km", true}, {"range_rate_km_s", true}}};
    if (view.doppler) {
        table.columns.push_back({"doppler_factor", true});
    }
    const orbit::Sgp4 orbit(set);
    const orbit::Observer observer(view.site);
    orbit::ResonanceState resonance;
    for (const UtcTime utc : view.utcs) {
        const orbit::JulianDate date = orbit::julianDate(utc);
        const orbit::OrbitResult state = orbit.propagate(date, resonance);
        if (!state) {
            table.rows.push_back(emptyRow(utc, table.columns.size()));
            problem = QStringLiteral("%1 at %2: %3")
                          .arg(satelliteText(set), toQString(skyTimeText(utc, 0)), orbit::describe(state.error()));
            continue;
        }
        const orbit::LookAngles seen = observer.look(groundState(*state, date));
        Row row = directionRow(utc, ephemeris::apparent(seen.direction, view.refraction));
        row.push_back(formatFixed(seen.kilometres, kRangeDecimals));
        row.push_back(formatFixed(seen.kilometresPerSecond, kRateDecimals));
        if (view.doppler) {
            row.push_back(formatFixed(seen.dopplerFactor(), kDopplerDecimals));
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

RecordTable objectTable(const ephemeris::SkyObject& object, const SkyView& view, QString& problem)
{
    static const UtcTime kLast = std::chrono::sys_days(std::chrono::year(2101) / 1 / 1);
    RecordTable table{.columns = {{"t_utc"}, {"az_deg", true}, {"el_deg", true}, {"dist_km", true}}};
    ephemeris::Almanac almanac(view.site);
    for (const UtcTime utc : view.utcs) {
        if (utc >= kLast) {
            table.rows.push_back(emptyRow(utc, table.columns.size()));
            problem = QStringLiteral("%1: The sky is known up to the year 2100").arg(toQString(skyTimeText(utc, 0)));
            continue;
        }
        const ephemeris::SeenObject seen = see(almanac, object, utc);
        Row row = directionRow(utc, ephemeris::apparent(seen.direction, view.refraction));
        row.push_back(seen.kilometres ? formatFixed(*seen.kilometres, kBodyDecimals) : std::string());
        table.rows.push_back(std::move(row));
    }
    return table;
}

RecordTable wayTable(const tables::SharedTable& way, const Site& site, const std::vector<UtcTime>& utcs,
                     QString& problem)
{
    RecordTable table{.columns = {{"t_utc"}, {"az_deg", true}, {"el_deg", true}, {"range_km", true}}};
    tables::TablePath path(way, orbit::Observer(site));
    for (const UtcTime utc : utcs) {
        const auto place = path.at(utc);
        if (!place) {
            table.rows.push_back(emptyRow(utc, table.columns.size()));
            problem = QStringLiteral("%1: %2").arg(toQString(skyTimeText(utc, 0)), place.error().text);
            continue;
        }
        Row row = directionRow(utc, place->direction);
        row.push_back(place->kilometres ? formatFixed(*place->kilometres, kRangeDecimals) : std::string());
        table.rows.push_back(std::move(row));
    }
    return table;
}

ExitStatus printTable(const SkyOptions& options, const Site& site, const SkyTimes& times)
{
    const SkyView view{.site = site, .utcs = times.utcs, .refraction = options.refraction, .doppler = options.doppler};
    QString problem;
    if (options.object) {
        print(objectTable(*options.object, view, problem).text(options.format));
    } else if (!options.table.isEmpty()) {
        const auto way = tables::readTableFile(options.table);
        if (!way) {
            app::printError(way.error().text);
            return kFoundWrong;
        }
        print(wayTable(*way, site, times.utcs, problem).text(options.format));
    } else {
        const auto satellites = chosenSatellites(kEphemerisCommand, options);
        if (satellites.empty()) {
            return kFoundWrong;
        }
        print(satelliteTable(satellites.front(), view, problem).text(options.format));
    }
    if (!problem.isEmpty()) {
        complain(kEphemerisCommand, problem);
    }
    return problem.isEmpty() && times.badLines == 0 ? kDone : kFoundWrong;
}

ExitStatus runEphemeris(Arguments arguments)
{
    const Result<SkyOptions> options = parseEphemerisOptions(arguments);
    if (!options) {
        return usageError(kEphemerisCommand, options.error().text);
    }
    const Result<Site> site = chosenSite(*options);
    if (!site) {
        app::printError(site.error().text);
        return kFoundWrong;
    }
    const Result<QByteArray> bytes = bytesOf(options->times);
    if (!bytes) {
        app::printError(bytes.error().text);
        return kFoundWrong;
    }
    return printTable(*options, *site, timesOf(*bytes, options->times));
}

}  // namespace

const Subcommand kEphemerisCommand{
    .name = "ephemeris",
    .arguments =
        "--elements FILE --norad N | --body NAME | --radec HOURS,DEGREES | --table FILE  --site LAT,LON,ALT --times "
        "FILE|- [--refraction none|light|radio] [--doppler on|off] [--format FORMAT]",
    .summary =
        "Print where a satellite, a body, a radio source or the table of a file stands over a site at given times",
    .details =
        R"(  --elements FILE      element sets: TLE, OMM as JSON, CSV, XML or KVN, or NUMBER.sat of Gpredict. A folder: all files
                       in it. The folder of Gpredict: its satdata. NAME.mod: the satellites of this module of Gpredict. An
                       https address, or celestrak:GROUP: downloaded into the cache, at most every two hours. May be
                       given again. Of several sets of one satellite the newest epoch is used
  --norad N            the number of the satellite in the catalogue of NORAD
  --body NAME          in place of a satellite: sun, moon, mercury, venus, mars, jupiter, saturn, uranus, neptune, or a radio
                       source: cas-a, cyg-a, tau-a, vir-a, sgr-a
  --radec HOURS,DEGREES   in place of a satellite, a place among the stars: right ascension and declination of J2000, each
                       as a number or like 12:30:49.4
  --table FILE         in place of a satellite, the table of a file: each line a time, an azimuth and an elevation, or a
                       CCSDS OEM as KVN or XML. Each error is reported as FILE:LINE: reason
  --site LAT,LON,ALT   degrees north, degrees east, metres above the ellipsoid of WGS-84. Or a NAME.qth of Gpredict
  --times FILE         a time in each line: UTC like 2024-05-10T04:50:02.5Z, or Unix seconds. - is standard input. Text
                       after a comma, blank lines, lines that begin with # and a first line of names are left out
  --refraction none|light|radio   raise the elevation as the air bends light or radio waves, in an ordinary atmosphere
                       (1010 hPa, 10 °C, relative humidity 50 %). Default: none
  --doppler on|off     on: a satellite has a last column doppler_factor. The received frequency is the transmitted
                       frequency times this factor. Default: off
  --format csv|table|json   default: csv

Columns of a satellite: t_utc,az_deg,el_deg,range_km,range_rate_km_s. Of a table: t_utc,az_deg,el_deg,range_km. For all
other targets: t_utc,az_deg,el_deg,dist_km. Radio sources, --radec and tables of directions have no distance.
Azimuth counts from true north through east. Elevation counts from the horizon, without refraction unless --refraction
is given. The rate is above 0 while the satellite recedes. A time outside the elements or the table has a row without
numbers.
Each bad element set and each bad time is reported as FILE:LINE: reason. The others are used.
Exit status: 0 done, 1 a time without a result, a line that is not a time, or no usable element set.

Example:
  boresightctl ephemeris --elements weather.tle --norad 33591 --site 38.757,-9.117,80 --times times.txt
  date -u +%FT%TZ | boresightctl ephemeris --body moon --site 38.757,-9.117,80 --times -
)",
    .run = runEphemeris};

}  // namespace boresight::ctl
