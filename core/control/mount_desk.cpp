// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/control/mount_desk.h"

#include "core/base/text.h"

namespace boresight {

Result<MountService*> MountDesk::serviceFor(const Source& by) const
{
    return operatorOnly(by).and_then([this]() -> Result<MountService*> {
        if (m_mount.service() == nullptr) {
            return failure(ErrorCode::NotAvailable, Text::tr("this rotator does not offer this"));
        }
        return m_mount.service();
    });
}

Result<> MountDesk::drivesAnswer() const
{
    return m_arming.connected() ? Result<>{} : failure(ErrorCode::NoAnswer, Text::tr("both drives must answer"));
}

Result<> MountDesk::ask(const request::ReadDrives&, const Source& by)
{
    return serviceFor(by).and_then([this](const MountService*) { return drivesRest(); });
}

Result<> MountDesk::ask(const request::FixDrives&, const Source& by)
{
    return serviceFor(by).and_then([&](const MountService* service) {
        return drivesAnswer().and_then([&] { return service->mayBeWritten(); }).map([&] {
            m_helm.takeOver(by);  // else the next target of a client would switch them on in the middle of it
        });
    });
}

Result<> MountDesk::ask(const request::SwitchOff&, const Source& by)
{
    return serviceFor(by).and_then([&](MountService* service) {
        return drivesRest().and_then([&] { return drivesAnswer(); }).map([&] {
            m_helm.takeOver(by);  // else the next target of a client would switch them on again
            m_helm.hold(Activity::None);
            service->switchOff();
            m_log.add(Severity::Warning, by.name, Text::tr("switches both drives off: nothing holds the axes"));
        });
    });
}

Result<> MountDesk::ask(const request::ReleaseBus&, const Source& by)
{
    return serviceFor(by).and_then([&](MountService* service) {
        return drivesRest().map([&] {
            m_helm.takeOver(by);
            m_helm.hold(Activity::None);
            service->leaveBus();
            m_log.add(Severity::Warning, by.name,
                      Text::tr("leaves the bus to other tools; drives that held go on by their time-out mode"));
        });
    });
}

Result<> MountDesk::ask(const request::TakeBus&, const Source& by)
{
    return serviceFor(by).and_then([&](MountService* service) {
        return service->takeBus().map(
            [&] { m_log.add(Severity::Advisory, by.name, Text::tr("takes the bus back: the drives are read anew")); });
    });
}

Result<> MountDesk::ask(const request::ChooseTurn& wanted, const Source& by)
{
    return serviceFor(by).and_then([&](MountService* service) {
        return drivesRest().and_then([&] {
            m_helm.takeOver(by);
            return service->chooseWrap(wanted.axis, wanted.angle, by.name);
        });
    });
}

Result<> MountDesk::ask(const request::ProveCrashStop& wanted, const Source& by)
{
    return serviceFor(by).and_then([&](MountService* service) {
        return m_helm.mayPoint(by).and_then([&] {
            const AngularRate rate = abs(wanted.rate);
            const pointing::AxisBox here = pointing::AxisBox::at(*m_mount.measured());
            const ControlParts view = m_helm.view();
            const pointing::PermittedRegion& region = view.motion.region();
            return service->mayProve(rate, region.azimuthsAround(here), region.elevationsAround(here))
                .and_then([&] {
                    return m_helm.beginOwn(Activity::Proving, by,
                                           Text::tr("crash-stop proof at %1°/s").arg(rate.degrees(), 0, 'f', 1));
                })
                .map([&] { service->beginProof(); });
        });
    });
}

Result<> MountDesk::ask(const request::EndProof&, const Source& by)
{
    if (!m_mount.proofRunning()) {
        return failure(ErrorCode::Refused, Text::tr("no proof is running"));
    }
    m_mount.service()->endProof(Text::tr("ended by the %1").arg(Text::of(by.name.toStdString())));
    m_helm.hold(Activity::Holding);
    return {};
}

}  // namespace boresight
