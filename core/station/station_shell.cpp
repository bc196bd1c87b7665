// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/station_shell.h"

#include "core/base/text.h"
#include "core/elements/julian_date.h"
#include "core/night/schedule_json.h"
#include "core/targets/target_text.h"

#include <QJsonDocument>
#include <QJsonObject>

namespace boresight {
namespace {

constexpr int kShellLinesPerSecond = 4;
const QByteArray kPositionWord = "position";  // in place of a target

Source shellSource()
{
    return {.kind = SourceKind::Operator, .name = QStringLiteral("shell")};
}

Request requestOf(local::LocalCommand command)
{
    switch (command) {
        case local::LocalCommand::Take:
            return request::TakeAuthority{};
        case local::LocalCommand::Release:
            return request::GiveAuthority{};
        case local::LocalCommand::ResetStop:
            return request::ResetStop{};
        case local::LocalCommand::ScheduleArm:
            return request::ArmSchedule{};
        case local::LocalCommand::ScheduleDisarm:
            return request::DisarmSchedule{};
        case local::LocalCommand::ScheduleRehearse:
            return request::Rehearse{};
        case local::LocalCommand::Stop:
        case local::LocalCommand::Track:
        case local::LocalCommand::Satellites:
        case local::LocalCommand::ScheduleList:
        case local::LocalCommand::ScheduleReport:
        case local::LocalCommand::ScheduleRehearsal:
        case local::LocalCommand::Transmit:
            break;
    }
    return request::Stop{};
}

// An object without fields: the profile names no output.
QByteArray transmitJson(const TransmitStatus& transmit)
{
    QJsonObject all;
    if (!transmit.output.isEmpty()) {
        all = {{QStringLiteral("output"), transmit.output},
               {QStringLiteral("on"), transmit.on},
               {QStringLiteral("whyOff"), transmit.whyOff},
               {QStringLiteral("problem"), transmit.problem},
               {QStringLiteral("within"), transmit.within.degrees()},
               {QStringLiteral("error"), transmit.error ? QJsonValue(transmit.error->degrees()) : QJsonValue()}};
    }
    return QJsonDocument(all).toJson(QJsonDocument::Compact);
}

}  // namespace

StationShell::StationShell(Station station, EventLog& log, const Clock& clock, QObject* parent)
    : m_station(std::move(station)),
      m_lines(log, clock, kShellLinesPerSecond),
      m_server([this](const local::LocalRequest& asked) { return obey(asked); }, parent)
{}

void StationShell::open(std::uint16_t port)
{
    if (!m_runtimeFolder) {
        return;
    }
    const Result<> listening = m_server.listen(*m_runtimeFolder, port);
    if (listening) {
        m_lines.insist(Severity::Advisory, shellSource().name, Text::tr("listening on %1").arg(m_server.path()));
        return;
    }
    // A program without a session of its user has no folder for it.
    const bool isUsual = listening.error().code == ErrorCode::NotAvailable;
    m_lines.insist(isUsual ? Severity::Advisory : Severity::Warning, shellSource().name,
                   Text::tr("The local socket did not open: %1. Commands of the shell that need it do not reach this "
                            "station.")
                       .arg(listening.error().text));
}

local::LocalAnswer StationShell::obey(const local::LocalRequest& asked)
{
    if (asked.command == local::LocalCommand::Satellites) {
        return satelliteLines();
    }
    if (asked.command == local::LocalCommand::ScheduleList) {
        return planJson(*m_station.schedule()) + '\n';
    }
    if (asked.command == local::LocalCommand::ScheduleReport) {
        return reportJson(m_station.schedule()->report) + '\n';
    }
    if (asked.command == local::LocalCommand::ScheduleRehearsal) {
        return rehearsalJson(m_station.rehearsal()) + '\n';
    }
    if (asked.command == local::LocalCommand::Transmit) {
        return transmitJson(m_station.transmit()) + '\n';
    }
    const auto request = [&]() -> local::LocalAnswer {
        return m_station.ask(requestOf(asked.command), shellSource()).map([] { return QByteArray(); });
    };
    local::LocalAnswer answer = asked.command == local::LocalCommand::Track ? track(asked.target) : request();
    if (!answer) {
        m_lines.add(
            Severity::Warning, shellSource().name,
            Text::tr("%1 refused: %2").arg(QString::fromLatin1(local::wordOf(asked.command)), answer.error().text));
    }
    return answer;
}

// The name of what it is.
local::LocalAnswer StationShell::track(const QByteArray& text)
{
    const auto free = m_station.mayShellCommand();
    if (!free) {
        return failure(free.error().code, Text::tr("%1 Take the control first.").arg(free.error().text));
    }
    if (text == kPositionWord) {
        return m_station.ask(request::FollowPosition{}, shellSource()).map([] { return QByteArray("position\n"); });
    }
    return targets::parseTarget(text.toStdString(), *m_station.satellites())
        .and_then([&](const targets::Target& target) {
            return m_station.ask(request::Track{target}, shellSource()).map([&] {
                return QByteArray(target.name.simplified().toUtf8() + '\n');
            });
        });
}

QByteArray StationShell::satelliteLines() const
{
    QByteArray lines;
    for (const orbit::ElementSet& one : *m_station.satellites()) {
        lines += local::satelliteLine(
            {.number = one.number, .epoch = orbit::utcTime(one.epoch), .name = toQString(one.name)});
    }
    return lines;
}

}  // namespace boresight
