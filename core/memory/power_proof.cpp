// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/memory/power_proof.h"

#include "core/base/text.h"
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
        return Text::tr("The journal is dated %1 in the future: this computer's clock was put back")
            .arg(inWords(-byUtc));
    }
    if (record.provesNothing()) {
        return Text::tr("The journal proves no turn any more: a doubt arose after it was written");
    }
    const std::optional<Seconds> elapsed = vouchedElapsed(evidence, record);
    if (!elapsed) {
        return Text::tr(
            "This computer was restarted since, and no time server vouches for its clock: whether the "
            "drive kept its power cannot be told");
    }
    if (record.uptime + *elapsed + margin(*elapsed) >= kUptimePeriod) {
        return Text::tr(
            "The drive's clock starts again every 49.7 days: whether the drive kept its power cannot "
            "be told");
    }
    // The steady clock of a computer may stand still while it sleeps, UTC does not: the longer of the two counts.
    const Seconds longest = std::max(*elapsed, byUtc);
    if (frame.uptime <= longest + margin(longest)) {
        return Text::tr("The drive was restarted %1 ago").arg(inWords(frame.uptime));
    }
    // A drive that kept its power counted just the time that went by here. If not, one of the clocks is wrong.
    const Seconds counted = frame.uptime - record.uptime;
    if (*elapsed < Seconds(0.0) || !(std::abs((counted - *elapsed).count()) <= margin(*elapsed).count())) {
        return Text::tr(
            "The clocks of the drive and of this computer disagree about the time since the journal: "
            "whether the drive kept its power cannot be told");
    }
    return std::nullopt;
}

// Read while the axis turns, the two counts differ by less.
constexpr MotorTurns kSameOrigin = MotorTurns::fromTurns(0.002);

// `d nearest` sets the position by whole places, `d exact` by anything.
bool byWholePlaces(MotorTurns set, const DriveFrame& frame, const pointing::AxisGeometry& axis)
{
    const Angle by = axis.toAxis(set) - axis.toAxis(MotorTurns());
    const Angle same = abs(axis.toAxis(kSameOrigin) - axis.toAxis(MotorTurns()));
    return abs(by - frame.period * std::round(by / frame.period)) < same;
}

std::optional<Obstacle> obstacleInOrigin(const DriveFrame& frame, const TurnRecord& record,
                                         const pointing::AxisGeometry& axis)
{
    if (!frame.origin || !record.origin) {
        return Obstacle{Text::tr("The drive did not tell whether its position was set since")};
    }
    if (record.origin->beginning != frame.origin->beginning) {
        return Obstacle{Text::tr("The drive's encoder settings were changed since: it counts anew"), true, true};
    }
    const MotorTurns set = frame.origin->offset - record.origin->offset;
    if (!(abs(set) < kSameOrigin)) {
        return Obstacle{Text::tr("The drive's position was set since: what it reports is no motion"), true,
                        !byWholePlaces(set, frame, axis)};
    }
    return std::nullopt;
}

}  // namespace

std::optional<Obstacle> obstacleToCountingOn(const DriveFrame& frame, const Evidence& evidence,
                                             const TurnRecord& record, const pointing::AxisGeometry& axis)
{
    if (record.drive.isEmpty() || record.drive != frame.drive) {
        return Obstacle{Text::tr("The journal is of another drive (%1)").arg(record.drive)};
    }
    if (auto why = obstacleInTime(frame, evidence, record)) {
        return Obstacle{*why};
    }
    if (record.homeState == moteus::HomeState::Relative) {
        return Obstacle{Text::tr("The drive had no zero when the journal was written")};
    }
    if (!(abs(axis.toAxis(record.reported) - record.counted) <= kRounding)) {
        return Obstacle{Text::tr("Zero, direction or gear of the axis were changed since the journal was written")};
    }
    return obstacleInOrigin(frame, record, axis);
}

}  // namespace boresight::memory
