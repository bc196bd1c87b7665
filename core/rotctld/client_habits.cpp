// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotctld/client_habits.h"

#include "core/base/control_characters.h"
#include "core/base/text.h"
#include "core/rotctld/c_number.h"

#include <algorithm>

namespace boresight::rotctld {

QString shownText(std::string_view bytes)
{
    QString text = toQString(bytes.substr(0, kShownBytes));
    std::ranges::replace_if(
        text, [](QChar c) { return !c.isPrint() || c == QChar::ReplacementCharacter; }, QChar(u'.'));
    return text;
}

bool asksForMotion(const Command& command)
{
    const CommandId id = command.spec->id;
    return id == CommandId::SetPosition || id == CommandId::Move || id == CommandId::Park;
}

void ClientHabits::take(const Command& command, SteadyTime now)
{
    m_last = {};
    if (command.spec->letter < 0x80) {
        m_last.command += static_cast<char>(command.spec->letter);
    } else {
        m_last.command.append(command.spec->name);
    }
    for (std::size_t i = 0; i < command.argumentCount; ++i) {
        m_last.command.append(" ").append(command.arguments[i]);
    }
    m_lastId = command.spec->id;
    m_lastActs = asksForMotion(command) || command.spec->id == CommandId::Stop;
    m_rate.count(now);
    noteMotion(command, now);
}

void ClientHabits::take(std::string_view command, const LineOutcome& outcome, SteadyTime now)
{
    m_last = {.command = std::string(command)};
    m_lastId.reset();
    m_lastActs = outcome.motion || outcome.stop;
    m_rate.count(now);
    if (outcome.motion) {
        m_lastMotion = now;
    }
    if (outcome.point) {
        m_steps.observe(*outcome.point, now);
    }
}

void ClientHabits::answered(const Result<>& outcome, const QString& became)
{
    m_last.became = became;
    m_last.refusal = outcome ? QString() : printable(outcome.error().text);
    if (m_lastActs) {
        m_act = m_last;
    }
    noteError(outcome);
}

void ClientHabits::noteError(const Result<>& outcome)
{
    if (m_lastId == CommandId::SetPosition) {
        m_errors.target(outcome);
    } else if (m_lastId == CommandId::GetPosition) {
        m_errors.reading(outcome);
    }
}

QString ClientHabits::lastInWords() const
{
    const Answered& shown = m_act && m_last.refusal.isEmpty() ? *m_act : m_last;
    const QString command = shownText(shown.command);
    if (!shown.refusal.isEmpty()) {
        return Text::tr("%1: refused. %2").arg(command, shown.refusal);
    }
    return shown.became.isEmpty() ? command : QStringLiteral("%1 → %2").arg(command, shown.became);
}

void ClientHabits::noteMotion(const Command& command, SteadyTime now)
{
    if (asksForMotion(command)) {
        m_lastMotion = now;
    }
    if (command.spec->id != CommandId::SetPosition || command.argumentCount < 2) {
        return;
    }
    const auto azimuth = leadingPosition(command.arguments[0]);
    const auto elevation = leadingPosition(command.arguments[1]);
    if (azimuth && elevation) {
        m_steps.observe({.azimuth = Angle::fromDegrees(static_cast<double>(*azimuth)),
                         .elevation = Angle::fromDegrees(static_cast<double>(*elevation))},
                        now);
    }
}

}  // namespace boresight::rotctld
