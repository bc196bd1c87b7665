// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wind/wind_source.h"

#include "core/base/control_characters.h"
#include "core/base/numbers.h"
#include "core/base/text.h"

#include <QHostAddress>
#include <QUrl>

#include <string_view>

namespace boresight::wind {
namespace {

constexpr std::size_t kLongestName = 1000;  // bytes
constexpr std::string_view kUdp = "udp:";
constexpr std::string_view kMqtt = "mqtt:";

Result<SourceName> atPort(std::string_view place)
{
    const std::size_t colon = place.rfind(':');
    const bool hasHost = colon != std::string_view::npos;
    const QString host = hasHost ? toQString(place.substr(0, colon)) : QStringLiteral("127.0.0.1");
    const auto port = parseInteger(hasHost ? place.substr(colon + 1) : place);
    if (QHostAddress(host).isNull() || !port || *port < 1 || *port > 65535) {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("udp:PORT is expected, or udp:ADDRESS:PORT with an address of this computer"));
    }
    return SourceName{.kind = SourceKind::Udp, .place = host, .port = static_cast<std::uint16_t>(*port)};
}

// Wildcards are refused, because only one anemometer is read.
Result<SourceName> onTopic(std::string_view topic)
{
    const bool isTopic = !topic.empty() && topic.front() != '$' && topic.find_first_of("+#") == std::string_view::npos;
    return isTopic
               ? Result<SourceName>(SourceName{.kind = SourceKind::Mqtt, .place = toQString(topic)})
               : failure(ErrorCode::InvalidInput, Text::tr("a topic is expected after the colon, without + # and $"));
}

Result<SourceName> onPage(const QString& address)
{
    const QUrl url(address, QUrl::StrictMode);
    return url.isValid() && !url.host().isEmpty()
               ? Result<SourceName>(SourceName{.kind = SourceKind::Page, .place = address})
               : failure(ErrorCode::InvalidInput, Text::tr("an address like http://anemometer/wind is expected"));
}

}  // namespace

Result<SourceName> parseSource(const std::string& text)
{
    if (text.empty()) {
        return SourceName{};
    }
    if (text.size() > kLongestName || hasControlCharacters(text)) {
        return failure(ErrorCode::InvalidInput, Text::tr("one line of at most 1000 bytes is expected"));
    }
    const std::string_view name = text;
    if (name.starts_with(kUdp)) {
        return atPort(name.substr(kUdp.size()));
    }
    if (name.starts_with(kMqtt)) {
        return onTopic(name.substr(kMqtt.size()));
    }
    if (name.starts_with("http://") || name.starts_with("https://")) {
        return onPage(toQString(name));
    }
    return failure(ErrorCode::InvalidInput,
                   Text::tr("udp:PORT, udp:ADDRESS:PORT, mqtt:TOPIC or http://HOST/PATH is expected"));
}

}  // namespace boresight::wind
