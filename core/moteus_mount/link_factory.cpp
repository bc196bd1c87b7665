// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus_mount/link_factory.h"

#include "core/base/bus_name.h"
#include "core/base/text.h"
#include "core/can/fdcanusb_link.h"
#include "core/can/socketcan_link.h"
#include "core/can/unusable_link.h"
#include "core/drive_check/protections.h"
#include "core/moteus_mount/moteus_connection.h"
#include "core/sim_bus/simulated_link.h"

#include <algorithm>

namespace boresight {

namespace {

// Writes the settings that Fix would write.
void protect(sim::DriveConfig& drive, const profile::Profile& profile, Axis axis)
{
    for (const drive_check::Protection& protection : drive_check::protectionsOf(profile, axis)) {
        const auto found = sim::configText(drive, protection.key);
        const drive_check::Reading reading{.state = drive_check::Reading::State::Read,
                                           .text = found.value_or(std::string())};
        if (found && protection.remedy && drive_check::judged(protection, reading).verdict != Verdict::Right) {
            (void)sim::setConfigText(drive, protection.key, drive_check::settingText(*protection.remedy));
        }
    }
}

// The rubber stops stand 8° beyond the travel of the profile, or where those of the simulated mount stand if that is
// farther away. The bounds of a protected drive are 3° beyond the travel.
void moveStopsBeyond(sim::MoteusSettings& drive)
{
    constexpr double kTurnsBeyondBounds = 5.0 / 360.0;
    drive.plant.stopMin = std::min(drive.plant.stopMin, drive.config.positionMin - kTurnsBeyondBounds);
    drive.plant.stopMax = std::max(drive.plant.stopMax, drive.config.positionMax + kTurnsBeyondBounds);
}

Result<std::unique_ptr<CanLink>> makeLinkTo(const std::string& busName, const Clock& clock,
                                            const std::shared_ptr<SimulatedMount>& simulated)
{
    return parseBusName(busName).and_then([&](const BusName& bus) -> Result<std::unique_ptr<CanLink>> {
        const QString target = QString::fromStdString(bus.target);
        switch (bus.kind) {
            case BusKind::SocketCan:
                return std::make_unique<SocketCanLink>(target, clock);
            case BusKind::Fdcanusb:
                return std::make_unique<FdcanusbLink>(target, clock);
            case BusKind::Serial:
            case BusKind::Tcp:
            case BusKind::Rotctld:
            case BusKind::Hamlib:
                return failure(ErrorCode::InvalidInput,
                               Text::tr("%1 is not a CAN bus. A moteus needs fdcanusb:PATH or socketcan:INTERFACE")
                                   .arg(toQString(busName)));
            case BusKind::Simulated:
                break;
        }
        return simulated ? std::make_unique<SimulatedLink>(clock, simulated) : std::make_unique<SimulatedLink>(clock);
    });
}

}  // namespace

sim::PairSettings protectedPair(const profile::Profile& profile)
{
    sim::PairSettings pair = sim::commissionedPair();
    for (sim::MoteusSettings* const drive : {&pair.azimuth, &pair.elevation}) {
        for (const Axis axis : {Axis::Azimuth, Axis::Elevation}) {
            if (profile.axis(axis).driver != profile::AxisDriver::None && drive->config.id == profile.axis(axis).id) {
                protect(drive->config, profile, axis);
                moveStopsBeyond(*drive);
            }
        }
    }
    return pair;
}

Result<std::unique_ptr<CanLink>> makeLink(const std::string& busName, const Clock& clock)
{
    return makeLinkTo(busName, clock, nullptr);
}

LinkMaker::LinkMaker(const profile::Profile& profile, const Clock& clock)
    : m_clock(clock), m_simulated(std::make_shared<SimulatedMount>(clock, protectedPair(profile)))
{
    m_simulated->sensor.truth() = sim::truthToBeFound();
}

std::unique_ptr<CanLink> LinkMaker::make(const profile::Profile& profile, const MountStart& start) const
{
    if (!start.simulation.on) {
        return make(profile.bus);
    }
    for (const Axis axis : kAxes) {
        m_simulated->pair.setFitted(axis, std::ranges::find(start.axes, axis) != start.axes.end());
    }
    return make(toString(BusName{}));
}

std::unique_ptr<CanLink> LinkMaker::make(const std::string& busName) const
{
    auto link = makeLinkTo(busName, m_clock, m_simulated);
    return link ? std::move(*link) : std::make_unique<UnusableLink>(QString::fromStdString(busName), link.error());
}

MountKind moteusRotators(const LinkMaker& links)
{
    return [links](const profile::Profile& profile, const MountStart& start) {
        return moteusRotator(links.make(profile, start), start);
    };
}

RotatorOffer moteusOffer()
{
    return {.driver = profile::AxisDriver::Moteus,
            .name = Text::tr("moteus drives on a CAN bus, or the simulated mount"),
            .isListed = true};
}

}  // namespace boresight
