// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/udp_server/pst_words.h"

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/base/trimmed.h"
#include "core/base/upper.h"
#include "core/rotctld/client_angles.h"
#include "core/rotctld/client_habits.h"
#include "core/udp_server/tagged_text.h"

#include <algorithm>
#include <array>
#include <set>

namespace boresight::udp {
namespace {

struct Question
{
    std::string_view text;
    std::string_view answer;
    Ask ask;
};
constexpr std::array kQuestions{Question{"AZ?", "AZ:", Ask::Azimuth}, Question{"EL?", "EL:", Ask::Elevation},
                                Question{"TGA?", "TGA:", Ask::TargetAzimuth}};

// The command of all fields of a datagram together.
struct Wanted
{
    Target target;
    bool parks = false;
};

tl::unexpected<Error> noPst()
{
    return failure(ErrorCode::InvalidInput, Text::tr("This is no datagram for PstRotator."));
}

// "<STOP>1</STOP>" anywhere. Each byte is looked at once, however long the datagram is.
bool hasStop(std::string_view text)
{
    constexpr std::string_view kBegin = "<STOP>";
    constexpr std::string_view kEnd = "</STOP>";
    for (std::size_t at = text.find(kBegin); at != std::string_view::npos; at = text.find(kBegin)) {
        text.remove_prefix(at + kBegin.size());
        const std::string_view value = text.substr(0, text.find('<'));
        if (trimmed(value) == "1" && text.substr(value.size()).starts_with(kEnd)) {
            return true;
        }
    }
    return false;
}

// Hamlib 4.6 sends "85.000000.2" for 85°, with a decimal comma in some locales.
std::string_view withoutHamlibsEnd(std::string_view number)
{
    constexpr std::string_view kEnd = ".2";
    constexpr std::size_t kDecimals = 6;
    const std::size_t point = number.find_first_of(".,");
    const bool isHamlibs = point != std::string_view::npos && number.ends_with(kEnd) &&
                           number.size() == point + 1 + kDecimals + kEnd.size();
    return isHamlibs ? number.substr(0, number.size() - kEnd.size()) : number;
}

// False: the text is no number.
bool set(std::optional<Angle>& angle, std::string_view number)
{
    angle = rotctld::degreesIn(withoutHamlibsEnd(number));
    return angle.has_value();
}

// False: the field is unknown, or its value.
bool set(Wanted& wanted, const Field& field)
{
    if (field.name == "AZIMUTH") {
        return set(wanted.target.azimuth, field.value);
    }
    if (field.name == "ELEVATION") {
        return set(wanted.target.elevation, field.value);
    }
    if (field.name == "PARK") {
        wanted.parks = true;
        return field.value == "1";
    }
    return field.name == "TRACK" && field.value == "0";
}

Result<Wanted> wantedBy(const std::vector<Field>& fields)
{
    Wanted wanted;
    std::set<std::string_view> seen;
    for (const Field& field : fields) {
        const QString name = rotctld::shownText(field.name);
        if (!seen.insert(field.name).second) {
            return failure(ErrorCode::InvalidInput, Text::tr("The datagram has the field \"%1\" twice.").arg(name));
        }
        if (!set(wanted, field)) {
            return failure(ErrorCode::InvalidInput, Text::tr("Boresight does not obey the field \"%1\" with the value "
                                                             "\"%2\".")
                                                        .arg(name, rotctld::shownText(field.value)));
        }
    }
    return wanted;
}

Result<Command> commandOf(const Wanted& wanted)
{
    const Target& target = wanted.target;
    const bool points = target.azimuth || target.elevation;
    if (wanted.parks && points) {
        return failure(ErrorCode::InvalidInput, Text::tr("The datagram asks for two motions."));
    }
    if (!points) {
        return wanted.parks ? Command(Park{}) : Command(Nothing{.why = Text::tr("nothing to do")});
    }
    return rotctld::inReach(target.azimuth.value_or(Angle{}), target.elevation.value_or(Angle{})).map([&] {
        return Command(target);
    });
}

}  // namespace

Result<Command> parsePst(std::string_view datagram)
{
    const std::string text = upper(datagram);
    if (hasStop(text)) {
        return Command(StopTurning{});
    }
    const auto body = bodyOf(text, "PST");
    if (!body) {
        return noPst();
    }
    const auto* const question = std::ranges::find(kQuestions, trimmed(*body), &Question::text);
    if (question != kQuestions.end()) {
        return Command(question->ask);
    }
    const auto fields = fieldsIn(*body);
    if (!fields || fields->empty()) {
        return noPst();
    }
    return wantedBy(*fields).and_then(commandOf);
}

std::string pstAnswer(Ask question, const SkyPointing& place)
{
    const Angle angle = question == Ask::Elevation ? place.elevation : place.azimuth.wrapped360();
    return std::string(std::ranges::find(kQuestions, question, &Question::ask)->answer) +
           formatFixed(angle.degrees(), 1) + "\r";
}

}  // namespace boresight::udp
