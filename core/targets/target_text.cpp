// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/targets/target_text.h"

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/base/trimmed.h"
#include "core/targets/locator.h"
#include "core/units/direction_text.h"

#include <QStringList>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace boresight::targets {
namespace {

constexpr std::size_t kMostNamed = 3;  // matching satellites that a message names
constexpr double kLowest = -1000.0;    // m
constexpr double kHighest = 100'000.0;

// Independent of the locale.
char lower(char character)
{
    return character >= 'A' && character <= 'Z' ? static_cast<char>(character - 'A' + 'a') : character;
}

std::string lowered(std::string_view text)
{
    std::string all(text);
    std::ranges::transform(all, all.begin(), lower);
    return all;
}

// A number like "5.5", "5:30:00" or "-5:30".
std::optional<double> sexagesimal(std::string_view text)
{
    const bool isNegative = text.starts_with('-');
    double value = 0.0;
    double unit = 1.0;
    for (std::string_view rest = isNegative ? text.substr(1) : text;; unit /= 60.0) {
        const std::size_t colon = rest.find(':');
        const std::optional<double> part = parseFinite(rest.substr(0, colon));
        if (!part || *part < 0.0 || (unit < 1.0 && *part >= 60.0) || unit < 1.0 / 3600.0) {
            return {};
        }
        value += unit * *part;
        if (colon == std::string_view::npos) {
            return isNegative ? -value : value;
        }
        rest.remove_prefix(colon + 1);
    }
}

// The numbers of, for example, "38.757,-9.117". A text that is not a number becomes NaN.
std::vector<double> numbersOf(std::string_view text)
{
    std::vector<double> numbers;
    for (;;) {
        const std::size_t comma = text.find(',');
        numbers.push_back(parseFinite(trimmed(text.substr(0, comma))).value_or(std::nan("")));
        if (comma == std::string_view::npos) {
            return numbers;
        }
        text.remove_prefix(comma + 1);
    }
}

bool isWithin(double value, double min, double max)
{
    return value >= min && value <= max;
}

Result<Target> directionTarget(std::string_view text)
{
    const std::vector<double> numbers = numbersOf(text);
    if (numbers.size() != 2 || !isWithin(numbers[0], -360.0, 360.0) || !isWithin(numbers[1], -90.0, 90.0)) {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("A direction is \"azel AZIMUTH,ELEVATION\" in degrees, like \"azel 120.5,30\"."));
    }
    const SkyPointing direction{.azimuth = Angle::fromDegrees(numbers[0]).wrapped360(),
                                .elevation = Angle::fromDegrees(numbers[1])};
    return Target{.name = directionText(direction), .kind = direction};
}

Result<Target> starTarget(std::string_view text)
{
    const auto star = parseStarPlace(text);
    if (!star) {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("A place among the stars is \"radec HOURS,DEGREES\" of J2000, like \"radec "
                                "12:30:49.4,12:23:28\" or \"radec 12.514,12.391\"."));
    }
    return Target{.name = Text::tr("RA %1 h, declination %2")
                              .arg(toQString(formatFixed(star->rightAscension.degrees() / 15.0, 4)),
                                   degreesText(star->declination, 3)),
                  .kind = ephemeris::SkyObject(*star)};
}

Result<Target> placeTarget(std::string_view text)
{
    std::vector<double> numbers = numbersOf(text);
    if (numbers.size() == 2) {
        numbers.push_back(0.0);
    }
    if (numbers.size() != 3 || !isWithin(numbers[0], -90.0, 90.0) || !isWithin(numbers[1], -180.0, 360.0) ||
        !isWithin(numbers[2], kLowest, kHighest)) {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("A position is \"place NORTH,EAST,HEIGHT\" in degrees and metres, like \"place "
                                "38.757,-9.117,1200\". The height may be left out."));
    }
    const Site site{Angle::fromDegrees(numbers[0]), Angle::fromDegrees(numbers[1]), numbers[2]};
    return Target{
        .name = Text::tr("%1 north, %2 east").arg(degreesText(site.latitude, 3), degreesText(site.longitude, 3)),
        .kind = EarthPosition{.site = site}};
}

struct Form
{
    std::string_view word;
    Result<Target> (*read)(std::string_view rest);
};
constexpr std::array kForms{Form{"azel ", directionTarget}, Form{"radec ", starTarget}, Form{"place ", placeTarget}};

// Compares names of objects: "Cas A", "cas-a" and "CAS_A" mean "cas-a", and "sgr a*" means "sgr-a".
std::optional<Target> objectOf(std::string_view small)
{
    std::string key(small);
    std::ranges::replace_if(
        key, [](char c) { return c == ' ' || c == '_'; }, '-');
    std::erase(key, '*');
    const auto objects = ephemeris::namedObjects();
    const auto found = std::ranges::find(objects, key, &ephemeris::NamedObject::key);
    if (found == objects.end()) {
        return std::nullopt;
    }
    return objectTarget(*found);
}

