// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus_mount/link_factory.h"

#include "core/base/bus_name.h"
#include "core/base/text.h"
#include "core/can/fdcanusb_link.h"
#include "core/can/socketcan_link.h"
#include "core/can/unusable_link.h"
#include "core/contacts/input_name.h"
#include "core/contacts/output_name.h"
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

std::optional<Axis> simulatedAxis(sim::SimulatedPair& pair, int id)
{
    const auto* const found =
        std::ranges::find_if(kAxes, [&](Axis axis) { return pair.drive(axis).driveConfig().id == id; });
    return found != kAxes.end() ? std::optional(*found) : std::nullopt;
}

// The feed with the travel of the profile, in the middle of it. Its position after power-up is known.
std::optional<sim::MoteusSettings> thirdBoard(const profile::ThirdAxisSettings& third)
{
    if (!third.isUsed()) {
        return std::nullopt;
    }
    sim::MoteusSettings feed = sim::commissionedFeed(third.axis.id);
    const pointing::AxisGeometry& geometry = third.axis.geometry;
    constexpr Angle kBounds = Angle::fromDegrees(3.0);
    const double low = geometry.toMotor(geometry.travel.min - kBounds).turns();
    const double high = geometry.toMotor(geometry.travel.max + kBounds).turns();
    feed.config.positionMin = std::min(low, high);
    feed.config.positionMax = std::max(low, high);
    feed.position = (low + high) / 2.0;
    moveStopsBeyond(feed);
    return feed;
}

// Puts each end switch of the profile just outside the travel of its axis.
void wireSwitches(sim::SimulatedPair& pair, const profile::Profile& profile)
{
    constexpr Angle kOutside = Angle::fromDegrees(1.0);
    for (const end_switches::EndSwitch& one : end_switches::kEndSwitches) {
        const auto name = contacts::parseInput(profile.endSwitches.input(one));
        const profile::AxisSettings& settings = profile.axis(one.axis);
        const auto board =
            name && name->kind == contacts::InputKind::Pin ? simulatedAxis(pair, name->pin.board) : std::nullopt;
        const auto axis = simulatedAxis(pair, settings.id);
        if (!board || !axis) {
            continue;
        }
        const TravelRange& travel = settings.geometry.travel;
        const Angle at = one.isUpper ? travel.max + kOutside : travel.min - kOutside;
        const double turns = settings.geometry.toMotor(at).turns();
        pair.wire({.board = *board,
                   .port = name->pin.port,
                   .pin = name->pin.number,
                   .axis = *axis,
                   .at = turns,
                   .isAbove = turns > settings.geometry.toMotor(travel.min + 0.5 * (travel.max - travel.min)).turns(),
                   .isHighWhenPressed = profile.endSwitches.pressedWhen == profile::PressedWhen::On});
    }
}

// The pin that releases the brakes is an output.
void wireBrake(sim::SimulatedPair& pair, const profile::Profile& profile)
{
    const auto output = contacts::parseOutput(profile.brake.output);
    if (output && output->kind == contacts::OutputKind::Pin) {
        if (const auto board = simulatedAxis(pair, output->pin.board)) {
            pair.drive(*board).makeOutput(output->pin.port, output->pin.number);
        }
    }
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
    pair.third = thirdBoard(profile.thirdAxis);
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
    wireSwitches(m_simulated->pair, profile);
    wireBrake(m_simulated->pair, profile);
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
