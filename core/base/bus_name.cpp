// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/bus_name.h"

#include "core/base/control_characters.h"
#include "core/base/numbers.h"
#include "core/base/text.h"

namespace boresight {
namespace {

constexpr std::string_view kSimulated = "simulated";
constexpr std::string_view kSocketCan = "socketcan:";
constexpr std::string_view kFdcanusb = "fdcanusb:";
constexpr std::string_view kSerial = "serial:";
constexpr std::string_view kTcp = "tcp:";
constexpr std::string_view kRotctld = "rotctld:";
constexpr std::string_view kHamlib = "hamlib:";

Result<BusName> parseInterface(std::string_view name)
{
    constexpr std::size_t kMaxLength = 15;  // IFNAMSIZ without the terminating zero
    if (name.empty()) {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("bus 'socketcan:' names no interface. Write for example socketcan:can0"));
    }
    if (name.size() > kMaxLength || name.find_first_of("/ ") != std::string_view::npos || hasControlCharacters(name)) {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("'%1' cannot be an interface name: at most 15 characters, no space and no '/'")
                           .arg(toQString(name)));
    }
    return BusName{.kind = BusKind::SocketCan, .target = std::string(name)};
}

Result<BusName> parsePath(BusKind kind, std::string_view path, const char* example)
{
    if (path.empty()) {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("the bus names no port. Write for example %1").arg(QLatin1String(example)));
    }
    if (hasControlCharacters(path)) {
        return failure(ErrorCode::InvalidInput, Text::tr("the path of a port must not have control characters"));
    }
    return BusName{.kind = kind, .target = std::string(path)};
}

// Parses "HOST:PORT". An IPv6 address is in brackets.
Result<BusName> parseHost(BusKind kind, std::string_view text, const char* example)
{
    const auto colon = text.rfind(':');
    const auto port = parseInteger(text.substr(colon + 1));
    std::string_view host = text.substr(0, colon);
    const bool bracketed = host.size() > 2 && host.front() == '[' && host.back() == ']';
    if (bracketed) {
        host = host.substr(1, host.size() - 2);
    }
    const bool isIpv6 = host.find(':') != std::string_view::npos;
    const bool odd = colon == std::string_view::npos || host.empty() || isIpv6 != bracketed ||
                     host.find_first_of(" []/") != std::string_view::npos || hasControlCharacters(host);
    if (odd || !port || *port < 1 || *port > 65535) {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("'%1' is not an address with a port. Write for example %2")
                           .arg(toQString(printable(std::string(text))), QLatin1String(example)));
    }
    return BusName{.kind = kind, .target = std::string(host), .port = static_cast<std::uint16_t>(*port)};
}

// Parses "MODEL:PORT". A model that needs no port, for example the dummy, is only a number. The text after the first
// colon is passed to Hamlib unchanged: a path, or a host with a port.
Result<BusName> parseHamlib(std::string_view text)
{
    constexpr int kMostModel = 99999;
    const auto colon = text.find(':');
    const auto model = parseInteger(text.substr(0, colon));
    const std::string_view port = colon == std::string_view::npos ? std::string_view() : text.substr(colon + 1);
    const bool noPort = colon != std::string_view::npos && port.empty();
    if (!model || *model < 1 || *model > kMostModel || noPort || hasControlCharacters(port)) {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("'%1' is not a model of Hamlib with its port. Write for example %2")
                           .arg(toQString(printable(std::string(text))), QLatin1String("hamlib:901:/dev/ttyUSB0")));
    }
    return BusName{.kind = BusKind::Hamlib, .target = std::string(port), .model = static_cast<int>(*model)};
}

std::string hostText(const BusName& bus)
{
    const bool isIpv6 = bus.target.find(':') != std::string::npos;
    return (isIpv6 ? "[" + bus.target + "]" : bus.target) + ":" + std::to_string(bus.port);
}

}  // namespace

Result<BusName> parseBusName(std::string_view text)
{
    if (text == kSimulated) {
        return BusName{};
    }
    if (text.starts_with(kSocketCan)) {
        return parseInterface(text.substr(kSocketCan.size()));
    }
    if (text.starts_with(kFdcanusb)) {
        return parsePath(BusKind::Fdcanusb, text.substr(kFdcanusb.size()), "fdcanusb:/dev/boresight/fdcanusb");
    }
    if (text.starts_with(kSerial)) {
        return parsePath(BusKind::Serial, text.substr(kSerial.size()), "serial:/dev/ttyUSB0");
    }
    if (text.starts_with(kTcp)) {
        return parseHost(BusKind::Tcp, text.substr(kTcp.size()), "tcp:192.168.1.20:4001");
    }
    if (text.starts_with(kRotctld)) {
        return parseHost(BusKind::Rotctld, text.substr(kRotctld.size()), "rotctld:192.168.1.20:4533");
    }
    if (text.starts_with(kHamlib)) {
        return parseHamlib(text.substr(kHamlib.size()));
    }
    return failure(
        ErrorCode::InvalidInput,
        Text::tr("unknown bus '%1'. Write simulated, socketcan:INTERFACE, fdcanusb:PATH, serial:PATH, tcp:HOST:PORT, "
                 "rotctld:HOST:PORT or hamlib:MODEL:PORT")
            .arg(toQString(text)));
}

std::string toString(const BusName& bus)
{
    switch (bus.kind) {
        case BusKind::SocketCan:
            return std::string(kSocketCan) + bus.target;
        case BusKind::Fdcanusb:
            return std::string(kFdcanusb) + bus.target;
        case BusKind::Serial:
            return std::string(kSerial) + bus.target;
        case BusKind::Tcp:
            return std::string(kTcp) + hostText(bus);
        case BusKind::Rotctld:
            return std::string(kRotctld) + hostText(bus);
        case BusKind::Hamlib:
            return std::string(kHamlib) + std::to_string(bus.model) + (bus.target.empty() ? "" : ":") + bus.target;
        case BusKind::Simulated:
            break;
    }
    return std::string(kSimulated);
}

}  // namespace boresight
