// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/boresightctl/sky_options.h"

#include "app/boresightctl/option_reader.h"
#include "app/boresightctl/sky_time.h"
#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/elements/element_address.h"
#include "core/elements/element_set.h"
#include "core/targets/target_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace boresight::ctl {
namespace {

constexpr double kMostDays = 3660.0;

tl::unexpected<Error> expected(std::string_view name, const std::string& text, const QString& what)
{
    return failure(
        ErrorCode::InvalidInput,
        QStringLiteral("--%1 \"%2\": expected %3").arg(toQString(name), toQString(text.substr(0, 60)), what));
}

Result<> takeSite(const std::string& text, SkyOptions& options)
{
    const bool isFile = text.ends_with(".qth");
    options.site.reset();
    options.siteFile = isFile ? toQString(text) : QString();
    if (isFile) {
        return {};
    }
    std::vector<double> numbers;
    for (std::string_view rest = text;;) {
        const std::size_t comma = rest.find(',');
        numbers.push_back(parseFinite(rest.substr(0, comma)).value_or(std::nan("")));
        if (comma == std::string_view::npos) {
            break;
        }
        rest.remove_prefix(comma + 1);
    }
    const auto isWithin = [&](std::size_t i, double min, double max) { return numbers[i] >= min && numbers[i] <= max; };
    if (numbers.size() != 3 || !isWithin(0, -90.0, 90.0) || !isWithin(1, -180.0, 360.0) ||
        !isWithin(2, -1000.0, 100000.0)) {
        return expected(
            "site", text,
            QStringLiteral(
                "LAT,LON,ALT (degrees north -90…90, degrees east -180…360, metres -1000…100000), or FILE.qth"));
    }
    options.site = {Angle::fromDegrees(numbers[0]), Angle::fromDegrees(numbers[1]), numbers[2]};
    return {};
}

Result<> takeElements(const std::string& text, SkyOptions& options)
{
    options.elements.push_back(text);
    if (const auto address = orbit::parseElementAddress(text); orbit::isElementAddress(text) && !address) {
        return failure(address.error().code, QStringLiteral("--elements: ") + address.error().text);
    }
    return {};
}

Result<> takeNumber(const std::string& text, SkyOptions& options)
{
    options.number = parseInteger(text);
    return options.number && *options.number >= 0 && *options.number <= orbit::kLargestNumber
               ? Result<>()
               : expected("norad", text, QStringLiteral("a catalogue number, 0…999999999"));
}

Result<> takeBody(const std::string& text, SkyOptions& options)
{
    options.object = ephemeris::skyObject(text);
    return options.object
               ? Result<>()
               : expected("body", text, QStringLiteral("one of %1").arg(toQString(ephemeris::skyObjectKeys())));
}

Result<> takeRaDec(const std::string& text, SkyOptions& options)
{
    const auto star = targets::parseStarPlace(text);
    if (!star) {
        return expected("radec", text,
                        QStringLiteral("HOURS,DEGREES of J2000 like 12:30:49.4,12:23:28 or 12.514,12.391"));
    }
    options.object = *star;
    return {};
}

Result<> takeFormat(const std::string& text, SkyOptions& options)
{
    const auto format = parseTableFormat(text);
    if (!format) {
        return expected("format", text, QStringLiteral("csv, table or json"));
    }
    options.format = *format;
    return {};
}

Result<> takeRefraction(const std::string& text, SkyOptions& options)
{
    constexpr std::array<std::string_view, 3> kNames{"none", "light", "radio"};  // in the order of the values
    const auto name = std::ranges::find(kNames, text);
    if (name == kNames.end()) {
        return expected("refraction", text, QStringLiteral("none, light or radio"));
    }
    options.refraction = static_cast<ephemeris::Refraction>(name - kNames.begin());
    return {};
}

Result<> takeSwitch(std::string_view name, const std::string& text, bool& isOn)
{
    if (text != "on" && text != "off") {
        return expected(name, text, QStringLiteral("on or off"));
    }
    isOn = text == "on";
    return {};
}

Result<> takeFrom(const std::string& text, SkyOptions& options)
{
    if (text == "now") {
        options.from = SystemClock().utc();
        return {};
    }
    const auto utc = parseSkyTime(text);
    if (!utc) {
        return failure(utc.error().code, QStringLiteral("--from ") + utc.error().text);
    }
    options.from = *utc;
    return {};
}

Result<> takeDays(const std::string& text, SkyOptions& options)
{
    options.days = parseFinite(text);
    return options.days && *options.days > 0.0 && *options.days <= kMostDays
               ? Result<>()
               : expected("days", text, QStringLiteral("a number above 0, up to 3660"));
}

Result<> takeMinimumElevation(const std::string& text, SkyOptions& options)
{
    const auto degrees = parseFinite(text);
    if (!degrees || std::abs(*degrees) >= 90.0) {
        return expected("min-el", text, QStringLiteral("degrees above -90 and below 90"));
    }
    options.minimumElevation = Angle::fromDegrees(*degrees);
    return {};
}

Result<> takeBound(const std::string& text, SkyOptions& options)
{
    const auto degrees = parseFinite(text);
    if (!degrees || *degrees <= 0.0 || *degrees > 180.0) {
        return expected("bound", text, QStringLiteral("degrees above 0, up to 180"));
    }
    options.bound = Angle::fromDegrees(*degrees);
    return {};
}

struct SkyOption
{
    std::string_view name;
    Result<> (*take)(const std::string& text, SkyOptions& options);
};

constexpr SkyOption kElements{"elements", takeElements};
constexpr SkyOption kTimes{"times", [](const std::string& text, SkyOptions& options) {
                               options.times = toQString(text);
                               return Result<>();
                           }};
constexpr SkyOption kTable{"table", [](const std::string& text, SkyOptions& options) {
                               options.table = toQString(text);
                               return Result<>();
                           }};
constexpr SkyOption kNorad{"norad", takeNumber};
constexpr SkyOption kSite{"site", takeSite};
constexpr SkyOption kFormat{"format", takeFormat};
constexpr std::array kEphemerisOptions{
    kElements,
    kNorad,
    kSite,
    kTimes,
    SkyOption{"body", takeBody},
    SkyOption{"radec", takeRaDec},
    kTable,
    SkyOption{"refraction", takeRefraction},
    SkyOption{"doppler", [](const std::string& text,
                            SkyOptions& options) { return takeSwitch("doppler", text, options.doppler); }},
    kFormat};
constexpr SkyOption kFrom{"from", takeFrom};
constexpr SkyOption kProfile{"profile", [](const std::string& text, SkyOptions& options) {
                                 options.profileFile = toQString(text);
                                 return Result<>();
                             }};
constexpr std::array kPassesOptions{
    kElements,
    kNorad,
    kSite,
    kFrom,
    SkyOption{"days", takeDays},
    SkyOption{"min-el", takeMinimumElevation},
    kProfile,
    SkyOption{"seen",
              [](const std::string& text, SkyOptions& options) { return takeSwitch("seen", text, options.seen); }},
    kFormat};
constexpr std::array kPlanOptions{
    kProfile,
    kElements,
    kNorad,
    kFrom,
    SkyOption{"bound", takeBound},
    SkyOption{"motion",
              [](const std::string& text, SkyOptions& options) { return takeSwitch("motion", text, options.motion); }},
    kFormat};

Result<SkyOptions> read(Arguments arguments, std::span<const SkyOption> permitted)
{
    SkyOptions options;
    for (OptionReader reader(arguments); !reader.atEnd();) {
        const Result<std::string> name = reader.takeName();
        if (!name) {
            return tl::unexpected(name.error());
        }
        const auto option = std::ranges::find(permitted, *name, &SkyOption::name);
        if (option == permitted.end()) {
            return failure(ErrorCode::InvalidInput, QStringLiteral("there is no option --%1").arg(toQString(*name)));
        }
        const std::string value = reader.takeValue().value_or("");
        if (value.empty()) {
            return failure(ErrorCode::InvalidInput, QStringLiteral("--%1 needs a value").arg(toQString(*name)));
        }
        if (const Result<> taken = option->take(value, options); !taken) {
            return tl::unexpected(taken.error());
        }
    }
    return options;
}

bool hasSite(const SkyOptions& options)
{
    return options.site || !options.siteFile.isEmpty();
}

Result<SkyOptions> complete(SkyOptions options, const QString& missing)
{
    if (!missing.isEmpty()) {
        return failure(ErrorCode::InvalidInput, QStringLiteral("%1 is missing").arg(missing));
    }
    return options;
}

}  // namespace

