// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/control/drive_gates.h"

#include "core/base/text.h"
#include "core/control/calibration_source.h"
#include "core/mount/mount_service.h"

#include <algorithm>

namespace boresight {

Result<> DriveGates::maySet(Axis axis) const
{
    return m_gates.hasAxis(axis)
        .and_then([&] { return m_gates.isFresh(axis); })
        .and_then([&] { return m_gates.isPlaced(axis); })
        .and_then([this] { return drivesRest(); })
        .and_then([this] { return axesStand(); });
}

// Somebody may turn an axis by hand, or an axis may still coast towards its set-point.
Result<> DriveGates::axesStand() const
{
    const auto turns = [this](Axis axis) { return m_of.standstill.moves(axis); };
    return std::ranges::any_of(kAxes, turns) ? failure(ErrorCode::Refused, Text::tr("The mount moves. Stop it first."))
                                             : Result<>{};
}

Result<> DriveGates::drivesRest() const
{
    if (m_of.mount.underOrders() && !m_of.motion.atRest()) {
        return failure(ErrorCode::Refused, Text::tr("The mount moves. Stop it first."));
    }
    if (m_of.mount.changesHands()) {
        return failure(ErrorCode::Refused, Text::tr("Boresight is taking over a drive. Try again in a second."));
    }
    return {};
}

Result<> DriveGates::hasService() const
{
    return m_of.mount.service() != nullptr
               ? Result<>{}
               : failure(ErrorCode::NotAvailable, Text::tr("this rotator does not have this function"));
}

Result<> DriveGates::drivesAnswer() const
{
    return m_of.arming.connected() ? Result<>{} : failure(ErrorCode::NoAnswer, Text::tr("every drive must answer"));
}

Result<> DriveGates::mayReadDrives() const
{
    return hasService().and_then([this] { return m_of.mount.available(); }).and_then([this] { return drivesRest(); });
}

Result<> DriveGates::mayFixDrives() const
{
    return hasService().and_then([this] { return drivesAnswer(); }).and_then([this] {
        return m_of.mount.service()->mayBeWritten();
    });
}

Result<> DriveGates::mayChangeBoards() const
{
    return mayReadDrives().and_then([this] { return axesStand(); }).and_then([this] {
        return m_of.mount.service()->mayBeWritten();
    });
}

Result<> DriveGates::maySwitchOff() const
{
    return mayLeaveBus().and_then([this] { return drivesAnswer(); });
}

Result<> DriveGates::maySwitchOff(Axis axis) const
{
    return m_gates.hasAxis(axis).and_then([this] { return maySwitchOff(); }).and_then([&] {
        return m_of.mount.service()->maySwitchOff(axis);
    });
}

Result<> DriveGates::mayLeaveBus() const
{
    return hasService().and_then([this] { return drivesRest(); }).and_then([this] { return m_of.brake.admitsOff(); });
}

Result<> DriveGates::mayTune(Axis axis) const
{
    return hasService()
        .and_then([&] { return m_gates.hasAxis(axis); })
        .and_then([&] { return m_of.mount.service()->mayBeTuned(axis); })
        .and_then([this] { return drivesAnswer(); })
        .and_then([this]() -> Result<> {
            return m_of.current.moves() && m_of.current.isFor(tuningSource())
                       ? failure(ErrorCode::Refused, Text::tr("A tuning run moves the mount. End it first."))
                       : Result<>{};
        })
        .and_then([this] { return drivesRest(); })
        .and_then([this] { return axesStand(); });
}

Result<> DriveGates::mayTuneOff(Axis axis) const
{
    return mayTune(axis).and_then([this] { return m_of.mount.service()->mayBeWritten(); });
}

Result<> DriveGates::mayProve(const Source& source) const
{
    return hasService().and_then([&] { return m_gates.mayPoint(source); }).and_then([this] { return drivesRest(); });
}

Result<> DriveGates::mayEndProof() const
{
    return m_of.mount.proofRunning() ? Result<>{}
                                     : failure(ErrorCode::Refused, Text::tr("No crash-stop test is running."));
}

Result<> DriveGates::mayTakeBus() const
{
    return hasService().and_then([this] { return m_of.mount.service()->mayTakeBus(); });
}

Result<> DriveGates::mayChooseTurn(Axis axis) const
{
    return mayLeaveBus().and_then([&] { return m_of.mount.service()->mayChooseWrap(axis); });
}

}  // namespace boresight
