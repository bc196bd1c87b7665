// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/profile/in_force.h"
#include "core/supervision/axis_observation.h"
#include "core/supervision/motion_memory.h"
#include "core/supervision/symptom.h"
#include "core/supervision/trend.h"
#include "core/supervision/watch.h"
#include "core/units/sky.h"

#include <QString>

#include <vector>

// Checks one axis once per tick and reports what is wrong with it, independently of the drive's own fault codes. It
// decides nothing: the station stops the mount, raises the alarm and asks for a re-arm. Pure: time is passed in. Units:
// mechanical angles, Nm, V, °C. What is judged and how: README.md.
// More than 15 members: one for each thing that is watched.
namespace boresight::supervision {

class AxisSupervisor
{
public:
    // The profile outlives this.
    AxisSupervisor(Axis axis, const profile::InForce& profile);

    // Call once per tick, from the first reply on. Returns everything that is wrong now: at most one entry for each
    // symptom, stops before hints. A text keeps its numbers until the symptom becomes a stop or its value has doubled.
    [[nodiscard]] std::vector<Observed> observe(const AxisObservation& seen);

    // Call with every re-arm. Forgets what stopped the mount. A cause that still lasts stops the mount again.
    void rearmed();
    // Call when the reported angle was changed on purpose (the cable wrap was set) and when the drive was power-cycled.
    // Forgets earlier commands, measured angles and the symptoms found in them. Trends go on.
    void forgetMotion();
    // Call when the drive was silent. The silence does not count as a late reply.
    void forgetReplies();
    // Call when the axis gets a new set-point without a motion, for example when its drive was engaged. A jump of the
    // reported angle is still found, for example after a power cycle of the drive.
    void forgetCommand();

private:
    struct TrendLimit
    {
        double value = 0.0;
        bool fromBelow = true;  // a temperature rises to its limit, a supply falls to it
        double near = 0.0;      // a trend that is farther from the limit is not reported
        QString unit{};
        int decimals = 0;
    };

    void judgeMotion(const AxisObservation& seen);  // call only with a fresh reply
    void judgeFollowing(const AxisObservation& seen);
    void judgeProgress(const AxisObservation& seen);
    void judgeStanding(const AxisObservation& seen);
    void judgeJump(const AxisObservation& seen);
    void judgeTravel(const AxisObservation& seen);
    void judgeTorque(const AxisObservation& seen);
    void judgePush(const AxisObservation& seen, double share);
    void noteLimit(const AxisObservation& seen);
    [[nodiscard]] QString limit(SteadyTime now) const;  // reported by the drive in the last 0.5 s; else empty
    void judgeReplies(const AxisObservation& seen);
    void judgeSupply(const AxisObservation& seen);
    void judgeBoard(const AxisObservation& seen);
    void judgeMotor(const AxisObservation& seen);
    void judgeTrend(Watch& watch, const AxisObservation& seen, const Trend& trend, const TrendLimit& to,
                    const QString& what);

    struct Names
    {
        QString axis;  // "the azimuth"
        QString supply;
        QString board;
        QString motor;
    };
    [[nodiscard]] static Names namesOf(Axis axis);

    Axis m_axis;
    Names m_names;
    const profile::InForce& m_profile;

    std::optional<SteadyTime> m_lastReply;
    Progress m_progress;
    Standing m_standing;
    Outside m_outside;
    Trend m_supplyTrend;
    Trend m_boardTrend;
    Trend m_motorTrend;
    bool m_wasEngaged = false;
    bool m_knewTurn = false;
    QString m_limit;
    SteadyTime m_limitSeen{};

    Watch m_following{Symptom::FollowingError};
    Watch m_stalled{Symptom::Stalled};
    Watch m_pushes{Symptom::Stalled};
    Watch m_wrongWay{Symptom::WrongWay};
    Watch m_uncommanded{Symptom::MovesUncommanded};
    Watch m_jump{Symptom::EncoderJump};
    Watch m_travel{Symptom::OutsideTravel};
    Watch m_torqueGuard{Symptom::TorqueGuard};
    Watch m_torqueHigh{Symptom::TorqueHigh};
    Watch m_replies{Symptom::RepliesLate};
    Watch m_supplyLow{Symptom::SupplyLow};
    Watch m_supplyFalls{Symptom::SupplyLow};
    Watch m_supplyHigh{Symptom::SupplyHigh};
    Watch m_boardHot{Symptom::BoardHot};
    Watch m_boardWarms{Symptom::BoardHot};
    Watch m_motorHot{Symptom::MotorHot};
    Watch m_motorWarms{Symptom::MotorHot};
};

}  // namespace boresight::supervision
