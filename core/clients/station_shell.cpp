// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/clients/station_shell.h"

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/base/time_of_day.h"
#include "core/budget/budget_text.h"
#include "core/elements/julian_date.h"
#include "core/messages/state_word.h"
#include "core/night/schedule_json.h"
#include "core/records/iso_time.h"
#include "core/targets/target_text.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <cmath>

namespace boresight {
namespace {

constexpr int kShellLinesPerSecond = 4;
// In one answer. Their texts take the station 0.1 ms. Those of all lines would take 2 ms of a tick.
constexpr std::size_t kProtocolLines = 100;
// Words that a shell can send in place of a target.
const QByteArray kPositionWord = "position";
const QByteArray kAzelWord = "azel.dat";

Source shellSource()
{
    return {.kind = SourceKind::Operator, .name = QStringLiteral("shell")};
}

Request requestOf(const local::LocalRequest& asked)
{
    switch (asked.command) {
        case local::LocalCommand::Take:
            return request::TakeAuthority{};
        case local::LocalCommand::Release:
            return request::GiveAuthority{};
        case local::LocalCommand::ResetStop:
            return request::ResetStop{};
        case local::LocalCommand::OverrideWind:
            return request::OverrideWind{};
        case local::LocalCommand::UseNewTime:
            return request::UseNewTime{};
        case local::LocalCommand::ScheduleArm:
            return request::ArmSchedule{};
        case local::LocalCommand::ScheduleDisarm:
            return request::DisarmSchedule{};
        case local::LocalCommand::ScheduleRehearse:
            return request::Rehearse{};
        case local::LocalCommand::UseAntenna:
            return request::UseAntenna{asked.target.toStdString()};
        case local::LocalCommand::TypeLine:
            return request::TypeLine{asked.target.toStdString()};
        case local::LocalCommand::ProtocolLogOn:
            return request::LogProtocol{.on = true};
        case local::LocalCommand::ProtocolLogOff:
            return request::LogProtocol{.on = false};
        case local::LocalCommand::Stop:
        case local::LocalCommand::Track:
        case local::LocalCommand::Satellites:
        case local::LocalCommand::Antennas:
        case local::LocalCommand::ScheduleList:
        case local::LocalCommand::ScheduleReport:
        case local::LocalCommand::ScheduleRehearsal:
        case local::LocalCommand::Status:
        case local::LocalCommand::Transmit:
        case local::LocalCommand::Simulate:
        case local::LocalCommand::ConsoleLines:
        case local::LocalCommand::ProtocolLines:
            break;
    }
    return request::Stop{};
}

QJsonObject windObject(const WindStatus& wind)
{
    return {{QStringLiteral("speed"), wind.speed ? QJsonValue(*wind.speed) : QJsonValue()},
            {QStringLiteral("age"), wind.speed ? QJsonValue(wind.age.count()) : QJsonValue()},
            {QStringLiteral("silent"), wind.isSilent},
            {QStringLiteral("obstacle"), wind.obstacle},
            {QStringLiteral("overriddenUntil"),
             wind.overriddenUntil ? QJsonValue(timeOfDayText(*wind.overriddenUntil)) : QJsonValue()}};
}

QJsonArray alarmTexts(const std::vector<Alarm>& alarms)
{
    QJsonArray texts;
    for (const Alarm& alarm : alarms) {
        if (alarm.active) {
            texts.append(QStringList({alarm.what, alarm.action, alarm.remedy}).join(QLatin1Char(' ')));
        }
    }
    return texts;
}

QJsonObject brakeObject(const BrakeStatus& brake)
{
    return {{QStringLiteral("state"), protocolWord(brake)},
            {QStringLiteral("output"), brake.output},
            {QStringLiteral("problem"), brake.problem}};
}

QJsonArray endSwitchArray(const std::vector<EndSwitchStatus>& switches)
{
    QJsonArray all;
    for (const EndSwitchStatus& one : switches) {
        all.append(QJsonObject{{QStringLiteral("end"), protocolWord(one.which)},
                               {QStringLiteral("state"), protocolWord(one.state)},
                               {QStringLiteral("input"), one.input},
                               {QStringLiteral("problem"), one.problem}});
    }
    return all;
}

QJsonValue numberOf(const std::optional<double>& value)
{
    return value ? QJsonValue(*value) : QJsonValue();
}

QJsonObject thirdAxisObject(const ThirdAxisStatus& axis)
{
    const auto degrees = [](const auto& value) { return value ? std::optional(value->degrees()) : std::nullopt; };
    return {{QStringLiteral("name"), axis.name},
            {QStringLiteral("state"), protocolWord(axis.state)},
            {QStringLiteral("angle"), numberOf(degrees(axis.place))},
            {QStringLiteral("rate"), numberOf(degrees(axis.rate))},
            {QStringLiteral("mode"), axis.mode},
            {QStringLiteral("fault"), axis.fault},
            {QStringLiteral("boardTemperature"), numberOf(axis.boardTemperature)}};
}

// To a ten thousandth of a degree.
double shownDegrees(Angle angle)
{
    constexpr double kSteps = 1e4;
    return std::round(angle.degrees() * kSteps) / kSteps;
}

QJsonObject budgetObject(const budget::ErrorBudget& budget)
{
    QJsonArray parts;
    for (const budget::ErrorLine& line : budget.lines) {
        parts.append(
            QJsonObject{{QStringLiteral("part"), QString::fromLatin1(budget::keyOf(line.part))},
                        {QStringLiteral("degrees"), line.error ? QJsonValue(shownDegrees(*line.error)) : QJsonValue()},
                        {QStringLiteral("from"), line.basis}});
    }
    return {{QStringLiteral("degrees"), shownDegrees(budget.sum)},
            {QStringLiteral("whole"), budget.isWhole},
            {QStringLiteral("loss"), numberOf(budget.loss)},
            {QStringLiteral("text"), budget::offByText(budget)},
            {QStringLiteral("parts"), parts}};
}

// The state as the header of the window shows it. `motion` is what the mount does now.
QByteArray statusJson(const StationStatus& status)
{
    const QString reason = status.stateReason == status.targetText ? QString() : status.stateReason;
    QJsonObject all{{QStringLiteral("state"), protocolWord(status.state)},
                    {QStringLiteral("reason"), reason},
                    {QStringLiteral("motion"), status.targetText}};
    if (status.tracked && status.tracked->next) {
        all[status.tracked->isUp ? QStringLiteral("sets") : QStringLiteral("rises")] =
            records::isoTime(*status.tracked->next);
    }
    if (status.schedule->armed) {
        all[QStringLiteral("schedule")] = QStringLiteral("armed");
    }
    if (const QJsonArray alarms = alarmTexts(status.alarms); !alarms.isEmpty()) {
        all[QStringLiteral("alarms")] = alarms;
    }
    if (!status.wind.source.isEmpty()) {
        all[QStringLiteral("wind")] = windObject(status.wind);
    }
    if (!status.brake.output.isEmpty()) {
        all[QStringLiteral("brake")] = brakeObject(status.brake);
    }
    if (!status.endSwitches.empty()) {
        all[QStringLiteral("endSwitches")] = endSwitchArray(status.endSwitches);
    }
    if (status.thirdAxis) {
        all[QStringLiteral("thirdAxis")] = thirdAxisObject(*status.thirdAxis);
    }
    if (status.errorBudget) {
        all[QStringLiteral("errorBudget")] = budgetObject(*status.errorBudget);
    }
    if (status.clock.ahead) {
        all[QStringLiteral("clockSetBy")] = status.clock.ahead->count();
    }
    return QJsonDocument(all).toJson(QJsonDocument::Compact);
}

// An object without fields means that the profile names no output.
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

// Only a mount with a control box has them.
local::LocalAnswer consoleJson(const std::optional<QStringList>& lines)
{
    if (!lines) {
        return failure(ErrorCode::NotAvailable, Text::tr("This mount has no control box that takes typed lines."));
    }
    return QJsonDocument(QJsonArray::fromStringList(*lines)).toJson(QJsonDocument::Compact) + '\n';
}

}  // namespace

StationShell::StationShell(Station station, EventLog& log, const Clock& clock, QObject* parent)
    : m_station(std::move(station)),
      m_lines(log, clock, kShellLinesPerSecond),
      m_server([this](const local::LocalRequest& asked, const local::Reply& reply) { obey(asked, reply); }, parent)
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
    // NotAvailable is usual: a program outside a user session has no folder for sockets.
    const bool isUsual = listening.error().code == ErrorCode::NotAvailable;
    m_lines.insist(isUsual ? Severity::Advisory : Severity::Warning, shellSource().name,
                   Text::tr("The local socket did not open: %1. Commands of the shell that need it do not reach this "
                            "station.")
                       .arg(listening.error().text));
}

