// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/listeners/listener.h"

#include "core/base/numbers.h"
#include "core/base/peer_address.h"
#include "core/base/text.h"
#include "core/base/trimmed.h"

#include <QHostAddress>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <span>

namespace boresight::listeners {
namespace {

struct ProtocolWord
{
    std::string_view word;  // in the profile
    std::string_view name;  // for people
    Protocol protocol;
};
constexpr std::array kProtocols{ProtocolWord{"gs232a", "GS-232A", Protocol::Gs232A},
                                ProtocolWord{"gs232b", "GS-232B", Protocol::Gs232B},
                                ProtocolWord{"easycomm1", "EasyComm I", Protocol::Easycomm1},
                                ProtocolWord{"easycomm2", "EasyComm II", Protocol::Easycomm2},
                                ProtocolWord{"easycomm3", "EasyComm III", Protocol::Easycomm3},
                                ProtocolWord{"pairs", "Pairs", Protocol::Pairs},
                                ProtocolWord{"pst", "PstRotator", Protocol::Pst},
                                ProtocolWord{"n1mm", "N1MM", Protocol::N1mm}};

constexpr std::string_view kTcp = "tcp:";
constexpr std::string_view kUdp = "udp:";
constexpr std::string_view kPty = "pty:";
constexpr std::string_view kUnix = "unix:";
constexpr std::string_view kRotor = " rotor=";

QString knownProtocols()
{
    QStringList words;
    for (const ProtocolWord& protocol : kProtocols) {
        words << toQString(protocol.word);
    }
    return words.join(QStringLiteral(", "));
}

std::vector<std::string_view> wordsOf(std::string_view text)
{
    std::vector<std::string_view> words;
    while (true) {
        const std::size_t begin = text.find_first_not_of(' ');
        if (begin == std::string_view::npos) {
            return words;
        }
        text.remove_prefix(begin);
        words.push_back(text.substr(0, text.find(' ')));
        text.remove_prefix(words.back().size());
    }
}

bool hasPort(const Listener& listener)
{
    return listener.pty.empty() && listener.unixPath.empty();
}

// "tcp:127.0.0.1:4534", "udp:[::1]:12000".
Result<> readPort(std::string_view word, Listener& listener)
{
    listener.udp = word.starts_with(kUdp);
    const std::string_view place = word.substr(kTcp.size());
    const std::size_t colon = place.rfind(':');
    std::optional<std::int64_t> port;
    if (colon != std::string_view::npos) {
        port = parseInteger(place.substr(colon + 1));
    }
    std::string_view host = place.substr(0, colon);
    if (host.starts_with('[') && host.ends_with(']')) {
        host = host.substr(1, host.size() - 2);
    }
    listener.host = std::string(host);
    if (!port || *port < 0 || *port > std::numeric_limits<std::uint16_t>::max() ||
        listenAddress(listener.host).isNull()) {
        return failure(
            ErrorCode::InvalidInput,
            Text::tr("\"%1\" names no IP address and port. An example: tcp:127.0.0.1:4534").arg(toQString(word)));
    }
    listener.port = static_cast<std::uint16_t>(*port);
    return {};
}

Result<> readPlace(std::string_view word, Listener& listener)
{
    if (word.starts_with(kTcp) || word.starts_with(kUdp)) {
        return readPort(word, listener);
    }
    const bool terminal = word.starts_with(kPty);
    const std::string_view path = terminal                  ? word.substr(kPty.size())
                                  : word.starts_with(kUnix) ? word.substr(kUnix.size())
                                                            : std::string_view();
    if (!path.starts_with('/') || path.ends_with('/')) {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("\"%1\" is not a place to listen. tcp:ADDRESS:PORT, udp:ADDRESS:PORT, pty:/PATH or "
                                "unix:/PATH is expected")
                           .arg(toQString(word)));
    }
    (terminal ? listener.pty : listener.unixPath) = std::string(path);
    return {};
}

// "::" serves IPv4 as well.
bool covers(const QHostAddress& one, const QHostAddress& other)
{
    return one == other || one == QHostAddress(QHostAddress::AnyIPv6) ||
           (one == QHostAddress(QHostAddress::AnyIPv4) && other.protocol() == QAbstractSocket::IPv4Protocol);
}

bool shareAddress(const Listener& one, const Listener& other)
{
    const QHostAddress first = listenAddress(one.host);
    const QHostAddress second = listenAddress(other.host);
    return covers(first, second) || covers(second, first);
}

// Programs on other computers may move the mount.
bool movesFromElsewhere(const Listener& listener)
{
    return hasPort(listener) && listener.rights == Rights::Drive && !isThisComputer(listener.host);
}

// No protocol has both connections and datagrams.
Result<> fits(const Listener& listener, std::string_view protocol, std::string_view place)
{
    const bool sends = listener.protocol == Protocol::Pst || listener.protocol == Protocol::N1mm;
    if (sends != listener.udp) {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("\"%1\" is not served at \"%2\". \"pst\" and \"n1mm\" have a place like "
                                "udp:127.0.0.1:12000, and no other protocol has one")
                           .arg(toQString(protocol), toQString(place)));
    }
    return {};
}

