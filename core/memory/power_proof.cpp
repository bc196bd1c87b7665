// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/memory/power_proof.h"

#include "core/memory/words.h"

#include <algorithm>
#include <cmath>

namespace boresight::memory {
namespace {

// The moteus counts its uptime by the RC oscillator of its processor: within -2…+1.5 % over its whole range of
// temperatures (STM32G4 data sheet), so 2 % of the time in between.
constexpr double kDriveClockError = 0.02;
// UTC may be wrong by 2 s at both ends (host_time.cpp), and neither end is stamped to better than some replies' age.
constexpr Seconds kAllowance{5.0};
// Its millisecond counter has 32 bits.
constexpr Seconds kUptimePeriod{4294967.296};

// The same count by the same profile gives the same angle, but for the last digits.
const Angle kRounding = Angle::fromDegrees(1e-6);

Seconds margin(Seconds elapsed)
{
    return elapsed * kDriveClockError + kAllowance;
}

// The time since the record by a clock that cannot have been put back in between, if there is one.
std::optional<Seconds> vouchedElapsed(const Evidence& evidence, const TurnRecord& record)
{
    if (!record.host.boot.isEmpty() && record.host.boot == evidence.host.boot) {
        return evidence.host.sinceBoot - record.host.sinceBoot;
    }
    if (record.host.utcIsExact && evidence.host.utcIsExact) {
        return evidence.now - record.when;
    }
    return std::nullopt;
}

std::optional<QString> obstacleInTime(const DriveFrame& frame, const Evidence& evidence, const TurnRecord& record)
{
    const Seconds byUtc = evidence.now - record.when;
    if (byUtc < Seconds(0.0)) {
        return QStringLiteral("The journal is dated %1 in the future: this computer's clock was put back")
            .arg(inWords(-byUtc));
    }
    if (record.host == HostTime{}) {
        return QStringLiteral(
            "The journal proves no turn any more: a doubt arose, or the drive's count was set, after it was written");
    }
    const std::optional<Seconds> elapsed = vouchedElapsed(evidence, record);
    if (!elapsed) {
        return QStringLiteral(
            "This computer was restarted since, and no time server vouches for its clock: whether the "
            "drive kept its power cannot be told");
    }
    if (record.uptime + *elapsed + margin(*elapsed) >= kUptimePeriod) {
        return QStringLiteral(
            "The drive's clock starts again every 49.7 days: whether the drive kept its power cannot "
            "be told");
    }
    // The steady clock of a computer may stand still while it sleeps, UTC does not: the longer of the two counts.
    const Seconds longest = std::max(*elapsed, byUtc);
    if (frame.uptime <= longest + margin(longest)) {
        return QStringLiteral("The drive was restarted %1 ago").arg(inWords(frame.uptime));
    }
    // A drive that kept its power counted just the time that went by here. If not, one of the clocks is wrong.
    const Seconds counted = frame.uptime - record.uptime;
    if (*elapsed < Seconds(0.0) || !(std::abs((counted - *elapsed).count()) <= margin(*elapsed).count())) {
        return QStringLiteral(
            "The clocks of the drive and of this computer disagree about the time since the journal: "
            "whether the drive kept its power cannot be told");
    }
    return std::nullopt;
}

}  // namespace

std::optional<QString> obstacleToCountingOn(const DriveFrame& frame, const Evidence& evidence, const TurnRecord& record,
                                            const pointing::AxisGeometry& axis)
{
    if (record.drive.isEmpty() || record.drive != frame.drive) {
        return QStringLiteral("The journal is of another drive (%1)").arg(record.drive);
    }
    if (auto obstacle = obstacleInTime(frame, evidence, record)) {
        return obstacle;
    }
    if (record.homeState == moteus::HomeState::Relative || record.homeState != frame.homeState) {
        return QStringLiteral("The drive's zero was set or lost since the journal was written");
    }
    if (!(abs(axis.toAxis(record.reported) - record.counted) <= kRounding)) {
        return QStringLiteral("Zero, direction or gear of the axis were changed since the journal was written");
    }
    return std::nullopt;
}

}  // namespace boresight::memory
