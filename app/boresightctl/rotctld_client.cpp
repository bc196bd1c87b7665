// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/boresightctl/rotctld_client.h"

#include "core/base/numbers.h"
#include "core/base/text.h"

#include <QList>

#include <optional>

namespace boresight::ctl {
namespace {

constexpr qsizetype kLongestReply = 4096;

// For a server that reports only a number (core/rotctld/README.md).
QString refusalText(int code)
{
    switch (code) {
        case -1:
            return QStringLiteral("The station does not permit this position (RPRT -1).");
        case -6:
            return QStringLiteral("The station has no position of the mount: bus or drive silent (RPRT -6).");
        case -9:
            return QStringLiteral(
                "STOP is latched, a fault is not re-armed, or the operator or another client has control (RPRT -9). "
                "The "
                "log of the station has the reason.");
        default:
            return QStringLiteral("The station refused this (RPRT %1).").arg(code);
    }
}

// The number in the last line, for example "RPRT -9". Empty while the reply is incomplete.
std::optional<int> codeOf(const QByteArray& reply)
{
    const qsizetype place = reply.lastIndexOf("RPRT ");
    if (place < 0 || !reply.endsWith('\n')) {
        return std::nullopt;
    }
    bool isNumber = false;
    const int code = reply.mid(place + 5).trimmed().toInt(&isNumber);
    return isNumber ? std::optional(code) : std::nullopt;
}

// The text after "LABEL: " in an extended reply.
QByteArray valueOf(const QByteArray& reply, const QByteArray& label)
{
    for (const QByteArray& line : reply.split('\n')) {
        if (line.startsWith(label + ": ")) {
            return line.mid(label.size() + 2).trimmed();
        }
    }
    return {};
}

QJsonValue directionIn(const QByteArray& reply)
{
    const auto azimuth = parseFinite(valueOf(reply, "Azimuth").toStdString());
    const auto elevation = parseFinite(valueOf(reply, "Elevation").toStdString());
    return azimuth && elevation ? QJsonValue(QJsonObject{{QStringLiteral("azimuth"), *azimuth},
                                                         {QStringLiteral("elevation"), *elevation}})
                                : QJsonValue();
}

}  // namespace

Result<> RotctldClient::connect(const profile::ListenAddress& station)
{
    m_name = QStringLiteral("%1:%2").arg(toQString(station.host)).arg(station.port);
    m_socket.connectToHost(toQString(station.host), station.port);
    if (!m_socket.waitForConnected(static_cast<int>(m_deadline.remainingTime()))) {
        return failure(ErrorCode::NoAnswer,
                       QStringLiteral("No station answers on %1: %2.").arg(m_name, m_socket.errorString()));
    }
    return {};
}

Result<QByteArray> RotctldClient::ask(const QByteArray& command)
{
    m_socket.write("+" + command + "\n");
    QByteArray reply;
    while (!codeOf(reply) && reply.size() < kLongestReply) {
        if (!m_socket.waitForReadyRead(static_cast<int>(m_deadline.remainingTime()))) {
            return failure(
                ErrorCode::NoAnswer,
                QStringLiteral("%1 does not answer like a rotctld: %2.").arg(m_name, m_socket.errorString()));
        }
        reply += m_socket.readAll();
    }
    const int code = codeOf(reply).value_or(-8);
    return code == 0 ? Result<QByteArray>(reply) : failure(ErrorCode::Refused, refusalText(code));
}

// Only Boresight answers get_outcome. Hamlib's rotctld does not answer it at all, so a question follows that each
// server answers.
QString RotctldClient::outcome()
{
    const auto reply = ask("\\get_outcome\n+_");
    return reply ? QString::fromUtf8(valueOf(*reply, "Outcome")) : QString();
}

// A refusal has the reason of the station if the station reports it.
Result<QString> RotctldClient::order(const QByteArray& command)
{
    const auto reply = ask(command);
    if (!reply && reply.error().code != ErrorCode::Refused) {
        return tl::unexpected(reply.error());
    }
    const QString words = outcome();
    if (!reply) {
        return failure(ErrorCode::Refused, words.isEmpty() ? reply.error().text : words);
    }
    return words;
}

Result<QString> RotctldClient::pointTo(const SkyPointing& direction)
{
    return order("P " + QByteArray::fromStdString(formatFixed(direction.azimuth.degrees(), 4)) + " " +
                 QByteArray::fromStdString(formatFixed(direction.elevation.degrees(), 4)));
}

Result<> RotctldClient::park()
{
    return order("K").map([](const QString&) {});
}

Result<> RotctldClient::hold()
{
    return order("S").map([](const QString&) {});
}

Result<QJsonObject> RotctldClient::status()
{
    const auto info = ask("_");
    if (!info) {
        return tl::unexpected(info.error());
    }
    const auto flags = ask("\\get_status");
    if (!flags) {
        return tl::unexpected(flags.error());
    }
    const auto position = ask("p");
    if (!position && position.error().code != ErrorCode::Refused) {
        return tl::unexpected(position.error());
    }
    const bool moves = flags->contains("MOVING");
    return QJsonObject{
        {QStringLiteral("station"), QString::fromUtf8(valueOf(*info, "Info"))},
        {QStringLiteral("state"), moves ? QStringLiteral("MOVING") : QStringLiteral("SLOW OR NOT MOVING")},
        {QStringLiteral("actual"), position ? directionIn(*position) : QJsonValue()},
    };
}

}  // namespace boresight::ctl
