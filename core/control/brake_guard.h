// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_board.h"
#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/brake/brake_sequence.h"
#include "core/contacts/output_name.h"
#include "core/control/standstill_watch.h"
#include "core/messages/brake_status.h"
#include "core/motion/motion.h"
#include "core/mount/mount_driver.h"
#include "core/profile/in_force.h"

#include <QString>

// Holds the set-points until the brakes of the axes are open, whatever the source of the motion, and has the brakes set
// after the motion. The station switches the output and passes its answers on. Without a brake in the profile nothing
// waits. Station thread only.
namespace boresight {

class BrakeGuard
{
public:
    struct Parts
    {
        const profile::InForce& profile;
        const MountDriver& mount;
        const Motion& motion;
        const StandstillWatch& standstill;
        AlarmBoard& alarms;
    };

    // The parts outlive the guard.
    explicit BrakeGuard(const Parts& parts) : m_of(parts) {}

    // What the output answers, before each tick.
    void take(const contacts::OutputAnswer& answer);
    // The order to the output after each tick.
    [[nodiscard]] bool releases() const { return m_sequence.releases(); }

    // Once in a tick, before the sources. `isUrgent`: STOP, a fault or the end of the program. Returns why a motion
    // must end, once. Empty: it may go on.
    [[nodiscard]] QString step(bool isUrgent, SteadyTime now);
    // Once in a tick, before the set-points: they may advance by `step`. They advance also while the brake is set, as
    // long as they stand still.
    [[nodiscard]] bool letsMove(SteadyTime now, Seconds step);
    // The brake is open, or there is none.
    [[nodiscard]] bool isOpen() const { return !isUsed() || m_sequence.mayMove(); }
    // A motion waits until the brake is open.
    [[nodiscard]] bool opens() const { return isUsed() && m_sequence.state() == brake::BrakeState::Releasing; }
    // The brake is set, or there is none.
    [[nodiscard]] bool isSet() const { return !isUsed() || m_sequence.state() == brake::BrakeState::Set; }

    // Whether a motion may begin.
    [[nodiscard]] Result<> admits() const;
    // Whether the drives may be switched off or left to other tools. The brake then holds the axes.
    [[nodiscard]] Result<> admitsOff() const;
    // Whether `after` may be applied. Another output sets the brake, so nothing may move meanwhile. An output that does
    // not work may be replaced.
    [[nodiscard]] Result<> mayChange(const profile::Profile& after) const;
    void profileChanged(const profile::Profile& before, const profile::Profile& after);
    [[nodiscard]] BrakeStatus status() const;

private:
    [[nodiscard]] bool isUsed() const { return m_of.profile->brake.isUsed(); }
    [[nodiscard]] bool moves() const;
    [[nodiscard]] brake::BrakeTimes times() const;

    Parts m_of;
    brake::BrakeSequence m_sequence;
    contacts::OutputAnswer m_answer;
    bool m_isWanted = false;    // in the last tick the set-points would have moved
    bool m_isReported = false;  // the present problem has ended the motion
};

}  // namespace boresight
