// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/control/mount_desk.h"

#include "core/base/text.h"
#include "core/control/home_run_gate.h"
#include "core/control/typed_line_gate.h"

namespace boresight {

Result<> MountDesk::ask(const request::ReadDrives&, const Source& by)
{
    return operatorOnly(by).and_then([this] { return driveGates().mayReadDrives(); });
}

Result<> MountDesk::ask(const request::FixDrives&, const Source& by)
{
    return operatorOnly(by).and_then([this] { return driveGates().mayFixDrives(); }).map([&] {
        m_helm.takeOver(by);  // the next target of a client would switch the drives on during the change
    });
}

Result<> MountDesk::ask(const request::AssignBoard&, const Source& by)
{
    return operatorOnly(by).and_then([this] { return driveGates().mayChangeBoards(); }).map([&] {
        m_helm.takeOver(by);
    });
}

Result<> MountDesk::ask(const request::SetGear&, const Source& by)
{
    return operatorOnly(by).and_then([this] { return driveGates().mayChangeBoards(); }).map([&] {
        m_helm.takeOver(by);
    });
}

Result<> MountDesk::ask(const request::SwitchOff& wanted, const Source& by)
{
    const auto may = [&] {
        return wanted.axis ? driveGates().maySwitchOff(*wanted.axis) : driveGates().maySwitchOff();
    };
    return operatorOnly(by).and_then(may).map([&] {
        m_helm.takeOver(by);  // the next target of a client would switch the drives on again
        m_helm.hold(Activity::None);
        m_log.add(Severity::Warning, by.name, service().switchOff(wanted.axis));
    });
}

Result<> MountDesk::ask(const request::ReleaseBus&, const Source& by)
{
    return operatorOnly(by).and_then([this] { return driveGates().mayLeaveBus(); }).map([&] {
        m_helm.takeOver(by);
        m_helm.hold(Activity::None);
        m_log.add(Severity::Warning, by.name, service().leaveBus());
    });
}

Result<> MountDesk::ask(const request::TakeBus&, const Source& by)
{
    return operatorOnly(by)
        .and_then([this] { return driveGates().mayTakeBus(); })
        .and_then([this] { return service().takeBus(); })
        .map([&] {
            m_log.add(Severity::Advisory, by.name, Text::tr("takes the bus back, and reads the drives again"));
        });
}

// The next target of a client would move the mount before its box was seen standing still. So the operator takes the
// control.
Result<> MountDesk::ask(const request::TypeLine& wanted, const Source& by)
{
    return operatorOnly(by).and_then([this] { return mayTypeLine(m_helm.view()); }).map([&] {
        m_helm.takeOver(by);
        m_helm.hold(Activity::None);
        m_log.add(Severity::Warning, by.name, Text::tr("types to the control box: %1").arg(toQString(wanted.line)));
    });
}

// The next target of a client would stop the run. So the operator takes the control.
Result<> MountDesk::ask(const request::MakeHomeRun&, const Source& by)
{
    return operatorOnly(by).and_then([&] { return mayMakeHomeRun(m_helm.view(), by); }).map([&] {
        m_helm.takeOver(by);
        m_helm.hold(Activity::None);
        m_log.add(Severity::Warning, by.name, Text::tr("starts a home run of the rotator"));
    });
}

Result<> MountDesk::ask(const request::ChooseTurn& wanted, const Source& by)
{
    return operatorOnly(by).and_then([&] { return driveGates().mayChooseTurn(wanted.axis); }).and_then([&] {
        m_helm.takeOver(by);
        return service().chooseWrap(wanted.axis, wanted.angle, by.name);
    });
}

Result<> MountDesk::ask(const request::ProveCrashStop& wanted, const Source& by)
{
    return operatorOnly(by).and_then([&] { return driveGates().mayProve(by); }).and_then([&] {
        const AngularRate rate = abs(wanted.rate);
        const pointing::AxisBox here = pointing::AxisBox::at(*m_mount.measured());
        const ControlParts view = m_helm.view();
        const pointing::PermittedRegion& region = view.motion.region();
        return service()
            .mayProve(rate, region.azimuthsAround(here), region.elevationsAround(here))
            .and_then([&] {
                return m_helm.beginOwn(Activity::Proving, by,
                                       Text::tr("crash-stop test at %1°/s").arg(rate.degrees(), 0, 'f', 1));
            })
            .map([this] { service().beginProof(); });
    });
}

Result<> MountDesk::ask(const request::EndProof&, const Source& by)
{
    return driveGates().mayEndProof().map([&] {
        service().endProof(Text::tr("ended by the %1").arg(Text::of(by.name.toStdString())));
        m_helm.hold(Activity::Holding);
    });
}

Result<> MountDesk::ask(const request::ReadGains& wanted, const Source& by)
{
    return operatorOnly(by).and_then([&] { return driveGates().mayTune(wanted.axis); });
}

// The next target of a client would move the axis during the change. So the operator takes the control.
Result<> MountDesk::ask(const request::SetGain& wanted, const Source& by)
{
    const bool off = wanted.gain == Gain::EncoderFilter;
    return operatorOnly(by)
        .and_then([&] { return off ? driveGates().mayTuneOff(wanted.axis) : driveGates().mayTune(wanted.axis); })
        .map([&] { m_helm.takeOver(by); });
}

Result<> MountDesk::ask(const request::PutGainsBack& wanted, const Source& by)
{
    return operatorOnly(by).and_then([&] { return driveGates().mayTune(wanted.axis); }).map([&] {
        m_helm.takeOver(by);
    });
}

Result<> MountDesk::ask(const request::StoreGains& wanted, const Source& by)
{
    return operatorOnly(by).and_then([&] { return driveGates().mayTuneOff(wanted.axis); }).map([&] {
        m_helm.takeOver(by);
    });
}

}  // namespace boresight
