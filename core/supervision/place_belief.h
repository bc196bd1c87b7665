// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/units/quantity.h"

#include <optional>
#include <utility>
#include <vector>

// Decides which of the places that a drive reports are believed. A single reply can be false: motion must not act on
// it. A reply is believed if the axis can have got there since the last believed one, judged by how fast it moved. Any
// other place is doubted, and is believed only after kJump replies in a row that agree with each other: then the angle
// has really jumped. A first place needs as many: the drive may be on and may get it as the place to hold. After some
// replies without a place, kAgree that agree are enough where the axis is expected. Pure: time is passed in. Turns of
// the output, as the drive reports them.
namespace boresight::supervision {

class PlaceBelief
{
public:
    static constexpr int kAgree = 3;
    static constexpr SteadyTime::duration kForgotten = std::chrono::milliseconds(200);
    static constexpr int kJump = 6;  // of one reply in ten that are false alike, six come in a row once in hours

    struct Limits
    {
        MotorTurns allowance;  // of encoder and control, beyond what the motion explains
        MotorRate speed;       // the fastest motion of the profile
    };
    struct Reply
    {
        SteadyTime asked{};  // the question was not sent before this: the drive has measured since then
        SteadyTime received{};
        std::optional<MotorTurns> place{};  // empty: the drive does not know it
    };
    struct Place
    {
        MotorTurns position;
        MotorTurns moved;  // since the believed reply before
        SteadyTime received{};
    };
    struct Leap
    {
        MotorTurns from;  // where the axis was expected
        MotorTurns to;
        Seconds within{0.0};  // since the last believed reply
    };

    explicit PlaceBelief(const Limits& limits) : m_limits(limits) {}
    void setLimits(const Limits& limits) { m_limits = limits; }

    void take(const Reply& reply);
    // The drive was away: where it is now is not known before its replies agree, and is no jump.
    void forget();
    // Its position is set on purpose: the same, but place() stays until then.
    void expectAnother();

    // The last believed place. Empty before the first one, and when replies have come without one for kForgotten.
    [[nodiscard]] const std::optional<Place>& place() const { return m_place; }
    [[nodiscard]] bool believedLast() const { return m_place && m_without == 0; }

    // Once after a doubted place has turned out to be false: the axis is where it was expected.
    [[nodiscard]] std::optional<Leap> takeFalsePlace() { return std::exchange(m_false, std::nullopt); }
    // Once after replies that agree with each other have shown that the place has jumped.
    [[nodiscard]] std::optional<Leap> takeJump() { return std::exchange(m_jump, std::nullopt); }
    [[nodiscard]] bool jumped() const { return m_jump.has_value(); }

private:
    // A place and how fast the axis moved there.
    struct Course
    {
        MotorTurns place;
        std::optional<MotorRate> rate;  // empty: not known from one reply
        SteadyTime asked{};
        SteadyTime received{};
    };

    [[nodiscard]] MotorRate gain(const Course& course, Seconds within) const;
    [[nodiscard]] static MotorTurns miss(const Course& course, const Reply& reply);
    [[nodiscard]] bool reaches(const Course& course, const Reply& reply) const;
    [[nodiscard]] Course continued(const Course& course, const Reply& reply) const;
    [[nodiscard]] const Course* courseTo(const Reply& reply) const;
    [[nodiscard]] std::optional<Leap> leapTo(const Reply& reply) const;
    void believe(const Course& course);
    [[nodiscard]] bool skip();
    [[nodiscard]] bool rivals(const Reply& reply);
    void passWithout(SteadyTime now);

    Limits m_limits;
    std::vector<Course> m_believed;   // what replies are compared with, the last one at the end
    std::optional<Course> m_doubted;  // the last of those that agree with each other
    int m_agreeing = 0;
    bool m_skipped = false;         // the reply before
    std::optional<Course> m_rival;  // the last of those that were skipped where the axis could be just as well
    int m_without = 0;              // replies in a row without a believed place
    std::optional<Place> m_place;
    std::optional<Leap> m_doubt;  // to the first of them
    std::optional<Leap> m_false;
    std::optional<Leap> m_jump;
};

}  // namespace boresight::supervision
