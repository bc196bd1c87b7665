// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/listeners/listener.h"

#include "core/base/numbers.h"
#include "core/base/text.h"

#include <QHostAddress>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

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
                                ProtocolWord{"pairs", "Pairs", Protocol::Pairs}};

constexpr std::string_view kTcp = "tcp:";
constexpr std::string_view kPty = "pty:";
constexpr std::string_view kUnix = "unix:";

QHostAddress addressOf(const std::string& host)
{
    return host == "localhost" ? QHostAddress(QHostAddress::LocalHost) : QHostAddress(QString::fromStdString(host));
}

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

bool isTcp(const Listener& listener)
{
    return listener.pty.empty() && listener.unixPath.empty();
}

Result<> readTcp(std::string_view place, Listener& listener)
{
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
    if (!port || *port < 0 || *port > std::numeric_limits<std::uint16_t>::max() || addressOf(listener.host).isNull()) {
        return failure(
            ErrorCode::InvalidInput,
            Text::tr("\"tcp:%1\" names no IP address and port. An example: tcp:127.0.0.1:4534").arg(toQString(place)));
    }
    listener.port = static_cast<std::uint16_t>(*port);
    return {};
}

Result<> readPlace(std::string_view word, Listener& listener)
{
    if (word.starts_with(kTcp)) {
        return readTcp(word.substr(kTcp.size()), listener);
    }
    const bool terminal = word.starts_with(kPty);
    const std::string_view path = terminal                  ? word.substr(kPty.size())
                                  : word.starts_with(kUnix) ? word.substr(kUnix.size())
                                                            : std::string_view();
    if (!path.starts_with('/') || path.ends_with('/')) {
        return failure(
            ErrorCode::InvalidInput,
            Text::tr("\"%1\" is not a place to listen. tcp:ADDRESS:PORT, pty:/PATH or unix:/PATH is expected")
                .arg(toQString(word)));
    }
    (terminal ? listener.pty : listener.unixPath) = std::string(path);
    return {};
}

Result<> readAllowed(std::string_view word, Listener& listener)
{
    const std::string entry(word);
    const QString shown = toQString(word);
    const bool network = word.find('/') != std::string_view::npos;
    if (network ? QHostAddress::parseSubnet(shown).first.isNull() : QHostAddress(shown).isNull()) {
        return failure(ErrorCode::InvalidInput, Text::tr("\"%1\" is neither an IP address nor a network").arg(shown));
    }
    listener.allow.push_back(entry);
    return {};
}

}  // namespace

Result<Listener> parseListener(std::string_view text)
{
    const std::vector<std::string_view> words = wordsOf(text);
    if (words.size() < 3) {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("protocol, rights and place are expected, like \"gs232b drive tcp:127.0.0.1:4534\""));
    }
    const auto* const protocol = std::ranges::find(kProtocols, words[0], &ProtocolWord::word);
    if (protocol == kProtocols.end()) {
        return failure(
            ErrorCode::InvalidInput,
            Text::tr("the protocol \"%1\" is unknown. Known are: %2").arg(toQString(words[0]), knownProtocols()));
    }
    if (words[1] != "drive" && words[1] != "read") {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("the rights \"%1\" are neither \"drive\" nor \"read\"").arg(toQString(words[1])));
    }
    Listener listener{.protocol = protocol->protocol,
                      .rights = words[1] == "read" ? Rights::Read : Rights::Drive,
                      .pty = {},
                      .host = {}};
    if (const auto place = readPlace(words[2], listener); !place) {
        return tl::unexpected(place.error());
    }
    if (!isTcp(listener) && words.size() > 3) {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("\"%1\" must not follow a path. Only programs of this computer reach a path")
                           .arg(toQString(words[3])));
    }
    for (std::size_t i = 3; i < words.size(); ++i) {
        if (const auto allowed = readAllowed(words[i], listener); !allowed) {
            return tl::unexpected(allowed.error());
        }
    }
    return listener;
}

std::string_view nameOf(Protocol protocol)
{
    return std::ranges::find(kProtocols, protocol, &ProtocolWord::protocol)->name;
}

std::string placeOf(const Listener& listener)
{
    if (!isTcp(listener)) {
        return listener.pty + listener.unixPath;
    }
    const bool sixth = listener.host.find(':') != std::string::npos;
    return (sixth ? "[" + listener.host + "]" : listener.host) + ":" + std::to_string(listener.port);
}

bool isOpenToAll(const Listener& listener)
{
    return isTcp(listener) && listener.allow.empty() && listener.rights == Rights::Drive &&
           !addressOf(listener.host).isLoopback();
}

bool collide(const Listener& one, const Listener& other)
{
    return placeOf(one) == placeOf(other) && (!isTcp(one) || one.port != 0);
}

}  // namespace boresight::listeners
