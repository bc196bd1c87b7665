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

// Decides whether the wind permits motion, and raises the alarms about the wind. In a strong wind only Park moves the
// mount. This ends when the wind was weak for some minutes, and pauses while the operator overrides it. The guard moves
// nothing itself: a source of motion asks the guard when the mount has to be parked. Station thread only.
namespace boresight {

class WindGuard
{
public:
    // All arguments outlive the guard.
    WindGuard(const profile::InForce& profile, const Clock& clock, AlarmBoard& alarms);

    // A reading, in m/s.
    void take(double speed);
    // Why no reading comes from the source, for the alarms. Empty: no trouble is known.
    void takeTrouble(const QString& trouble) { m_trouble = trouble; }
    // Call once in a tick, before the sources.
    void step();
    // Call once in a tick, after the sources. `parks`: the mount is parked, or on its way to the park position.
    void tell(bool parks);
    void profileChanged(const profile::Profile& before, const profile::Profile& after);

    [[nodiscard]] bool forbids() const { return m_forbids; }
    // Why only Park may move the mount, in one or two sentences. Empty: the wind forbids nothing.
    [[nodiscard]] QString obstacle() const { return m_forbids ? causeText() + QLatin1Char('.') : QString(); }
    // The obstacle as a refusal, which also says when the obstacle ends.
    [[nodiscard]] Result<> admits() const;
    // Clients may get control. A client that keeps asking would move the mount as soon as the wind is weak.
    [[nodiscard]] Result<> admitsClients() const;
    // A parked mount may leave PARKED.
    [[nodiscard]] Result<> admitsUnpark() const;
    // Counts how often the mount had to be parked because of the wind.
    [[nodiscard]] std::uint64_t onsets() const { return m_onsets; }
    [[nodiscard]] Result<> mayOverride() const;
    // Permits motion for the time that the profile sets. After that the mount has to be parked again.
    void override();
    [[nodiscard]] WindStatus status() const;

private:
    [[nodiscard]] bool isStrong() const { return m_watch.cause() != wind::WindWatch::Cause::None; }
    [[nodiscard]] QString causeText() const;
    // `text` contains the obstacle, the lower limit and the calm time.
    [[nodiscard]] Result<> unlessForbidden(const QString& text) const;
    [[nodiscard]] QString sinceText(const QString& time) const;
    [[nodiscard]] QString silentSince() const;
    void tellStow(bool parks);
    void tellSilence();

    const profile::InForce& m_profile;
    const Clock& m_clock;
    AlarmBoard& m_alarms;
    wind::WindWatch m_watch;
    std::uint64_t m_onsets = 0;
    bool m_forbids = false;  // since the last tick
    bool m_isSilent = false;
    QString m_lastHeard;  // the time of the last reading before the silence, or from when on readings were expected
    QString m_trouble;
    bool m_isFirst = true;  // the source is the one of the start
    std::uint64_t m_accepted = 0;
    struct Override
    {
        SteadyTime until;
        UtcTime utc;  // the same time in UTC
    };
    std::optional<Override> m_override;
};

}  // namespace boresight
