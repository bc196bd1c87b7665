// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/azel/azel_text.h"

#include "core/base/numbers.h"
#include "core/base/text.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace boresight::azel {
namespace {

using Fields = std::vector<std::string_view>;

constexpr std::string_view kBlanks = " \t\r";

std::string_view withoutBlanks(std::string_view text)
{
    const std::size_t first = text.find_first_not_of(kBlanks);
    const std::size_t last = text.find_last_not_of(kBlanks);
    return first == std::string_view::npos ? std::string_view() : text.substr(first, last - first + 1);
}

Fields fieldsOf(std::string_view line)
{
    Fields fields;
    for (std::size_t comma = line.find(','); comma != std::string_view::npos; comma = line.find(',')) {
        fields.push_back(withoutBlanks(line.substr(0, comma)));
        line.remove_prefix(comma + 1);
    }
    fields.push_back(withoutBlanks(line));
    return fields;
}

// The lines with a line end. Text after the last line end is left out, because it may be incomplete.
std::vector<Fields> linesOf(std::string_view text)
{
    std::vector<Fields> lines;
    for (std::size_t end = text.find('\n'); end != std::string_view::npos; end = text.find('\n')) {
        lines.push_back(fieldsOf(text.substr(0, end)));
        text.remove_prefix(end + 1);
    }
    return lines;
}

// Only digits, a minus sign and a point. No writer makes exponents.
std::optional<double> plainNumber(std::string_view text)
{
    return text.find_first_not_of("-.0123456789") == std::string_view::npos ? parseFinite(text)
                                                                            : std::optional<double>();
}

std::optional<std::chrono::seconds> timeOfDay(std::string_view text)
{
    constexpr std::array<int, 3> kMost{23, 59, 59};
    if (text.size() != 8 || text[2] != ':' || text[5] != ':') {
        return std::nullopt;
    }
    std::int64_t seconds = 0;
    for (std::size_t i = 0; i < kMost.size(); ++i) {
        const std::string_view digits = text.substr(3 * i, 2);
        const auto number = digits.find_first_not_of("0123456789") == std::string_view::npos
                                ? parseInteger(digits)
                                : std::optional<std::int64_t>();
        if (!number || *number > kMost[i]) {
            return std::nullopt;
        }
        seconds = 60 * seconds + *number;
    }
    return std::chrono::seconds(seconds);
}

// Writers also make 360.0 and -0.0.
std::optional<SkyPointing> direction(std::string_view azimuth, std::string_view elevation)
{
    const auto az = plainNumber(azimuth);
    const auto el = plainNumber(elevation);
    if (!az || !el || *az < 0.0 || *az > 360.0 || *el < -90.0 || *el > 90.0) {
        return std::nullopt;
    }
    const double folded = *az < 360.0 ? *az + 0.0 : 0.0;
    return SkyPointing{.azimuth = Angle::fromDegrees(folded), .elevation = Angle::fromDegrees(*el + 0.0)};
}

// The first line "hh:mm:ss,az,el,NAME" with this name. Early versions of WSJT-X also name the line of their source
// "Sun".
const Fields* placeLine(const std::vector<Fields>& lines, std::string_view name)
{
    const auto found =
        std::ranges::find_if(lines, [&](const Fields& line) { return line.size() == 4 && line.back() == name; });
    return found != lines.end() ? &*found : nullptr;
}

// The line "MHz,…,Doppler" or "MHz,…,Doppler,R".
const Fields* dopplerLine(const std::vector<Fields>& lines)
{
    const auto isDoppler = [](const Fields& line) {
        return line.back() == "Doppler" || (line.size() > 1 && line[line.size() - 2] == "Doppler");
    };
    const auto found = std::ranges::find_if(lines, isDoppler);
    return found != lines.end() ? &*found : nullptr;
}

std::optional<Radio> radioOf(const Fields& doppler)
{
    return doppler.back() == "R"   ? std::optional(Radio::Receives)
           : doppler.back() == "T" ? std::optional(Radio::Transmits)
                                   : std::optional<Radio>();
}

// The numbers are before the name. WSJT-X and older programs have rates between the two Dopplers.
void addDoppler(const Fields& line, AzelText& text)
{
    const auto fields = std::ranges::find(line, "Doppler") - line.begin();
    const auto number = [&](std::ptrdiff_t at) {
        return at < fields ? plainNumber(line[static_cast<std::size_t>(at)]) : std::optional<double>();
    };
    text.megahertz = number(0);
    text.dxDoppler = number(1);
    text.selfDoppler = number(fields == 5 ? 3 : 2);
    text.radio = radioOf(line);
}

Result<> isText(std::string_view text)
{
    if (withoutBlanks(text).empty()) {
        return failure(ErrorCode::NoAnswer, Text::tr("the file is empty"));
    }
    if (text.size() > kLongestAzelText) {
        return failure(ErrorCode::Protocol,
                       Text::tr("The file is not an azel.dat. It is longer than %1 bytes.").arg(kLongestAzelText));
    }
    const bool isPlain = std::ranges::all_of(
        text, [](char one) { return (one >= ' ' && one <= '~') || one == '\n' || one == '\r' || one == '\t'; });
    return isPlain ? Result<>{}
                   : failure(ErrorCode::Protocol,
                             Text::tr("The file is not an azel.dat. It has characters that are not plain text."));
}

tl::unexpected<Error> noMoon(const std::vector<Fields>& lines)
{
    const bool isPair =
        lines.size() == 1 && lines[0].size() == 2 && plainNumber(lines[0][0]) && plainNumber(lines[0][1]);
    return failure(ErrorCode::Protocol, isPair ? Text::tr("the file is from AirScout and has another form")
                                               : Text::tr("The file has no line for the Moon."));
}

}  // namespace

Result<AzelText> readAzelText(std::string_view text)
{
    if (const Result<> plain = isText(text); !plain) {
        return tl::unexpected(plain.error());
    }
    const std::vector<Fields> lines = linesOf(text);
    const Fields* const moon = placeLine(lines, "Moon");
    if (moon == nullptr) {
        return noMoon(lines);
    }
    const Fields* const sun = placeLine(lines, "Sun");
    const Fields* const doppler = dopplerLine(lines);
    if (sun == nullptr || doppler == nullptr) {
        return failure(ErrorCode::NoAnswer,
                       Text::tr("the file is cut: the line of the Sun or of the Doppler is missing"));
    }
    const auto time = timeOfDay(moon->front());
    if (!time) {
        return failure(ErrorCode::Protocol, Text::tr("the time of the Moon cannot be read"));
    }
    if (timeOfDay(sun->front()) != time) {
        return failure(ErrorCode::NoAnswer, Text::tr("The file is half written. Moon and Sun have different times."));
    }
    const auto place = direction((*moon)[1], (*moon)[2]);
    if (!place) {
        return failure(ErrorCode::Protocol, Text::tr("the angles of the Moon cannot be read or are out of range"));
    }
    AzelText read{.timeOfDay = *time, .moon = *place, .sun = direction((*sun)[1], (*sun)[2])};
    addDoppler(*doppler, read);
    return read;
}

}  // namespace boresight::azel
