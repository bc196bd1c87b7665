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

void ClientHabits::take(const Command& command, SteadyTime now)
{
    m_lastCommand.clear();
    m_lastRefusal.clear();
    m_became.clear();
    if (command.spec->letter < 0x80) {
        m_lastCommand += static_cast<char>(command.spec->letter);
    } else {
        m_lastCommand.append(command.spec->name);
    }
    for (std::size_t i = 0; i < command.argumentCount; ++i) {
        m_lastCommand.append(" ").append(command.arguments[i]);
    }
    m_rate.count(now);
    noteMotion(command, now);
}

void ClientHabits::take(std::string_view command, bool motion, const std::optional<SkyPointing>& point, SteadyTime now)
{
    m_lastCommand = command;
    m_lastRefusal.clear();
    m_became.clear();
    m_rate.count(now);
    if (motion) {
        m_lastMotion = now;
    }
    if (point) {
        m_steps.observe(*point, now);
    }
}

void ClientHabits::answered(const Result<>& outcome, const QString& became)
{
    m_became = became;
    m_lastRefusal = outcome ? QString() : printable(outcome.error().text);
}

QString ClientHabits::lastInWords() const
{
    if (!m_lastRefusal.isEmpty()) {
        return Text::tr("%1: refused. %2").arg(lastCommand(), m_lastRefusal);
    }
    return m_became.isEmpty() ? lastCommand() : QStringLiteral("%1 → %2").arg(lastCommand(), m_became);
}

void ClientHabits::noteMotion(const Command& command, SteadyTime now)
{
    const CommandId id = command.spec->id;
    if (id == CommandId::SetPosition || id == CommandId::Move || id == CommandId::Park) {
        m_lastMotion = now;
    }
    if (id != CommandId::SetPosition || command.argumentCount < 2) {
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
