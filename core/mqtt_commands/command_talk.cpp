// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mqtt_commands/command_talk.h"

#include "core/base/text.h"
#include "core/base/trimmed.h"

#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <utility>
#include <variant>

namespace boresight::mqtt {
namespace {

using rotctld::LineOutcome;
using rotctld::shownText;

std::string_view textOf(const QByteArray& message)
{
    return {message.constData(), static_cast<std::size_t>(message.size())};
}

// In a text of several lines the last word decides.
bool asksForStop(std::string_view line)
{
    std::string end(line.substr(line.size() - std::min(line.size(), CommandTalk::kLongest)));
    std::ranges::replace_if(
        end, [](char one) { return one == '\r' || one == '\n'; }, ' ');
    return pairs::endsInStop(end);
}

bool asksForHold(std::string_view line)
{
    return line.size() <= CommandTalk::kLongest && pairs::isHold(line);
}

// A relative step could arrive twice and would then move twice as far. A single number may be the value of a sensor.
bool namesItsPlace(const pairs::Command& command)
{
    const auto* const place = std::get_if<pairs::Place>(&command);
    return place == nullptr ? !std::holds_alternative<pairs::MoveBy>(command) : place->azimuth.has_value();
}

QByteArray answerText(std::string_view line, const LineOutcome& outcome)
{
    const QJsonObject all{{QStringLiteral("command"), shownText(line)},
                          {QStringLiteral("ok"), outcome.result.has_value()},
                          {QStringLiteral("answer"), QString::fromStdString(outcome.reply).trimmed()}};
    return QJsonDocument(all).toJson(QJsonDocument::Compact);
}

bool moves(const pairs::Command& command)
{
    return !std::holds_alternative<pairs::Report>(command) && !std::holds_alternative<pairs::Stop>(command);
}

}  // namespace

CommandTalk::CommandTalk(rotctld::Client client, rotctld::Rotator& rotator, const Clock& clock, pairs::SiteNow site,
                         LatchStop latchStop)
    : m_client(std::move(client)),
      m_rotator(rotator),
      m_clock(clock),
      m_latchStop(std::move(latchStop)),
      m_talk(m_client, rotator, std::move(site)),
      m_habits(clock.now()),
      m_settling(clock),
      m_budget(clock.now())
{
    m_settling.begin();
}

std::optional<QByteArray> CommandTalk::obey(const QByteArray& message, Retain retain)
{
    const std::string_view line = trimmed(textOf(message));  // a script ends a message with a line end
    if (asksForStop(line)) {
        return latch(message, line, retain);
    }
    const bool flood = isFlood();
    const bool isHold = asksForHold(line);
    if (flood && !isHold) {
        if (m_rotator.isLoggingExchanges()) {
            logMessage(message, {}, {.reply = {}, .result = m_budget.admits()});
        }
        return std::nullopt;
    }
    return answer(message, line, run(line, isHold, retain), flood);
}

Urgency CommandTalk::urgencyOf(const QByteArray& message)
{
    const std::string_view line = trimmed(textOf(message));
    if (asksForStop(line)) {
        return Urgency::Stop;
    }
    return asksForHold(line) ? Urgency::Hold : Urgency::None;
}

std::optional<QByteArray> CommandTalk::stop(const QByteArray& message, Retain retain)
{
    return latch(message, "stop", retain);
}

// A live STOP is always obeyed: it is neither counted nor refused within kSettling. In a flood only its answer is left
// out.
std::optional<QByteArray> CommandTalk::latch(const QByteArray& message, std::string_view line, Retain retain)
{
    LineOutcome outcome{.reply = std::string(pairs::kDone), .result = {}, .stop = true};
    if (retain == Retain::Yes) {
        outcome = refuseOld(line);
    } else if (outcome.result = m_latchStop(m_client); !outcome.result) {
        outcome.reply = pairs::refusalOf(outcome.result.error());
    }
    return answer(message, line, outcome, isFlood());
}

LineOutcome CommandTalk::run(std::string_view line, bool isHold, Retain retain)
{
    if (retain == Retain::Yes) {
        return refuseOld(line);
    }
    if (line.size() > kLongest) {
        return refuse(line, ErrorCode::InvalidInput,
                      Text::tr("A command has at most %1 bytes.").arg(QString::number(kLongest)));
    }
    if (const Result<> may = m_budget.admits(); !may && !isHold) {
        return refuse(line, may.error().code, may.error().text);
    }
    tick();
    const Result<pairs::Command> command = pairs::parseLine(line);
    if (!command) {
        return refuse(line, command.error().code, command.error().text);
    }
    if (const Result<> may = admits(*command); !may) {
        return refuse(line, may.error().code, may.error().text);
    }
    return m_talk.obey(*command);
}

LineOutcome CommandTalk::refuseOld(std::string_view line)
{
    return refuse(line, ErrorCode::Refused,
                  Text::tr("The broker kept this message, so it is old. Delete it at the broker. Send commands "
                           "without the retain flag."));
}

// Also logs the refusal. The rotator logs its own refusals.
LineOutcome CommandTalk::refuse(std::string_view line, ErrorCode code, const QString& reason)
{
    const Error error{.code = code, .text = reason};
    m_rotator.clientRemark(m_client, Text::tr("\"%1\" refused: %2").arg(shownText(line), reason));
    return {.reply = pairs::refusalOf(error), .result = tl::unexpected(error)};
}

Result<> CommandTalk::admits(const pairs::Command& command) const
{
    if (!moves(command)) {
        return {};
    }
    if (m_client.readsOnly) {
        return failure(ErrorCode::Refused,
                       Text::tr("The profile permits only stopping and reading by MQTT (mqtt.commands)."));
    }
    if (!namesItsPlace(command)) {
        return failure(ErrorCode::Refused, Text::tr("By MQTT a motion needs an azimuth and an elevation, such as "
                                                    "\"120.5 30\", because a message may arrive twice."));
    }
    if (!m_settling.isOver()) {
        return failure(ErrorCode::Refused,
                       Text::tr("Boresight connected to the broker, or continued after a "
                                "pause, less than %1 s ago. This command may be old. Send it again.")
                           .arg(rotctld::Settling::kTime.count()));
    }
    return {};
}

bool CommandTalk::isFlood()
{
    m_budget.count(m_clock.now());
    return m_budget.isFlood();
}

std::optional<QByteArray> CommandTalk::answer(const QByteArray& message, std::string_view line,
                                              const LineOutcome& outcome, bool flood)
{
    m_habits.take(line.substr(0, rotctld::kShownBytes), outcome, m_clock.now());
    m_habits.answered(outcome.result, outcome.became);
    if (isOdd(outcome)) {
        m_habits.countOdd();
    }
    const QByteArray text = flood ? QByteArray() : answerText(line, outcome);
    logMessage(message, text, outcome);
    return flood ? std::nullopt : std::optional(text);
}

void CommandTalk::logMessage(const QByteArray& message, const QByteArray& answer, const LineOutcome& outcome)
{
    if (m_rotator.isLoggingExchanges()) {
        m_rotator.logExchange(m_client, {.line = textOf(message),
                                         .command = outcome.stop ? "STOP" : "",
                                         .answer = textOf(answer),
                                         .result = outcome.result,
                                         .became = outcome.became,
                                         .odd = isOdd(outcome)});
    }
}

}  // namespace boresight::mqtt
