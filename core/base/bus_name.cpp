// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/bus_name.h"

#include "core/base/control_characters.h"
#include "core/base/text.h"

namespace boresight {
namespace {

constexpr std::string_view kSimulated = "simulated";
constexpr std::string_view kSocketCan = "socketcan:";
constexpr std::string_view kFdcanusb = "fdcanusb:";

Result<BusName> parseInterface(std::string_view name)
{
    constexpr std::size_t kMaxLength = 15;  // IFNAMSIZ without its end mark
    if (name.empty()) {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("bus 'socketcan:' names no interface; write for example socketcan:can0"));
    }
    if (name.size() > kMaxLength || name.find_first_of("/ ") != std::string_view::npos || hasControlCharacters(name)) {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("'%1' cannot be an interface name: at most 15 characters, no space and no '/'")
                           .arg(toQString(name)));
    }
    return BusName{BusKind::SocketCan, std::string(name)};
}

}  // namespace

Result<BusName> parseBusName(std::string_view text)
{
    if (text == kSimulated) {
        return BusName{BusKind::Simulated, {}};
    }
    if (text.starts_with(kSocketCan)) {
        return parseInterface(text.substr(kSocketCan.size()));
    }
    if (text.starts_with(kFdcanusb)) {
        const std::string_view path = text.substr(kFdcanusb.size());
        if (path.empty()) {
            return failure(
                ErrorCode::InvalidInput,
                Text::tr("bus 'fdcanusb:' names no port; write for example fdcanusb:/dev/boresight/fdcanusb"));
        }
        if (hasControlCharacters(path)) {
            return failure(ErrorCode::InvalidInput, Text::tr("a port's path has no control characters"));
        }
        return BusName{BusKind::Fdcanusb, std::string(path)};
    }
    return failure(
        ErrorCode::InvalidInput,
        Text::tr("unknown bus '%1'; write simulated, socketcan:INTERFACE or fdcanusb:PATH").arg(toQString(text)));
}

std::string toString(const BusName& bus)
{
    switch (bus.kind) {
        case BusKind::SocketCan:
            return std::string(kSocketCan) + bus.target;
        case BusKind::Fdcanusb:
            return std::string(kFdcanusb) + bus.target;
        case BusKind::Simulated:
            break;
    }
    return std::string(kSimulated);
}

}  // namespace boresight
