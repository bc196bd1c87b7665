// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mount/mount_driver.h"

#include "core/base/text.h"
#include "core/mount/mount_service.h"

#include <algorithm>

namespace boresight {
namespace {

bool both(const MountDriver& mount, bool AxisReport::*is)
{
    return std::ranges::all_of(kAxes, [&](Axis axis) { return mount.report(axis).*is; });
}

bool either(const MountDriver& mount, bool AxisReport::*is)
{
    return std::ranges::any_of(kAxes, [&](Axis axis) { return mount.report(axis).*is; });
}

}  // namespace

Result<> MountDriver::mayType() const
{
    return failure(ErrorCode::NotAvailable, Text::tr("this rotator does not have this function"));
}

Result<> MountDriver::mayMakeHomeRun() const
{
    return failure(ErrorCode::NotAvailable, Text::tr("this rotator has no command for a home run"));
}

std::optional<AxisPosition> MountDriver::measured() const
{
    const auto azimuth = measured(Axis::Azimuth);
    const auto elevation = measured(Axis::Elevation);
    return azimuth && elevation ? std::optional(AxisPosition{*azimuth, *elevation}) : std::nullopt;
}

bool MountDriver::answers() const
{
    return both(*this, &AxisReport::answers);
}

bool MountDriver::follows() const
{
    return std::ranges::all_of(kAxes, [this](Axis axis) { return report(axis).hand == AxisHand::Follows; });
}

bool MountDriver::seen() const
{
    return both(*this, &AxisReport::seen);
}

bool MountDriver::wrapsKnown() const
{
    return both(*this, &AxisReport::wrapKnown);
}

bool MountDriver::changesHands() const
{
    return either(*this, &AxisReport::changesHands);
}

bool MountDriver::underOrders() const
{
    return either(*this, &AxisReport::underOrders);
}

bool MountDriver::proofRunning() const
{
    return service() != nullptr && service()->proofRunning();
}

}  // namespace boresight