Result<SkyOptions> parseEphemerisOptions(Arguments arguments)
{
    const auto check = [](SkyOptions options) -> Result<SkyOptions> {
        if (options.object && (options.number || !options.elements.empty())) {
            return failure(
                ErrorCode::InvalidInput,
                QStringLiteral(
                    "--body and --radec need no elements: use only --body, only --radec, or --elements with --norad"));
        }
        if (!options.table.isEmpty() && (options.object || options.number || !options.elements.empty())) {
            return failure(ErrorCode::InvalidInput,
                           QStringLiteral("--table is used alone: leave out --elements, --norad, --body and --radec"));
        }
        const bool isSatellite = !options.object && options.table.isEmpty();
        if (options.doppler && !isSatellite) {
            return failure(ErrorCode::InvalidInput,
                           QStringLiteral("--doppler needs a satellite: add --elements and --norad"));
        }
        const QString missing = isSatellite && options.elements.empty() ? QStringLiteral("--elements FILE")
                                : isSatellite && !options.number        ? QStringLiteral("--norad N")
                                : !hasSite(options)                     ? QStringLiteral("--site LAT,LON,ALT")
                                : options.times.isEmpty()               ? QStringLiteral("--times FILE")
                                                                        : QString();
        return complete(std::move(options), missing);
    };
    return read(arguments, kEphemerisOptions).and_then(check);
}

Result<SkyOptions> parsePassesOptions(Arguments arguments)
{
    const auto check = [](SkyOptions options) -> Result<SkyOptions> {
        if (options.seen && options.profileFile.isEmpty()) {
            return failure(ErrorCode::InvalidInput, QStringLiteral("--seen needs a mount: add --profile FILE"));
        }
        const QString missing = options.elements.empty() ? QStringLiteral("--elements FILE")
                                : !hasSite(options)      ? QStringLiteral("--site LAT,LON,ALT")
                                : !options.from          ? QStringLiteral("--from UTC")
                                : !options.days          ? QStringLiteral("--days D")
                                                         : QString();
        return complete(std::move(options), missing);
    };
    return read(arguments, kPassesOptions).and_then(check);
}

Result<SkyOptions> parsePlanOptions(Arguments arguments)
{
    const auto check = [](SkyOptions options) -> Result<SkyOptions> {
        const QString missing = options.profileFile.isEmpty() ? QStringLiteral("--profile FILE")
                                : options.elements.empty()    ? QStringLiteral("--elements FILE")
                                : !options.number             ? QStringLiteral("--norad N")
                                : !options.from               ? QStringLiteral("--from UTC")
                                                              : QString();
        return complete(std::move(options), missing);
    };
    return read(arguments, kPlanOptions).and_then(check);
}

}  // namespace boresight::ctl
