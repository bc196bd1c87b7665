// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/journal/power_proof.h"

#include "core/base/text.h"
#include "core/journal/place_words.h"

#include <algorithm>
#include <cmath>

namespace boresight::journal {
namespace {

// A moteus counts its uptime by the RC oscillator of its processor, which is within -2…+1.5 % over the whole range of
// temperatures (STM32G4 data sheet). So the error is at most 2 % of the elapsed time.
constexpr double kDriveClockError = 0.02;
// UTC may be wrong by 2 s at both ends (host_time.cpp). The age of the replies adds a little at both ends.
constexpr Seconds kAllowance{5.0};
// The millisecond counter of the drive has 32 bits.
constexpr Seconds kUptimePeriod{4294967.296};

// The same count and profile give the same angle, except for rounding.
const Angle kRounding = Angle::fromDegrees(1e-6);

Seconds margin(Seconds elapsed)
{
    return elapsed * kDriveClockError + kAllowance;
}

bool isSameBoot(const Evidence& evidence, const TurnRecord& record)
{
    return !record.host.boot.isEmpty() && record.host.boot == evidence.host.boot;
}

bool isUtcExact(const Evidence& evidence, const TurnRecord& record)
{
    return record.host.utcIsExact && evidence.host.utcIsExact;
}

// The time since the record, by a clock that cannot have been set meanwhile. Empty: there is no such clock.
std::optional<Seconds> vouchedElapsed(const Evidence& evidence, const TurnRecord& record)
{
    if (isSameBoot(evidence, record)) {
        return evidence.host.sinceBoot - record.host.sinceBoot;
    }
    return isUtcExact(evidence, record) ? std::optional<Seconds>(evidence.now - record.when) : std::nullopt;
}

// A virtual machine does not count the time for which it was paused, and a computer without a battery clock may not
// count its sleep. A UTC that a time server kept at both ends shows such a time, so the longer of the two counts.
Seconds longest(Seconds elapsed, const Evidence& evidence, const TurnRecord& record)
{
    return isUtcExact(evidence, record) ? std::max(elapsed, Seconds(evidence.now - record.when)) : elapsed;
}

std::optional<Obstacle> obstacleInTime(const DriveFrame& frame, const Evidence& evidence, const TurnRecord& record)
{
    // While the computer runs, the UTC may be set to any time.
    const Seconds byUtc = evidence.now - record.when;
    if (!isSameBoot(evidence, record) && byUtc < Seconds(0.0)) {
        return Obstacle{.why =
                            Text::tr("The journal is dated %1 in the future. The clock of this computer was set back")
                                .arg(inWords(-byUtc))};
    }
    if (record.provesNothing()) {
        return Obstacle{
            .why = Text::tr("The journal does not prove the cable wrap, because the position became doubtful later")};
    }
    const std::optional<Seconds> elapsed = vouchedElapsed(evidence, record);
    if (!elapsed) {
        return Obstacle{.why = Text::tr("This computer restarted, and its clock is not synchronised. It is unknown "
                                        "whether the drive kept its power")};
    }
    if (record.uptime + *elapsed + margin(*elapsed) >= kUptimePeriod) {
        return Obstacle{
            .why = Text::tr(
                "The clock of the drive restarts every 49.7 days. It is unknown whether the drive kept its power")};
    }
    const Seconds atMost = longest(*elapsed, evidence, record);
    if (frame.uptime <= atMost + margin(atMost)) {
        return Obstacle{.why = Text::tr("The drive was restarted %1 ago").arg(inWords(frame.uptime)),
                        .restarted = true};
    }
    // A drive that kept its power counted the time that passed here. If the counts differ, one of the clocks is wrong.
    const Seconds counted = frame.uptime - record.uptime;
    if (*elapsed < Seconds(0.0) || !(std::abs((counted - *elapsed).count()) <= margin(*elapsed).count())) {
        return Obstacle{.why = Text::tr("The clocks of the drive and of this computer disagree about the time since "
                                        "the journal. It is unknown whether the drive kept its power")};
    }
    return std::nullopt;
}

// A larger difference between two origins means that the position was set. Reading the two counts of an origin one
// after the other causes a difference of at most 2^-16 turn. The tolerance must also stay far below the period of the
// drive.
constexpr MotorTurns kSameOrigin = MotorTurns::fromTurns(1e-4);
constexpr double kSamePart = 1.0 / 20.0;

Angle originTolerance(Angle period, const pointing::AxisGeometry& axis)
{
    return std::min(abs(axis.toAxis(kSameOrigin) - axis.toAxis(MotorTurns())), period * kSamePart);
}

std::optional<Obstacle> obstacleInOrigin(const DriveFrame& frame, const TurnRecord& record,
                                         const pointing::AxisGeometry& axis)
{
    if (!frame.origin || !record.origin) {
        return Obstacle{.why = Text::tr("The drive did not report whether its position was set since then")};
    }
    if (record.origin->beginning != frame.origin->beginning) {
        return Obstacle{.why = Text::tr("The encoder settings of the drive were changed. It counts from a new zero"),
                        .positionSet = true,
                        .phaseLost = true};
    }
    if (!isSameOrigin(*record.origin, *frame.origin, frame.period, axis)) {
        const Angle set = axis.toAxis(frame.origin->offset) - axis.toAxis(record.origin->offset);
        // `d nearest` sets the position by whole periods, `d exact` by any angle.
        const Angle rest = set - frame.period * std::round(set / frame.period);
        return Obstacle{.why = Text::tr("The position of the drive was set by a command. The change is not a motion"),
                        .positionSet = true,
                        .phaseLost = !(abs(rest) < originTolerance(frame.period, axis))};
    }
    return std::nullopt;
}

}  // namespace

bool isSameOrigin(const moteus::CountOrigin& one, const moteus::CountOrigin& other, Angle period,
                  const pointing::AxisGeometry& axis)
{
    const Angle set = axis.toAxis(one.offset) - axis.toAxis(other.offset);
    return one.beginning == other.beginning && abs(set) < originTolerance(period, axis);
}

std::optional<Obstacle> obstacleToCountingOn(const DriveFrame& frame, const Evidence& evidence,
                                             const TurnRecord& record, const pointing::AxisGeometry& axis)
{
    if (record.drive.isEmpty() || record.drive != frame.drive) {
        return Obstacle{.why = Text::tr("The journal is of another drive (%1)").arg(record.drive)};
    }
    auto inTime = obstacleInTime(frame, evidence, record);
    auto inOrigin = obstacleInOrigin(frame, record, axis);
    const bool restarted = (inTime && inTime->restarted) || frame.uptime < record.uptime;
    if (inOrigin && inOrigin->positionSet && !restarted) {
        return inOrigin;  // certain, whatever the clocks show
    }
    if (inTime) {
        return inTime;
    }
    if (record.homeState == moteus::HomeState::Relative || record.homeState != frame.homeState) {
        return Obstacle{.why = Text::tr("The zero of the drive was set or lost after the journal was written")};
    }
    if (!(abs(axis.toAxis(record.reported) - record.counted) <= kRounding)) {
        return Obstacle{.why =
                            Text::tr("Zero, direction or gear of the axis were changed after the journal was written")};
    }
    return inOrigin;
}

}  // namespace boresight::journal
