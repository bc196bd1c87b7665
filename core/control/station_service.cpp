// SPDX-License-Identifier: GPL-3.0-or-later
// The part of StationControl for what is done to the drives themselves: turns, proof, switching off, leaving the bus.
#include "core/base/text.h"
#include "core/control/station_control.h"
#include "core/mount/mount_service.h"

namespace boresight {

Result<MountService*> StationControl::serviceFor(const Source& source) const
{
    return operatorOnly(source).and_then([this]() -> Result<MountService*> {
        if (m_mount.service() == nullptr) {
            return failure(ErrorCode::NotAvailable, Text::tr("this rotator has no such service"));
        }
        return m_mount.service();
    });
}

Result<> StationControl::handle(const request::ReadDrives&, const Source& source)
{
    return serviceFor(source).and_then([this](const auto*) { return gates().drivesRest(); });
}

Result<> StationControl::handle(const request::FixDrives&, const Source& source)
{
    return serviceFor(source).and_then([&](const MountService* service) -> Result<> {
        if (!m_arming.connected()) {
            return failure(ErrorCode::NoAnswer, Text::tr("both drives must answer"));
        }
        return service->mayBeWritten().map([&] {
            takeOver(source);  // else the next target of a client would switch them on in the middle of it
        });
    });
}

Result<> StationControl::handle(const request::SwitchOff&, const Source& source)
{
    return serviceFor(source).and_then([&](MountService* service) {
        return gates().drivesRest().and_then([&]() -> Result<> {
            if (!m_arming.connected()) {
                return failure(ErrorCode::NoAnswer, Text::tr("both drives must answer"));
            }
            takeOver(source);  // else the next target of a client would switch them on again
            holdHere(Activity::None);
            service->switchOff();
            m_log.add(Severity::Warning, source.name, Text::tr("switches both drives off: nothing holds the axes"));
            return {};
        });
    });
}

Result<> StationControl::handle(const request::ReleaseBus&, const Source& source)
{
    return serviceFor(source).and_then([&](MountService* service) {
        return gates().drivesRest().map([&] {
            takeOver(source);
            holdHere(Activity::None);
            service->leaveBus();
            m_log.add(Severity::Warning, source.name,
                      Text::tr("leaves the bus to other tools; drives that held go on by their time-out mode"));
        });
    });
}

Result<> StationControl::handle(const request::TakeBus&, const Source& source)
{
    return serviceFor(source).and_then([&](MountService* service) {
        return service->takeBus().map([&] {
            m_log.add(Severity::Advisory, source.name, Text::tr("takes the bus back: the drives are read anew"));
        });
    });
}

Result<> StationControl::handle(const request::ChooseTurn& wanted, const Source& source)
{
    return serviceFor(source).and_then([&](MountService* service) {
        return gates().drivesRest().and_then([&] {
            takeOver(source);
            return service->chooseWrap(wanted.axis, wanted.angle, source.name);
        });
    });
}

Result<> StationControl::handle(const request::ProveCrashStop& wanted, const Source& source)
{
    return serviceFor(source).and_then([&](MountService* service) {
        return mayPoint(source).and_then([&] {
            const AngularRate rate = abs(wanted.rate);
            const pointing::AxisBox here = pointing::AxisBox::at(*m_mount.measured());
            const pointing::PermittedRegion& region = m_motion.region();
            return service->beginProof(rate, region.azimuthsAround(here), region.elevationsAround(here)).map([&] {
                begin(Activity::Proving, source, Text::tr("crash-stop proof at %1°/s").arg(rate.degrees(), 0, 'f', 1));
            });
        });
    });
}

Result<> StationControl::handle(const request::EndProof&, const Source& source)
{
    if (!m_mount.proofRunning()) {
        return failure(ErrorCode::Refused, Text::tr("no proof is running"));
    }
    m_mount.service()->endProof(Text::tr("ended by the %1").arg(Text::of(source.name.toStdString())));
    holdHere(Activity::Holding);
    return {};
}

}  // namespace boresight
