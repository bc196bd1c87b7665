// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/units/quantity.h"

#include <optional>
#include <utility>
#include <vector>

// Decides which of the places that a drive reports are believed. A single reply can be false, and no motion may act on
// it. A reply is believed if the axis can have moved there since the last believed reply, judged by its last rate. Any
// other place is doubted. A doubted place is believed after kJump replies in a row that agree: then the angle has
// really jumped. The first place also needs kJump replies, because a drive that is on may get it as the place to hold.
// After kAgree replies without a believed place, a place where the axis is expected needs kAgree replies that agree.
// Places are turns of the output, as the drive reports them. Pure: time is passed in.
namespace boresight::supervision {

class PlaceBelief
{
public:
    static constexpr int kAgree = 3;
    static constexpr SteadyTime::duration kForgotten = std::chrono::milliseconds(200);
    static constexpr int kJump = 6;  // if one reply in ten has the same false place, six in a row come once in hours

    struct Limits
    {
        MotorTurns allowance;  // error of encoder and control, added to what the motion explains
        MotorRate speed;       // the fastest motion of the profile
    };
    struct Reply
    {
        SteadyTime asked{};  // the question was not sent earlier, so the drive has measured later than this
        SteadyTime received{};
        std::optional<MotorTurns> place{};  // empty: the drive does not know it
    };
    struct Place
    {
        MotorTurns position;
        MotorTurns moved;  // since the previous believed reply
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
    // Call when the drive was away. Its place is unknown until its replies agree. A new place is then not a jump.
    void forget();
    // Call when the position of the drive is set on purpose. Like forget(), but place() is kept meanwhile.
    void expectAnother();

    // The last believed place. Empty before the first one, and when no reply was believed for kForgotten.
    [[nodiscard]] const std::optional<Place>& place() const { return m_place; }
    [[nodiscard]] bool believedLast() const { return m_place && m_without == 0; }

    // Returned once, after a doubted place has turned out to be false: the axis is where it was expected.
    [[nodiscard]] std::optional<Leap> takeFalsePlace() { return std::exchange(m_false, std::nullopt); }
    // Returned once, after agreeing replies have shown that the place has jumped.
    [[nodiscard]] std::optional<Leap> takeJump() { return std::exchange(m_jump, std::nullopt); }
    [[nodiscard]] bool jumped() const { return m_jump.has_value(); }

private:
    // A place, and the rate of the axis at this place.
    struct Course
    {
        MotorTurns place;
        std::optional<MotorRate> rate;  // empty: a single reply does not show it
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
    std::vector<Course> m_believed;   // replies are compared with these; newest at the end
    std::optional<Course> m_doubted;  // the last of the doubted replies that agree
    int m_agreeing = 0;
    bool m_skipped = false;         // the previous reply was skipped
    std::optional<Course> m_rival;  // the last skipped place; the axis may be there instead
    int m_without = 0;              // replies in a row without a believed place
    std::optional<Place> m_place;
    std::optional<Leap> m_doubt;  // to the first doubted place; empty: the axis is expected there
    std::optional<Leap> m_false;
    std::optional<Leap> m_jump;
};

}  // namespace boresight::supervision