void StationShell::obey(const local::LocalRequest& asked, const local::Reply& reply)
{
    if (asked.command == local::LocalCommand::Track) {
        track(asked.target, [=, this](const local::LocalAnswer& answer) { reply(told(asked, answer)); });
    } else {
        reply(answerNow(asked));
    }
}

local::LocalAnswer StationShell::answerNow(const local::LocalRequest& asked)
{
    if (asked.command == local::LocalCommand::Satellites) {
        return satelliteLines();
    }
    if (asked.command == local::LocalCommand::Antennas) {
        return antennaLines();
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
    if (asked.command == local::LocalCommand::Status) {
        return statusJson(m_station.status()) + '\n';
    }
    if (asked.command == local::LocalCommand::ConsoleLines) {
        return consoleJson(m_station.status().console);
    }
    if (asked.command == local::LocalCommand::ProtocolLines) {
        return protocolLines(asked.target);
    }
    if (asked.command == local::LocalCommand::Transmit) {
        return transmitJson(m_station.transmit()) + '\n';
    }
    if (asked.command == local::LocalCommand::Simulate) {
        return told(asked, simulate(asked.target));
    }
    return told(asked, m_station.ask(requestOf(asked), shellSource()).map([] { return QByteArray(); }));
}

// A fault of the simulated mount is no act of the operator, so it changes nothing but that mount.
local::LocalAnswer StationShell::simulate(const QByteArray& text)
{
    return m_station.simulate(text).map([this](const QString& words) {
        m_lines.insist(Severity::Advisory, shellSource().name, words);
        return QByteArray(words.toUtf8() + '\n');
    });
}

// Returns the answer and logs a refusal.
local::LocalAnswer StationShell::told(const local::LocalRequest& asked, local::LocalAnswer answer)
{
    if (!answer) {
        m_lines.add(
            Severity::Warning, shellSource().name,
            Text::tr("%1 refused: %2").arg(QString::fromLatin1(local::wordOf(asked.command)), answer.error().text));
    }
    return answer;
}

Result<> StationShell::mayTrack() const
{
    return m_station.mayShellCommand().map_error([](const Error& error) {
        return Error{error.code, Text::tr("%1 Take the control first.").arg(error.text)};
    });
}

// Reading a file or asking another rotator takes time, so the permission to track is checked again afterwards.
void StationShell::track(const QByteArray& text, const local::Reply& reply)
{
    const Result<> may = mayTrack();
    if (!may) {
        reply(tl::unexpected(may.error()));
        return;
    }
    if (text == kPositionWord) {
        reply(m_station.ask(request::FollowPosition{}, shellSource()).map([] { return QByteArray("position\n"); }));
        return;
    }
    if (text == kAzelWord) {
        reply(m_station.ask(request::FollowAzel{}, shellSource()).map([] { return QByteArray("azel.dat\n"); }));
        return;
    }
    if (const auto file = targets::tableFile(text.toStdString())) {
        m_station.readTable(*file, [this, reply](const Result<targets::Target>& table) {
            reply(table.and_then([this](const targets::Target& target) { return track(target); }));
        });
        return;
    }
    if (const auto other = targets::otherRotator(text.toStdString())) {
        m_station.findRotator(*other, [this, reply](const Result<QString>& found) {
            const local::LocalAnswer answer = found.and_then([this](const QString& name) { return follow(name); });
            reply(answer);
            return answer.map([](const QByteArray&) {});
        });
        return;
    }
    reply(targets::parseTarget(text.toStdString(), *m_station.satellites())
              .and_then([this](const targets::Target& target) { return track(target); }));
}

// The answer is the name of the target.
local::LocalAnswer StationShell::track(const targets::Target& target)
{
    return mayTrack().and_then([&] { return m_station.ask(request::Track{target}, shellSource()); }).map([&] {
        return QByteArray(target.name.simplified().toUtf8() + '\n');
    });
}

local::LocalAnswer StationShell::follow(const QString& rotator)
{
    return mayTrack().and_then([&] { return m_station.ask(request::FollowRotator{rotator}, shellSource()); }).map([&] {
        return QByteArray(rotator.toUtf8() + '\n');
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

QByteArray StationShell::antennaLines() const
{
    QByteArray lines;
    for (const local::KnownAntenna& one : m_station.antennas()) {
        lines += local::antennaLine(one);
    }
    return lines;
}

// Each line has its number first, so that the next question can continue after it.
local::LocalAnswer StationShell::protocolLines(const QByteArray& after) const
{
    const auto number = parseInteger(after.toStdString());
    if (!number || *number < 0) {
        return failure(ErrorCode::InvalidInput, Text::tr("Write protocol-lines with the number of the last line that "
                                                         "you know. The first lines come after 0."));
    }
    QByteArray text;
    if (const ProtocolLines lines = m_station.protocolLines(static_cast<std::uint64_t>(*number), kProtocolLines)) {
        for (const ProtocolLine& line : *lines) {
            text += QByteArray::number(static_cast<qulonglong>(line.number)) + '\t' + fileText(line).toUtf8() + '\n';
        }
    }
    return text;
}

}  // namespace boresight
