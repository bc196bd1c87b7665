// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/drives_status.h"

#include <optional>

// The answer that the operator is about to give to the question about a wrap: the proposed candidate until the operator
// picks another. The axis may be jogged meanwhile. Then the candidates move, and the picked one is tracked. If it
// cannot be tracked the choice is cleared. Pure.
namespace boresight::ui {

class TurnChoice
{
public:
    void begin(const TurnQuestion& question);   // a new question
    void follow(const TurnQuestion& question);  // the same question, a moment later

    void pick(Angle angle);   // one of the candidates
    void enter(Angle about);  // the nearest candidate if it is near enough; without candidates the angle itself
    void clear();

    [[nodiscard]] const TurnQuestion& question() const { return m_question; }
    [[nodiscard]] std::optional<Angle> angle() const { return m_angle; }
    [[nodiscard]] std::optional<std::size_t> index() const;  // index of the candidate

private:
    [[nodiscard]] std::optional<Angle> proposed() const;
    [[nodiscard]] std::optional<Angle> nearest(Angle angle) const;

    TurnQuestion m_question;
    std::optional<Angle> m_angle;
    Angle m_pickedAt;  // how far the axis had moved when it was picked
    bool m_byOperator = false;
};

}  // namespace boresight::ui
