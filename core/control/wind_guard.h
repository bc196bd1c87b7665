// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_board.h"
#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/messages/wind_status.h"
#include "core/profile/in_force.h"
#include "core/wind/wind_watch.h"

#include <QString>

#include <cstdint>
#include <optional>

// Whether the wind lets the mount move, and the alarms about it. In a strong wind only Park moves the mount, until the
// wind was weak for a while, or for as long as the operator overrides that. Moves nothing itself: the source that parks
// asks when it is due. Station thread only.
namespace boresight {

class WindGuard
{
public:
    // All of them outlive the guard.
    WindGuard(const profile::InForce& profile, const Clock& clock, AlarmBoard& alarms);

    // A reading, in m/s.
    void take(double speed);
    // Once in a tick, before the sources.
    void step();
    // Once in a tick, after the sources. `parks`: the mount is parked, or on its way.
    void tell(bool parks);
    void profileChanged(const profile::Profile& before, const profile::Profile& after);

    [[nodiscard]] bool forbids() const { return m_forbids; }
    // Why only Park moves the mount, in one or two sentences. Empty: the wind forbids nothing.
    [[nodiscard]] QString obstacle() const { return m_forbids ? causeText() + QLatin1Char('.') : QString(); }
    // The same as a refusal, with what it waits for.
    [[nodiscard]] Result<> admits() const;
    // Another one each time that the mount shall be parked because of the wind.
    [[nodiscard]] std::uint64_t onsets() const { return m_onsets; }
    [[nodiscard]] Result<> mayOverride() const;
    // The operator may move the mount for the time of the profile. Then it is to be parked again.
    void override();
    [[nodiscard]] WindStatus status() const;

private:
    // With the time that this computer slept: a reading from before is old.
    [[nodiscard]] SteadyTime now() const;
    [[nodiscard]] bool isStrong() const { return m_watch.cause() != wind::WindWatch::Cause::None; }
    [[nodiscard]] QString causeText() const;
    void tellStow(bool parks);
    void tellSilence();

    const profile::InForce& m_profile;
    const Clock& m_clock;
    AlarmBoard& m_alarms;
    wind::WindWatch m_watch;
    std::uint64_t m_onsets = 0;
    bool m_forbids = false;  // as of the last tick
    bool m_isSilent = false;
    QString m_lastHeard;  // when the last reading came, before the silence
    std::uint64_t m_accepted = 0;
    struct Override
    {
        SteadyTime until;
        UtcTime utc;  // the same
    };
    std::optional<Override> m_override;
};

}  // namespace boresight
