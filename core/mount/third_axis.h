// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/messages/third_axis_status.h"
#include "core/profile/profile.h"
#include "core/tracking/axis_setpoints.h"
#include "core/units/sky.h"

#include <QString>

#include <optional>

// The drive of a further axis beside the two, such as the polarisation. Only some mounts have one. It decides nothing
// about motion and makes the promises of MountDriver: nothing moves before engage(), the axis is held where it was
// measured before it follows set-points, and after a loss nothing moves before the next engage(). Station thread only.
// Never blocks. Mechanical angles.
namespace boresight {

class ThirdAxis
{
public:
    virtual ~ThirdAxis() = default;

    // Success if the axis can be moved now, otherwise the reason and what to do.
    [[nodiscard]] virtual Result<> fit() const = 0;
    // A fault of the drive that only recover() clears.
    [[nodiscard]] virtual bool isFaulted() const = 0;
    // The last position that is believed. Empty: the drive does not know it.
    [[nodiscard]] virtual std::optional<Angle> place() const = 0;
    // It gets commands, not only queries.
    [[nodiscard]] virtual bool underOrders() const = 0;
    [[nodiscard]] virtual bool follows() const = 0;  // set-points
    // Fills in what the drive reports.
    virtual void describe(ThirdAxisStatus& status) const = 0;

    // Takes the axis over where it is. Then it follows set-points.
    virtual void engage() = 0;
    // The position of the axis when it has begun to follow, once. The first set-point must be there.
    [[nodiscard]] virtual std::optional<Angle> takeFollowing() = 0;
    virtual void command(const tracking::Setpoint& setpoint) = 0;  // once per tick, while the axis follows
    virtual void brakeHard(bool hard) = 0;                         // the set-points brake as hard as the drive can
    // Why the axis does not follow set-points any more, once.
    [[nodiscard]] virtual std::optional<QString> takeLoss() = 0;
    virtual void seize() = 0;    // stops what the axis does without our commands
    virtual void recover() = 0;  // clears a fault; moves nothing
    virtual void leave(profile::OnExit how) = 0;
};

}  // namespace boresight