// `text` is in small letters. Every character that is not ASCII counts as a letter.
bool isPartOfWord(std::string_view text, std::size_t at)
{
    const char c = at < text.size() ? text[at] : ' ';
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || static_cast<unsigned char>(c) >= 0x80;
}

// True if `text` has `words` as whole words: "iss" is in "iss (zarya)", but not in "swisscube".
bool hasWords(std::string_view text, std::string_view words)
{
    for (std::size_t at = text.find(words); at != std::string_view::npos; at = text.find(words, at + 1)) {
        if ((at == 0 || !isPartOfWord(text, at - 1)) && !isPartOfWord(text, at + words.size())) {
            return true;
        }
    }
    return false;
}

using Satellites = std::vector<const orbit::ElementSet*>;

// The satellites with this number or name. If there are none: those with these words in their name.
Satellites satellitesOf(std::string_view small, std::span<const orbit::ElementSet> known)
{
    const auto number = parseInteger(small);
    Satellites exact;
    Satellites partly;
    for (const orbit::ElementSet& one : known) {
        const std::string name = lowered(one.name);
        if (number == one.number || name == small) {
            exact.push_back(&one);
        } else if (!number && hasWords(name, small)) {
            partly.push_back(&one);
        }
    }
    return exact.empty() ? partly : exact;
}

QString listed(const Satellites& satellites)
{
    QStringList names;
    for (const orbit::ElementSet* const one : satellites) {
        names << QStringLiteral("%1 (%2)").arg(satelliteTarget(*one).name).arg(one->number);
    }
    return names.mid(0, kMostNamed).join(QStringLiteral(", "));
}

std::optional<Target> locatorTarget(std::string_view text)
{
    constexpr std::string_view kLong = " long";
    const bool isLong = lowered(text).ends_with(kLong);
    const std::string_view locator = trimmed(isLong ? text.substr(0, text.size() - kLong.size()) : text);
    const auto place = fromLocator(locator);
    if (!place) {
        return std::nullopt;
    }
    const QString name = toQString(locator);
    return Target{.name = isLong ? Text::tr("%1, long path").arg(name) : name,
                  .kind = EarthPosition{.site = {.latitude = place->latitude, .longitude = place->longitude},
                                        .path = isLong ? GreatCircle::Long : GreatCircle::Short}};
}

}  // namespace

std::optional<ephemeris::StarPlace> parseStarPlace(std::string_view text)
{
    const std::size_t comma = std::min(text.find(','), text.size());
    const auto hours = sexagesimal(trimmed(text.substr(0, comma)));
    const auto degrees = sexagesimal(trimmed(text.substr(std::min(comma + 1, text.size()))));
    if (!hours || !degrees || !isWithin(*degrees, -90.0, 90.0) || *hours < 0.0 || *hours >= 24.0) {
        return std::nullopt;
    }
    return ephemeris::StarPlace{.rightAscension = Angle::fromDegrees(15.0 * *hours),
                                .declination = Angle::fromDegrees(*degrees)};
}

std::optional<QString> tableFile(std::string_view text)
{
    const std::string_view typed = trimmed(text);
    const std::string small = lowered(typed);
    for (const std::string_view word : {std::string_view("table "), std::string_view("oem ")}) {
        if (small.starts_with(word)) {
            return toQString(trimmed(typed.substr(word.size())));
        }
    }
    return std::nullopt;
}

std::optional<QString> otherRotator(std::string_view text)
{
    const std::string_view typed = trimmed(text);
    return lowered(typed).starts_with("rotctld:") ? std::optional(toQString(typed)) : std::nullopt;
}

Result<Target> parseTarget(std::string_view text, std::span<const orbit::ElementSet> satellites)
{
    const std::string_view typed = trimmed(text);
    const std::string small = lowered(typed);
    for (const Form& form : kForms) {
        if (small.starts_with(form.word)) {
            return form.read(typed.substr(form.word.size()));
        }
    }
    if (const auto object = objectOf(small)) {
        return *object;
    }
    const Satellites found = typed.empty() ? Satellites() : satellitesOf(small, satellites);
    if (found.size() == 1) {
        return satelliteTarget(*found.front());
    }
    if (found.size() > 1) {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("%1 satellites have that name, among them %2. Enter the number.")
                           .arg(found.size())
                           .arg(listed(found)));
    }
    if (const auto place = locatorTarget(typed)) {
        return *place;
    }
    const QString none = satellites.empty()
                             ? QLatin1Char(' ') + Text::tr("Boresight knows no satellites. Add their elements.")
                             : QString();
    return failure(ErrorCode::InvalidInput,
                   Text::tr("\"%1\" is not a known satellite, a body or a locator. The bodies are: %2.")
                           .arg(toQString(typed), toQString(ephemeris::skyObjectKeys())) +
                       none);
}

}  // namespace boresight::targets
