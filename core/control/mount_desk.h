// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/event_log.h"
#include "core/base/result.h"
#include "core/control/drive_gates.h"
#include "core/control/helm.h"
#include "core/messages/request.h"
#include "core/mount/mount_driver.h"
#include "core/mount/mount_service.h"

// Carries out what the operator does to the mount itself: drive settings, bus, cable wraps, crash-stop test. Works
// only while the mount stands still. Station thread only.
namespace boresight {

class MountDesk
{
public:
    MountDesk(MountDriver& mount, Helm& helm, EventLog& log) : m_mount(mount), m_helm(helm), m_log(log) {}

    // Only checks whether this is permitted. The connection of the mount reads and writes.
    Result<> ask(const request::ReadDrives& wanted, const Source& by);
    Result<> ask(const request::FixDrives& wanted, const Source& by);
    Result<> ask(const request::AssignBoard& wanted, const Source& by);
    Result<> ask(const request::SetGear& wanted, const Source& by);
    Result<> ask(const request::SwitchOff& wanted, const Source& by);
    Result<> ask(const request::ReleaseBus& wanted, const Source& by);
    Result<> ask(const request::TakeBus& wanted, const Source& by);
    Result<> ask(const request::TypeLine& wanted, const Source& by);
    Result<> ask(const request::MakeHomeRun& wanted, const Source& by);
    Result<> ask(const request::ChooseTurn& wanted, const Source& by);
    Result<> ask(const request::ProveCrashStop& wanted, const Source& by);
    Result<> ask(const request::EndProof& wanted, const Source& by);
    Result<> ask(const request::ReadGains& wanted, const Source& by);
    Result<> ask(const request::SetGain& wanted, const Source& by);
    Result<> ask(const request::PutGainsBack& wanted, const Source& by);
    Result<> ask(const request::StoreGains& wanted, const Source& by);

private:
    [[nodiscard]] DriveGates driveGates() const { return DriveGates(m_helm.view()); }
    [[nodiscard]] MountService& service() { return *m_mount.service(); }  // call only after a gate has found one

    MountDriver& m_mount;
    Helm& m_helm;
    EventLog& m_log;
};

}  // namespace boresight
