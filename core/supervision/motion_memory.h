// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/supervision/axis_observation.h"
#include "core/units/sky.h"

#include <array>
#include <cstddef>
#include <optional>

// The memory of the supervisor about the motion of one axis. All classes judge by measured angles, because a measured
// rate near standstill is mostly noise of the encoder. They get fresh replies only. Pure.
namespace boresight::supervision {

// Command and motion since the axis last obeyed: for "does not move" and "moves the wrong way". Each place is judged
// together with the two before it. A single place with an error too small to be doubted then has no effect.
class Progress
{
public:
    void look(const AxisObservation& seen);
    void forget();

    [[nodiscard]] Angle asked() const { return m_asked; }  // signed, motion of the set-point since the anchor
    [[nodiscard]] Angle moved() const { return m_moved; }  // signed, motion of the axis since the anchor
    [[nodiscard]] Seconds underCommand() const { return m_underCommand; }  // time with a moving set-point since then
    [[nodiscard]] bool missing() const;                                    // commanded to move, but has hardly moved
    [[nodiscard]] Angle against() const;                                   // motion against the command; 0 if it obeys
    [[nodiscard]] bool slowsDown() const { return m_slowsDown; }  // motion against the command slows down or has ended

private:
    struct Anchor
    {
        Angle commanded;
        Angle actual;
    };
    [[nodiscard]] std::optional<Angle> actual(const AxisObservation& seen);
    void compare(const Anchor& now, const AxisObservation& seen, Seconds passed);
    void anchorAt(const Anchor& place);
    void lookAtRate(Angle actual, Seconds passed);

    std::optional<Anchor> m_anchor;
    std::array<Angle, 3> m_behind{};  // axis minus set-point, in the last three replies
    std::size_t m_replies = 0;
    SteadyTime m_last{};
    Angle m_lastCommanded;
    Angle m_lastActual;
    AngularRate m_lastRate;
    bool m_slowsDown = false;
    Angle m_asked;
    Angle m_moved;
    Seconds m_underCommand{0.0};
};

// How far an axis has moved that should stand still. The reference is where the axis stood still after its set-point
// stopped, or after its drive was engaged or released.
class Standing
{
public:
    void look(const AxisObservation& seen);
    void forget() { *this = Standing(); }

    // Empty while the axis may move.
    [[nodiscard]] std::optional<Angle> moved() const;

private:
    [[nodiscard]] bool shouldStand(const AxisObservation& seen);

    std::optional<Angle> m_rested;      // where it should stand
    std::optional<Angle> m_candidate;   // where it may stand still
    SteadyTime m_still{};               // since when it is at the candidate
    std::optional<SteadyTime> m_since;  // since when it should stand
    Angle m_actual;
    Angle m_lastCommanded;
    bool m_lastEngaged = false;
};

// How far the axis is beyond its travel, and whether it moves farther out.
class Outside
{
public:
    void look(const AxisObservation& seen, const TravelRange& travel);
    void forget() { *this = Outside(); }

    [[nodiscard]] Angle beyond() const { return m_beyond; }
    [[nodiscard]] bool outwards() const { return m_outwards; }

private:
    Angle m_beyond;
    std::optional<Angle> m_reference;  // m_beyond at the last motion out or in
    SteadyTime m_moved{};
    bool m_outwards = false;
};

}  // namespace boresight::supervision
