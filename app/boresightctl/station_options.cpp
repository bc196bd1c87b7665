// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/boresightctl/station_options.h"

#include "app/boresightctl/option_reader.h"
#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/profile/setting.h"

#include <cmath>

namespace boresight::ctl {
namespace {

using Value = std::optional<std::string>;

Result<profile::ListenAddress> parseStation(const Value& value)
{
    const auto address = profile::parseListenAddress(value.value_or(""));
    if (!address || address->port == 0) {
        return failure(ErrorCode::InvalidInput, QStringLiteral("--station: expected HOST:PORT like localhost:4533"));
    }
    return *address;
}

Result<> noOption(const std::string& name)
{
    return failure(ErrorCode::InvalidInput, QStringLiteral("there is no option --%1").arg(toQString(name)));
}

Result<> takeStationOption(const std::string& name, const Value& value, StationOptions& options)
{
    if (name == "station") {
        return parseStation(value).map([&](const profile::ListenAddress& address) { options.station = address; });
    }
    if (name == "format") {
        if (value != "json" && value != "text") {
            return failure(ErrorCode::InvalidInput, QStringLiteral("--format: expected text or json"));
        }
        options.json = *value == "json";
        return {};
    }
    return noOption(name);
}

Result<> takeSatellitesOption(const std::string& name, const Value& value, SatellitesOptions& options)
{
    if (name == "station") {
        return parseStation(value).map([&](const profile::ListenAddress& address) { options.station = address; });
    }
    if (name == "format") {
        const auto format = parseTableFormat(value.value_or(""));
        if (!format) {
            return failure(ErrorCode::InvalidInput, QStringLiteral("--format: expected csv, table or json"));
        }
        options.format = *format;
        return {};
    }
    return noOption(name);
}

Result<Angle> parseAngle(const char* what, const std::string& text, double least, double most)
{
    const std::optional<double> degrees = parseFinite(text);
    if (!degrees) {
        return failure(
            ErrorCode::InvalidInput,
            QStringLiteral("the %1 \"%2\" is not a number of degrees").arg(QLatin1String(what), toQString(text)));
    }
    if (*degrees < least || *degrees > most) {
        return failure(ErrorCode::InvalidInput,
                       QStringLiteral("the %1 %2° is outside %3°…%4°")
                           .arg(QLatin1String(what), toQString(text), QString::number(least), QString::number(most)));
    }
    return Angle::fromDegrees(*degrees);
}

Result<StationOptions> readOptions(Arguments arguments)
{
    StationOptions options;
    while (!arguments.empty()) {
        if (!arguments.front().starts_with("--")) {
            options.places.push_back(arguments.front());
            arguments = arguments.subspan(1);
            continue;
        }
        OptionReader reader(arguments);
        const std::size_t words = arguments.front().find('=') == std::string::npos ? 2 : 1;
        const std::string name = reader.takeName().value_or("");
        if (const auto taken = takeStationOption(name, reader.takeValue(), options); !taken) {
            return tl::unexpected(taken.error());
        }
        arguments = arguments.subspan(words);
    }
    return options;
}

}  // namespace

Result<StationOptions> parseStationOptions(Arguments arguments, std::size_t count)
{
    return readOptions(arguments).and_then([count](StationOptions options) -> Result<StationOptions> {
        if (options.places.size() != count) {
            return failure(ErrorCode::InvalidInput, count == 0 ? QStringLiteral("there are too many arguments")
                                                               : QStringLiteral("write an azimuth and an elevation"));
        }
        return options;
    });
}

Result<StationOptions> parseTrackOptions(Arguments arguments)
{
    return readOptions(arguments).and_then([](StationOptions options) -> Result<StationOptions> {
        if (options.places.empty()) {
            return failure(ErrorCode::InvalidInput, QStringLiteral("name a target"));
        }
        return options;
    });
}

Result<StationOptions> parseConsoleOptions(Arguments arguments)
{
    return readOptions(arguments).and_then([](StationOptions options) -> Result<StationOptions> {
        if (options.places.empty()) {
            return failure(ErrorCode::InvalidInput, QStringLiteral("write the line for the control box"));
        }
        return options;
    });
}

Result<StationOptions> parseAntennaOptions(Arguments arguments)
{
    return readOptions(arguments);
}

Result<SatellitesOptions> parseSatellitesOptions(Arguments arguments)
{
    SatellitesOptions options;
    for (OptionReader reader(arguments); !reader.atEnd();) {
        const Result<> taken = reader.takeName().and_then(
            [&](const std::string& name) { return takeSatellitesOption(name, reader.takeValue(), options); });
        if (!taken) {
            return tl::unexpected(taken.error());
        }
    }
    return options;
}

Result<SkyPointing> parseDirection(const std::string& azimuth, const std::string& elevation)
{
    return parseAngle("azimuth", azimuth, -3600.0, 3600.0).and_then([&](Angle first) {
        return parseAngle("elevation", elevation, -90.0, 180.0).map([&](Angle second) {
            return SkyPointing{.azimuth = first, .elevation = second};
        });
    });
}

}  // namespace boresight::ctl