Result<> readProtocol(std::string_view word, Listener& listener)
{
    const auto* const protocol = std::ranges::find(kProtocols, word, &ProtocolWord::word);
    if (protocol == kProtocols.end()) {
        return failure(
            ErrorCode::InvalidInput,
            Text::tr("the protocol \"%1\" is unknown. Known are: %2").arg(toQString(word), knownProtocols()));
    }
    listener.protocol = protocol->protocol;
    return {};
}

Result<> readRights(std::string_view word, Listener& listener)
{
    if (word != "drive" && word != "read") {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("the rights \"%1\" are neither \"drive\" nor \"read\"").arg(toQString(word)));
    }
    listener.rights = word == "read" ? Rights::Read : Rights::Drive;
    return {};
}

Result<> readAllowed(std::span<const std::string_view> words, Listener& listener)
{
    if (!hasPort(listener) && !words.empty()) {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("\"%1\" must not follow a path. Only programs of this computer reach a path")
                           .arg(toQString(words[0])));
    }
    for (const std::string_view word : words) {
        const QString shown = toQString(word);
        const bool network = word.find('/') != std::string_view::npos;
        if (network ? QHostAddress::parseSubnet(shown).first.isNull() : QHostAddress(shown).isNull()) {
            return failure(ErrorCode::InvalidInput,
                           Text::tr("\"%1\" is neither an IP address nor a network").arg(shown));
        }
        listener.allow.emplace_back(word);
    }
    return {};
}

// A question is answered to the port after that of the listener.
Result<> checkAnswers(const Listener& listener)
{
    constexpr std::uint16_t kLast = std::numeric_limits<std::uint16_t>::max();
    if (listener.protocol == Protocol::Pst && listener.port == kLast) {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("\"pst\" answers to the port after its own. Choose a port below %1").arg(kLast));
    }
    return {};
}

// A datagram has no connection that proves its sender, so a list of senders is always required.
Result<> checkSenders(const Listener& listener)
{
    if (listener.udp && isOpenToAll(listener)) {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("other computers could move the mount by UDP. Add the permitted addresses. Or listen "
                                "on 127.0.0.1, or use the right \"read\""));
    }
    return {};
}

// The rest of the line, because the name of a rotor may have blanks.
Result<> readRotor(std::string_view name, Listener& listener)
{
    listener.rotor = std::string(trimmed(name));
    if (listener.protocol != Protocol::N1mm || listener.rotor.empty()) {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("\"rotor=\" is followed by the name of a rotor in N1MM, at the end of a line of n1mm"));
    }
    return {};
}

}  // namespace

Result<Listener> parseListener(std::string_view line)
{
    const std::size_t rotor = line.find(kRotor);
    const std::vector<std::string_view> words = wordsOf(line.substr(0, rotor));
    if (words.size() < 3) {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("protocol, rights and place are expected, like \"gs232b drive tcp:127.0.0.1:4534\""));
    }
    Listener listener;
    const Result<> read = readProtocol(words[0], listener)
                              .and_then([&] { return readRights(words[1], listener); })
                              .and_then([&] { return readPlace(words[2], listener); })
                              .and_then([&] { return fits(listener, words[0], words[2]); })
                              .and_then([&] { return readAllowed(std::span(words).subspan(3), listener); })
                              .and_then([&] { return checkSenders(listener); })
                              .and_then([&] { return checkAnswers(listener); })
                              .and_then([&] {
                                  return rotor == std::string_view::npos
                                             ? Result<>()
                                             : readRotor(line.substr(rotor + kRotor.size()), listener);
                              });
    return read.map([&] { return listener; });
}

std::string_view nameOf(Protocol protocol)
{
    return std::ranges::find(kProtocols, protocol, &ProtocolWord::protocol)->name;
}

std::string placeOf(const Listener& listener)
{
    if (!hasPort(listener)) {
        return listener.pty + listener.unixPath;
    }
    const bool sixth = listener.host.find(':') != std::string::npos;
    return (listener.udp ? "UDP " : "") + (sixth ? "[" + listener.host + "]" : listener.host) + ":" +
           std::to_string(listener.port);
}

bool isOpenToAll(const Listener& listener)
{
    return movesFromElsewhere(listener) && listener.allow.empty();
}

bool isOpenToForgery(const Listener& listener)
{
    return movesFromElsewhere(listener) && listener.udp;
}

bool collide(const Listener& one, const Listener& other)
{
    if (!hasPort(one) || !hasPort(other)) {
        return placeOf(one) == placeOf(other);
    }
    return one.udp == other.udp && one.port == other.port && one.port != 0 && shareAddress(one, other);
}

}  // namespace boresight::listeners
