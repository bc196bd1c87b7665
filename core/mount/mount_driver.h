// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/messages/capabilities.h"
#include "core/mount/mount_report.h"
#include "core/profile/profile.h"
#include "core/tracking/axis_setpoints.h"
#include "core/tracking/leeway.h"
#include "core/units/sky.h"

#include <QString>

#include <optional>

// The port of the mount: what the control needs from any rotator, whatever its protocol. A driver decides nothing about
// motion. It makes four promises. Nothing moves before engage(). An axis is held where it was measured before it
// follows a set-point. Silence is reported within the time of the driver. After a trouble nothing moves before
// recover() and engage(). Station thread only. Never blocks. Angles are mechanical (unwrapped).
namespace boresight {

class MountService;
class ThirdAxis;

class MountDriver
{
public:
    virtual ~MountDriver() = default;

    // For a missing axis, all other functions return the values of an axis that stands at 0 and needs nothing.
    [[nodiscard]] virtual Capabilities capabilities() const = 0;
    // The name of the drive of an axis: name() is the source in the log, label() is for use in a sentence.
    [[nodiscard]] virtual const QString& name(Axis axis) const = 0;
    [[nodiscard]] virtual QString label(Axis axis) const = 0;
    // The identity of the drive that answers. An empty text: it has none. No value: it was not read.
    [[nodiscard]] virtual std::optional<QString> identity(Axis axis) const = 0;
    // The identity of the drive whose wrap was known last. Empty if there was none.
    [[nodiscard]] virtual QString lastIdentity(Axis axis) const = 0;

    // The values of the last answer, also between two ticks.
    [[nodiscard]] virtual AxisReport report(Axis axis) const = 0;
    // Why the mount is not queried now although it has no fault: the bus is released to other tools.
    [[nodiscard]] virtual Result<> available() const = 0;
    // Why the mount must not be moved: its own safety settings are wrong.
    [[nodiscard]] virtual const Result<>& interlock() const = 0;
    // Whether a line that the operator types may be sent to the device now, otherwise the reason.
    [[nodiscard]] virtual Result<> mayType() const;
    // Whether the device can be asked for a home run now, otherwise the reason.
    [[nodiscard]] virtual Result<> mayMakeHomeRun() const;
    // Null if the mount has no functions but moving.
    [[nodiscard]] virtual MountService* service() = 0;
    [[nodiscard]] virtual const MountService* service() const = 0;
    // Null if the mount has no axis beside the two.
    [[nodiscard]] virtual ThirdAxis* thirdAxis() { return nullptr; }
    [[nodiscard]] virtual const ThirdAxis* thirdAxis() const { return nullptr; }

    // Both once per tick, in this order. The set-points and commands of the control come after them.
    virtual void observe(SteadyTime now) = 0;  // evaluates the answers
    [[nodiscard]] virtual MountFindings supervise(const MountSituation& known) = 0;

    // Takes the axes over where they are. Then they follow set-points.
    virtual void engage() = 0;
    // The position of an axis that has begun to follow in this tick, once. Its first set-point must be there.
    [[nodiscard]] virtual std::optional<Angle> takeFollowing(Axis axis) = 0;
    virtual void command(Axis axis, const tracking::Setpoint& setpoint) = 0;
    // For axes that move to a target by themselves: the largest distance from the set-point to the target. Comes with
    // each command.
    virtual void setLeeway(Axis /*axis*/, const tracking::Leeway& /*leeway*/) {}
    // Stops axes that move by themselves, and takes them over again where they are.
    virtual void retake() {}
    virtual void brakeHard(bool hard) = 0;  // the set-points brake as hard as the mount can
    virtual void seize() = 0;               // stops what an axis does without our commands
    virtual void recover() = 0;             // clears faults and time-outs; moves nothing
    virtual void rearmed() = 0;             // earlier faults no longer count
    virtual void leave(profile::OnExit how) = 0;

    // The direction in which a sensor on the antenna sees an axis. It is only evidence for the question about the wrap.
    virtual void setSensor(Axis axis, const std::optional<Angle>& heading) = 0;

    // The position of both axes. Empty if one of them is unknown.
    [[nodiscard]] std::optional<AxisPosition> measured() const;
    [[nodiscard]] std::optional<Angle> measured(Axis axis) const { return report(axis).place; }
    [[nodiscard]] bool answers() const;
    [[nodiscard]] bool follows() const;
    [[nodiscard]] bool seen() const;
    [[nodiscard]] bool wrapsKnown() const;
    [[nodiscard]] bool changesHands() const;  // at least one axis
    [[nodiscard]] bool underOrders() const;   // at least one axis
    [[nodiscard]] bool proofRunning() const;
};

}  // namespace boresight
