// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/supervision/axis_observation.h"
#include "core/units/sky.h"

#include <array>
#include <cstddef>
#include <optional>

// What the supervisor remembers of the motion of one axis, each piece for one symptom. Pure; all judge by measured
// angles, because a rate near rest is mostly noise of the encoder. Given fresh replies only.
namespace boresight::supervision {

// Command and motion since the axis last obeyed: for "does not move" and "moves the wrong way". Each
// place is judged with the two before it, so that one that is false by too little to be doubted counts for nothing.
class Progress
{
public:
    void look(const AxisObservation& seen);
    void forget();

    [[nodiscard]] Angle asked() const { return m_asked; }                  // signed, set-point since the anchor
    [[nodiscard]] Angle moved() const { return m_moved; }                  // signed, axis since the anchor
    [[nodiscard]] Seconds underCommand() const { return m_underCommand; }  // time with a moving set-point since then
    [[nodiscard]] bool missing() const;                                    // asked to move and has hardly moved
    [[nodiscard]] Angle against() const;                                   // moved against the command; 0 if with it
    [[nodiscard]] bool slowsDown() const { return m_slowsDown; }  // its motion against the command, or has ended

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
    std::array<Angle, 3> m_behind{};  // the axis against its set-point, in the last replies
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

// How far an axis has moved that should stand still: from where it rested after its set-point came to rest, or after
// the drive was left off.
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
    std::optional<Angle> m_candidate;   // not known yet to rest there
    SteadyTime m_still{};               // at the candidate since
    std::optional<SteadyTime> m_since;  // should stand since
    Angle m_actual;
    Angle m_lastCommanded;
    bool m_lastEngaged = false;
};

// Beyond the travel, and whether on the way farther out.
class Outside
{
public:
    void look(const AxisObservation& seen, const TravelRange& travel);
    void forget() { *this = Outside(); }

    [[nodiscard]] Angle beyond() const { return m_beyond; }
    [[nodiscard]] bool outwards() const { return m_outwards; }

private:
    Angle m_beyond;
    std::optional<Angle> m_reference;  // where it last was on the way out or in
    SteadyTime m_moved{};
    bool m_outwards = false;
};

}  // namespace boresight::supervision
