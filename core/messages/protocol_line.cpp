// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/messages/protocol_line.h"

#include "core/base/text.h"
#include "core/units/degrees_text.h"

#include <QDateTime>

#include <algorithm>

namespace boresight {
namespace {

constexpr std::string_view kLineEndBytes = "\r\n";

bool continuesCharacter(char byte)
{
    constexpr unsigned kContinuationMask = 0xc0;
    constexpr unsigned kContinuation = 0x80;
    return (static_cast<unsigned char>(byte) & kContinuationMask) == kContinuation;
}

QString escapedByte(unsigned char byte)
{
    switch (byte) {
        case '\n':
            return QStringLiteral("\\n");
        case '\r':
            return QStringLiteral("\\r");
        case '\t':
            return QStringLiteral("\\t");
        default:
            return QStringLiteral("\\x%1").arg(byte, 2, 16, QLatin1Char('0'));
    }
}

QString escapedCharacter(QStringView character)
{
    QString text;
    for (const char byte : character.toUtf8()) {
        text += escapedByte(static_cast<unsigned char>(byte));
    }
    return text;
}

QString utcToMillisecond(UtcTime utc)
{
    const auto since = std::chrono::floor<std::chrono::milliseconds>(utc.time_since_epoch());
    return QDateTime::fromMSecsSinceEpoch(since.count(), Qt::UTC).toString(Qt::ISODateWithMs);
}

bool readsAsEscape(QStringView afterBackslash)
{
    return !afterBackslash.isEmpty() && QStringView(u"nrtx\\").contains(afterBackslash.front());
}

// Text that is not UTF-8 is shown byte by byte.
QString escapedText(std::string_view bytes)
{
    QString characters = toQString(bytes);
    const bool isText = !characters.contains(QChar::ReplacementCharacter);
    if (!isText) {
        characters = QString::fromLatin1(bytes.data(), static_cast<qsizetype>(bytes.size()));
    }
    QString shown;
    const QStringView all(characters);
    for (qsizetype at = 0; at < all.size(); ++at) {
        const qsizetype units = all[at].isHighSurrogate() && at + 1 < all.size() ? 2 : 1;
        const QStringView one = all.mid(at, units);
        const char16_t code = one.front().unicode();
        if (one.front() == u'\\') {
            shown += readsAsEscape(all.mid(at + 1)) ? QStringLiteral("\\\\") : QStringLiteral("\\");
        } else if (!isText && (code >= 0x7f || code < u' ')) {
            shown += escapedByte(static_cast<unsigned char>(code));
        } else if (units == 1 && !one.front().isPrint()) {
            shown += escapedCharacter(one);
        } else {
            shown += one;
        }
        at += units - 1;
    }
    return shown;
}

QString actText(const ProtocolAct& act)
{
    using Kind = ProtocolAct::Kind;
    switch (act.kind) {
        case Kind::Point:
            return Text::tr("go to %1 / %2").arg(degreesText(act.azimuth), degreesText(act.elevation));
        case Kind::AskPosition:
            return Text::tr("asks the position");
        case Kind::AskTarget:
            return Text::tr("asks the target");
        case Kind::AskMotion:
            return Text::tr("asks whether the mount moves");
        case Kind::MoveUp:
            return Text::tr("move up");
        case Kind::MoveDown:
            return Text::tr("move down");
        case Kind::MoveLeft:
            return Text::tr("move left");
        case Kind::MoveRight:
            return Text::tr("move right");
        case Kind::Stop:
            return Text::tr("stop");
        case Kind::Park:
            return Text::tr("park");
        case Kind::Reset:
            return Text::tr("reset");
        case Kind::SetSpeed:
            break;
    }
    return Text::tr("set the jog speed to level %1").arg(act.level);
}

QString wantedText(const ProtocolLine& line)
{
    QStringList parts;
    for (const ProtocolAct& act : line.acts) {
        parts << actText(act);
    }
    if (parts.isEmpty() && !line.command.empty()) {
        parts << Text::tr("command %1").arg(toQString(line.command));
    }
    return parts.join(QStringLiteral(", "));
}

QString refusedText(const ProtocolLine& line, const QString& wanted)
{
    if (line.outcome == ProtocolOutcome::NotUnderstood) {
        return line.remark.isEmpty() ? Text::tr("not understood") : Text::tr("not understood: %1").arg(line.remark);
    }
    return wanted.isEmpty() ? Text::tr("refused. %1").arg(line.remark)
                            : Text::tr("%1: refused. %2").arg(wanted, line.remark);
}

}  // namespace

ProtocolBytes protocolBytes(std::string_view bytes, std::size_t size)
{
    std::size_t end = std::min(bytes.size(), ProtocolBytes::kMost);
    // A character of several bytes is not cut in two.
    for (int i = 0; i < 3 && end < bytes.size() && end > 0 && continuesCharacter(bytes[end]); ++i) {
        --end;
    }
    return {.begin = std::string(bytes.substr(0, end)), .size = std::max(size, bytes.size())};
}

QString bytesText(const ProtocolBytes& bytes)
{
    const bool isCut = bytes.begin.size() < bytes.size;
    if (isCut) {
        return Text::tr("%1… (%2 bytes)").arg(escapedText(bytes.begin), QString::number(bytes.size));
    }
    const std::size_t end = bytes.begin.find_last_not_of(kLineEndBytes);
    return escapedText(end == std::string::npos ? std::string_view(bytes.begin)
                                                : std::string_view(bytes.begin).substr(0, end + 1));
}

QString understoodText(const ProtocolLine& line)
{
    const QString wanted = wantedText(line);
    if (line.outcome != ProtocolOutcome::Done) {
        return refusedText(line, wanted);
    }
    if (wanted.isEmpty() && line.remark.isEmpty()) {
        return line.answer.size > 0 ? Text::tr("asks for information") : Text::tr("nothing to do");
    }
    if (wanted.isEmpty() || line.remark.isEmpty()) {
        return wanted + line.remark;
    }
    return QStringLiteral("%1 → %2").arg(wanted, line.remark);
}

QString fileText(const ProtocolLine& line)
{
    return QStringList{utcToMillisecond(line.utc),
                       line.client.simplified(),
                       line.odd ? QStringLiteral("odd") : QStringLiteral("-"),
                       bytesText(line.line),
                       understoodText(line).simplified(),
                       bytesText(line.answer)}
        .join(QLatin1Char('\t'));
}

}  // namespace boresight
