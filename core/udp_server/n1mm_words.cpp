// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/udp_server/n1mm_words.h"

#include "core/base/text.h"
#include "core/base/trimmed.h"
#include "core/rotctld/client_angles.h"
#include "core/rotctld/client_habits.h"
#include "core/udp_server/tagged_text.h"

#include <algorithm>
#include <optional>
#include <set>

namespace boresight::udp {
namespace {

constexpr std::string_view kEnvelope = "N1MMRotor";

tl::unexpected<Error> unknownToN1mm()
{
    return failure(ErrorCode::InvalidInput, Text::tr("Boresight knows no such command of N1MM."));
}

bool hasTag(std::string_view datagram, std::string_view tag)
{
    return datagram.find("<" + std::string(tag) + ">") != std::string_view::npos;
}

// A stop without the field "rotor" may itself be the name. "0" and "1" are values of a stop, and other fields in it are
// no name.
std::string_view rotorIn(std::string_view datagram, bool stops)
{
    const auto named = valueOf(datagram, "rotor");
    if (named || !stops) {
        return trimmed(named.value_or(""));
    }
    const std::string_view stop = trimmed(valueOf(datagram, "stop").value_or(""));
    const bool isName = stop != "0" && stop != "1" && stop.find('<') == std::string_view::npos;
    return isName ? stop : std::string_view();
}

// Some programs write "&amp;" for "&".
bool isName(std::string_view written, const std::string& rotor)
{
    return written == rotor || toQString(written) == toQString(rotor).toHtmlEscaped();
}

// A bidirectional antenna is turned to the requested direction too.
Result<Command> parseTurn(const std::vector<Field>& fields)
{
    static const std::set<std::string_view> kKnown{"rotor", "goazi", "offset", "bidirectional", "freqband"};
    std::set<std::string_view> seen;
    std::optional<Angle> azimuth;
    bool hasOffset = false;
    for (const Field& field : fields) {
        const bool isAngle = field.name == "goazi" || field.name == "offset";
        const auto angle = isAngle ? rotctld::degreesIn(field.value) : std::nullopt;
        if (!kKnown.contains(field.name) || !seen.insert(field.name).second || (isAngle && !angle)) {
            return unknownToN1mm();
        }
        azimuth = field.name == "goazi" ? angle : azimuth;
        hasOffset = hasOffset || (field.name == "offset" && *angle != Angle{});
    }
    if (!azimuth) {
        return unknownToN1mm();
    }
    if (hasOffset) {
        return failure(
            ErrorCode::NotAvailable,
            Text::tr("Boresight does not support the offset of an antenna. Set the offset to 0 in N1MM, and enter it "
                     "in Boresight as the direction of the beam."));
    }
    return rotctld::inReach(*azimuth, {}).map([&] { return Command(Target{.azimuth = azimuth, .elevation = {}}); });
}

}  // namespace

Result<Command> parseN1mm(std::string_view datagram, const std::string& rotor)
{
    if (!hasTag(datagram, kEnvelope)) {
        return unknownToN1mm();
    }
    const bool stops = hasTag(datagram, "stop");
    const std::string_view name = rotorIn(datagram, stops);
    const bool isNameless = stops && name.empty();  // then it is for every rotor
    if (!rotor.empty() && !isNameless && !isName(name, rotor)) {
        return Command(Nothing{.why = name.empty() ? Text::tr("names no rotor")
                                                   : Text::tr("for the rotor \"%1\"").arg(rotctld::shownText(name))});
    }
    if (stops) {
        return Command(StopTurning{});
    }
    const auto body = bodyOf(datagram, kEnvelope);
    const auto fields = body ? fieldsIn(*body) : std::nullopt;
    return fields ? parseTurn(*fields) : unknownToN1mm();
}

}  // namespace boresight::udp
