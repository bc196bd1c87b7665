// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_board.h"
#include "core/moteus_mount/drive_pair.h"
#include "core/profile/in_force.h"

#include <array>
#include <optional>

// The alarms about drives that do not reply. There is one for each drive, or one for both when both fell silent at the
// same time, because then the bus is the likely cause. Decides nothing about motion. Station thread only.
namespace boresight {

// What the alarm reports about a drive. A drive that is back waits for a re-arm.
struct Silence
{
    enum class Kind
    {
        Lost,     // the drive was under our commands
        Unheard,  // the drive was not under our commands
        Back
    };

    Kind kind = Kind::Lost;
    SteadyTime since{};          // the last reply before the silence
    bool needsRearm = false;     // for Unheard
    Seconds lasted{0.0};         // for Back
    std::optional<Angle> moved;  // for Back: how far the axis moved meanwhile. Empty if not known
};

class SilenceAlarms
{
public:
    // The references outlive this object.
    SilenceAlarms(const profile::InForce& profile, AlarmBoard& alarms, const DrivePair& drives)
        : m_profile(profile), m_alarms(alarms), m_drives(drives)
    {}

    // What to do about a silent bus, if the kind of the bus is known.
    void setAdvice(const QString& advice) { m_advice = advice; }
    void tell(Axis axis, const Silence& silence);
    void end(Axis axis) { m_silences[index(axis)].reset(); }
    // Once per tick, after both drives were looked at.
    void show(SteadyTime now);
    // Both drives fell silent together.
    [[nodiscard]] bool isOfBoth() const { return m_together; }

private:
    [[nodiscard]] bool belongTogether(SteadyTime now);
    [[nodiscard]] bool isQuiet(Axis axis, SteadyTime now) const;
    void showBoth();
    void showEach();

    const profile::InForce& m_profile;
    AlarmBoard& m_alarms;
    const DrivePair& m_drives;
    QString m_advice;
    std::array<std::optional<Silence>, 2> m_silences;
    std::array<bool, 2> m_isNew{};
    bool m_together = false;
    std::optional<SteadyTime> m_parted;  // since when the two drives differ, although they fell silent together
};

}  // namespace boresight
