// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/drives_status.h"

#include <optional>

// The answer the operator is about to give to a question about the turn: the proposed candidate until he picks one.
// The axis may be jogged meanwhile; then the candidates wander, and the picked one is followed. What can not be
// followed is not picked any more. Pure.
namespace boresight::ui {

class TurnChoice
{
public:
    void begin(const TurnQuestion& question);   // a new question
    void follow(const TurnQuestion& question);  // the same, a moment later

    void pick(Angle angle);   // one of the candidates
    void enter(Angle about);  // the nearest candidate, if it is one; without candidates the angle itself
    void clear();

    [[nodiscard]] const TurnQuestion& question() const { return m_question; }
    [[nodiscard]] std::optional<Angle> angle() const { return m_angle; }
    [[nodiscard]] std::optional<std::size_t> index() const;  // of the candidate

private:
    [[nodiscard]] std::optional<Angle> proposed() const;
    [[nodiscard]] std::optional<Angle> nearest(Angle angle) const;

    TurnQuestion m_question;
    std::optional<Angle> m_angle;
    Angle m_pickedAt;  // how far the axis had moved when it was picked
    bool m_byOperator = false;
};

}  // namespace boresight::ui
