// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/messages/capabilities.h"
#include "core/mount/mount_report.h"
#include "core/profile/profile.h"
#include "core/tracking/axis_profile.h"
#include "core/units/sky.h"

#include <QString>

#include <optional>

// The port of the mount: what the control asks of any rotator, however that speaks. A driver decides nothing about
// motion. It promises that nothing moves before engage(), that an axis is held where it was measured before it follows
// a set-point, that silence is reported within its own time, and that nothing moves after a trouble before recover()
// and engage(). Station thread only, and nothing blocks. Angles are mechanical (unwrapped).
namespace boresight {

class MountService;

class MountDriver
{
public:
    virtual ~MountDriver() = default;

    // Of an axis that is missing every other question has the answer of one that stands at 0 and needs nothing.
    [[nodiscard]] virtual Capabilities capabilities() const = 0;
    // Of the drive of an axis: the source of a line of the log, and as it stands in a sentence.
    [[nodiscard]] virtual const QString& name(Axis axis) const = 0;
    [[nodiscard]] virtual QString label(Axis axis) const = 0;
    // Of the drive that answers now, empty if it has none; nothing: it was not read.
    [[nodiscard]] virtual std::optional<QString> identity(Axis axis) const = 0;
    // Of the drive that was known to stand on its wrap last; empty: none.
    [[nodiscard]] virtual QString lastIdentity(Axis axis) const = 0;

    // As of the last answer, also between two ticks.
    [[nodiscard]] virtual AxisReport report(Axis axis) const = 0;
    // Why nothing is asked of it now although nothing is wrong: the bus is left to other tools.
    [[nodiscard]] virtual Result<> available() const = 0;
    // Why it must not be moved: its own safety settings are wrong.
    [[nodiscard]] virtual const Result<>& fitness() const = 0;
    // Nullptr: nothing can be done to it but to move it.
    [[nodiscard]] virtual MountService* service() = 0;
    [[nodiscard]] virtual const MountService* service() const = 0;

    // Once per tick, in this order; the set-points and orders of the control come after them.
    virtual void observe(SteadyTime now) = 0;  // draws the conclusions from the answers
    [[nodiscard]] virtual MountFindings supervise(const MountSituation& known) = 0;

    // Takes the axes over where they stand; then they follow set-points.
    virtual void engage() = 0;
    // The place of an axis that has begun to follow in this tick, once: its first set-point must be there.
    [[nodiscard]] virtual std::optional<Angle> takeFollowing(Axis axis) = 0;
    virtual void command(Axis axis, const tracking::Setpoint& setpoint) = 0;
    // Stops axes that run by themselves, and takes them over again where they stand.
    virtual void retake() {}
    virtual void brakeHard(bool hard) = 0;  // the set-points brake as hard as the mount can
    virtual void seize() = 0;               // stops what an axis does without our orders
    virtual void recover() = 0;             // clears faults and time-outs; moves nothing
    virtual void rearmed() = 0;             // faults before this no longer count
    virtual void leave(profile::OnExit how) = 0;

    // Where a sensor on the antenna sees an axis: evidence where the wrap is asked for, and nothing else.
    virtual void setSensor(Axis axis, const std::optional<Angle>& heading) = 0;

    // Of both axes together.
    [[nodiscard]] std::optional<AxisPosition> measured() const;
    [[nodiscard]] std::optional<Angle> measured(Axis axis) const { return report(axis).place; }
    [[nodiscard]] bool answers() const;
    [[nodiscard]] bool follows() const;
    [[nodiscard]] bool seen() const;
    [[nodiscard]] bool wrapsKnown() const;
    [[nodiscard]] bool changesHands() const;  // one of them
    [[nodiscard]] bool underOrders() const;   // one of them
    [[nodiscard]] bool proofRunning() const;
};

}  // namespace boresight
