// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_board.h"
#include "core/moteus_mount/drive_alarms.h"
#include "core/moteus_mount/drive_pair.h"
#include "core/moteus_mount/silence_alarms.h"
#include "core/supervision/axis_supervisor.h"
#include "core/supervision/retry_policy.h"
#include "core/tracking/axis_setpoints.h"

#include <map>
#include <optional>
#include <set>

// Watches one axis and its drive once per tick: raises and ends its alarms, and reports when the mount must stop. It
// decides nothing about motion itself. Station thread only.
namespace boresight {

class DriveWatch
{
public:
    // Facts that the station knows and the drive does not report.
    struct Context
    {
        SteadyTime now{};
        UtcTime utc{};         // the same moment, for texts
        Seconds running{0.0};  // since the start of the program, or since the bus was taken back
        bool turnKnown = false;
        // The wrap is known only from what the operator entered, and it may be wrong.
        bool turnEntered = false;
        bool turnAsked = false;  // the operator is asked for the wrap
        bool faultLatched = false;
        bool ownOrders = false;            // the program is closing: a drive may still obey our last command
        bool silenceExpected = false;      // the bus is left to other tools
        std::optional<Seconds> stalled{};  // how long this computer stalled, if the stall ended a moment ago
    };
    struct Trouble
    {
        QString what;
        bool stops = true;  // the mount must stop and be re-armed
        supervision::LossClass loss = supervision::LossClass::Motion;
        bool turnDoubtful = false;  // the reported angle must not be believed before the operator has looked
        bool gaveWay = false;       // the axis can not follow, so it must be held where it is now
        bool fellSilent = false;
    };

    DriveWatch(Axis axis, const profile::InForce& profile, AlarmBoard& alarms, SilenceAlarms& silences);

    [[nodiscard]] std::optional<Trouble> watch(Drive& drive, const tracking::Setpoint& setpoint,
                                               const Context& context);
    // The axis was re-armed, its wrap was set, its drive restarted, or this computer stalled. What the axis did before
    // that is no evidence any more.
    void forgetMotion();
    void forgetReplies() { m_supervisor.forgetReplies(); }  // this computer was late
    void engaged();                                         // its set-point was put where the axis is
    void rearmed();

private:
    // A silence that was reported and has not ended, or whose end is not reported completely.
    struct Silent
    {
        SteadyTime since{};              // the last reply
        std::optional<Angle> place;      // where the axis was, if its wrap was known
        std::optional<SteadyTime> back;  // when the drive answered again
        bool backTold = false;           // the return was reported, perhaps before the motion of the axis was known
    };

    [[nodiscard]] std::optional<Trouble> watchLoss(Drive& drive, const Context& context);
    void watchSilence(const Drive& drive, const Context& context);
    void beginSilence(const Drive& drive, Silence::Kind kind, const Context& context);
    void watchReturn(const Drive& drive, const Context& context);
    // How far the axis moved during the silence. Empty while that is not known.
    [[nodiscard]] std::optional<Angle> movedSince(const Silent& silent, const Drive& drive,
                                                  const Context& context) const;
    void endSilence();
    void watchUnordered(const Drive& drive, const Context& context);
    void watchActiveLimit(const Drive& drive, SteadyTime now);
    void watchCooling(const Drive& drive, SteadyTime now);
    [[nodiscard]] std::optional<Trouble> supervise(Drive& drive, const tracking::Setpoint& setpoint,
                                                   const Context& context);
    [[nodiscard]] supervision::AxisObservation observation(Drive& drive, const tracking::Setpoint& setpoint,
                                                           const Context& context) const;
    void tell(const supervision::Observed& observed);
    void endHints(const std::vector<supervision::Observed>& seen);

    Axis m_which;
    const profile::InForce& m_profile;
    AlarmBoard& m_alarms;
    supervision::AxisSupervisor m_supervisor;
    SilenceAlarms& m_silences;
    std::optional<Silent> m_silent;
    // The symptoms that have an alarm, each with the weight that was reported. Empty: it was reported before the last
    // re-arm.
    std::map<supervision::Symptom, std::optional<supervision::Weight>> m_told;
    std::set<supervision::Symptom> m_stops;   // the symptoms that are dangerous now
    SteadyTime m_observed{};                  // when the reply that the supervisor saw last was received
    SteadyTime m_placed{};                    // when the position that the supervisor saw last was received
    std::optional<SteadyTime> m_activeSince;  // active without our commands since then
    std::optional<SteadyTime> m_limitSeen;    // when the drive last reported an active limit
    drive_alarms::Heat m_limitHeat;           // the last temperatures during this limit
    // The temperatures at a fault by heat, while the fault lasts.
    std::optional<drive_alarms::Heat> m_faultHeat;
};

}  // namespace boresight
