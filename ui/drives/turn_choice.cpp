// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/drives/turn_choice.h"

#include <algorithm>

namespace boresight::ui {

namespace {
// An angle that was entered is valid for the position where it was read. This tolerance is smaller than a person can
// read on a scale.
constexpr Angle kMoved = 0.1_deg;
}  // namespace

void TurnChoice::begin(const TurnQuestion& question)
{
    m_question = question;
    m_byOperator = false;
    m_angle = proposed();
}

void TurnChoice::follow(const TurnQuestion& question)
{
    m_question = question;
    if (!m_byOperator) {
        m_angle = proposed();
    } else if (m_angle && question.candidates.empty()) {
        m_angle = abs(question.movedSince - m_pickedAt) < kMoved ? m_angle : std::nullopt;
    } else if (m_angle) {
        const std::optional<Angle> same = nearest(*m_angle);
        m_angle = same && abs(*same - *m_angle) < question.period / 4.0 ? same : std::nullopt;
    }
}

void TurnChoice::pick(Angle angle)
{
    m_byOperator = true;
    m_angle = angle;
    m_pickedAt = m_question.movedSince;
}

void TurnChoice::enter(Angle about)
{
    const std::optional<Angle> place = nearest(about);
    if (place && abs(*place - about) > m_question.period / 2.0) {
        clear();  // beyond the stops: the entered angle is none of the candidates
    } else {
        pick(place.value_or(about));
    }
}

void TurnChoice::clear()
{
    m_byOperator = true;
    m_angle.reset();
}

std::optional<Angle> TurnChoice::proposed() const
{
    return m_question.proposed ? nearest(*m_question.proposed) : std::nullopt;
}

std::optional<Angle> TurnChoice::nearest(Angle angle) const
{
    const auto closer = [angle](Angle a, Angle b) { return abs(a - angle) < abs(b - angle); };
    const auto found = std::min_element(m_question.candidates.begin(), m_question.candidates.end(), closer);
    return found == m_question.candidates.end() ? std::nullopt : std::optional(*found);
}

std::optional<std::size_t> TurnChoice::index() const
{
    const auto found = m_angle ? std::find(m_question.candidates.begin(), m_question.candidates.end(), *m_angle)
                               : m_question.candidates.end();
    return found == m_question.candidates.end()
               ? std::nullopt
               : std::optional(static_cast<std::size_t>(found - m_question.candidates.begin()));
}

}  // namespace boresight::ui
