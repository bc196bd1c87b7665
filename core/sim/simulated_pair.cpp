// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim/simulated_pair.h"

#include "core/moteus/faults.h"
#include "core/sim/reference_mount.h"

#include <algorithm>

namespace boresight::sim {
namespace {

constexpr double kSimulatedPairStep = 0.5e-3;  // s. At 12°/s a report is at most 0.006° old
// After a jump of the clock (a suspended computer) no more than this time is simulated.
constexpr Seconds kLongestCatchUp{3600.0};

std::array<std::uint8_t, 16> uuidOf(Axis axis)
{
    std::array<std::uint8_t, 16> uuid{0x62, 0x6f, 0x72, 0x65, 0x73, 0x69, 0x67, 0x68,
                                      0x74, 0x20, 0x73, 0x69, 0x6d, 0x20, 0x30, 0x31};
    uuid.back() = axis == Axis::Azimuth ? 0x31 : 0x32;
    return uuid;
}

std::array<std::uint8_t, 16> uuidOfThird()
{
    std::array<std::uint8_t, 16> uuid = uuidOf(Axis::Azimuth);
    uuid.back() = 0x33;
    return uuid;
}

MoteusSettings driveSettings(Axis axis, const DriveConfig& config, Angle start)
{
    const ReferenceAxis& mount = referenceAxis(axis);
    MoteusSettings settings{.config = config,
                            .plant = mount.plant,
                            .position = mount.toTurns(start),
                            .gearRatio = mount.gearRatio,
                            .noise = {.enabled = true, .seed = axis == Axis::Azimuth ? 11u : 12u}};
    settings.config.uuid = uuidOf(axis);
    return settings;
}

bool arbitratesBefore(const PairReply& one, const PairReply& other)
{
    return one.frame.id < other.frame.id;
}

}  // namespace

PairSettings commissionedPair(const AxisPosition& start)
{
    PairSettings pair{.azimuth = driveSettings(Axis::Azimuth, commissionedDrive(Axis::Azimuth), start.azimuth),
                      .elevation = driveSettings(Axis::Elevation, commissionedDrive(Axis::Elevation), start.elevation)};
    pair.azimuth.referenced = true;
    pair.elevation.referenced = true;
    return pair;
}

MoteusSettings commissionedFeed(int id)
{
    const ReferenceAxis& feed = referenceFeed();
    MoteusSettings settings{.config = commissionedDrive(id, feed),
                            .plant = feed.plant,
                            .gearRatio = feed.gearRatio,
                            .referenced = true,
                            .noise = {.enabled = true, .seed = 13U}};
    settings.config.uuid = uuidOfThird();
    return settings;
}

PairSettings factoryPair(const AxisPosition& start)
{
    return {.azimuth = driveSettings(Axis::Azimuth, {}, start.azimuth),
            .elevation = driveSettings(Axis::Elevation, {}, start.elevation)};
}

SimulatedPair::SimulatedPair(const PairSettings& settings)
    : m_supply(settings.supply),
      m_supplyVoltage(settings.supply.voltage),
      m_collisions(settings.collisions),
      m_sides{{{.axis = Axis::Azimuth,
                .drive = std::make_unique<SimulatedMoteus>(settings.azimuth),
                .spoiler = {Axis::Azimuth, settings.seed}},
               {.axis = Axis::Elevation,
                .drive = std::make_unique<SimulatedMoteus>(settings.elevation),
                .spoiler = {Axis::Elevation, settings.seed + 1}}}},
      m_third(settings.third ? std::make_unique<SimulatedMoteus>(*settings.third) : nullptr),
      m_random(settings.seed)
{}

void SimulatedPair::advanceTo(Seconds now)
{
    m_now = std::max(m_now, now);
    if (m_now - m_stepped > kLongestCatchUp) {
        m_stepped = m_now - kLongestCatchUp;
    }
    while (m_stepped + Seconds(kSimulatedPairStep) <= m_now) {
        applyFaults();
        step(kSimulatedPairStep);
        m_stepped += Seconds(kSimulatedPairStep);
    }
    applyFaults();
}

void SimulatedPair::step(double dt)
{
    double power = 0.0;
    for (const Side& side : m_sides) {
        power += side.drive->supplyPower();
    }
    power += m_third ? m_third->supplyPower() : 0.0;
    m_supply.step(dt, power);
    if (m_third) {
        m_third->step(dt, {.busVoltage = m_supply.voltage()});
    }
    for (Side& side : m_sides) {
        const double sign = referenceAxis(side.axis).sign;
        side.drive->step(dt, {.busVoltage = m_supply.voltage(),
                              .windTorque = sign * faultValue(FaultKind::Wind, side.axis, 0.0),
                              .persistentFault = side.injectedFault});
    }
    press();
}

void SimulatedPair::wire(const WiredSwitch& one)
{
    m_switches.push_back(one);
    press();
}

// Each switch by where the antenna is.
void SimulatedPair::press()
{
    for (const WiredSwitch& one : m_switches) {
        const double place = drive(one.axis).plant().loadPosition();
        const bool isPressed = one.isAbove ? place >= one.at : place <= one.at;
        drive(one.board).setPin(one.port, one.pin, isPressed == one.isHighWhenPressed);
    }
}

void SimulatedPair::applyFaults()
{
    if (m_faults.isEmpty() && !m_faultsApplied) {
        return;
    }
    applyPower();
    m_supply.setVoltage(faultValue(FaultKind::SupplyVoltage, Axis::Azimuth,
                                   faultValue(FaultKind::SupplyVoltage, Axis::Elevation, m_supplyVoltage)));
    for (Side& side : m_sides) {
        applyFaults(side);
    }
    m_faultsApplied = !m_faults.isEmpty();
}

void SimulatedPair::applyFaults(Side& side)
{
    const ReferenceAxis& mount = referenceAxis(side.axis);
    AxisPlant& plant = side.drive->plant();
    plant.setStalled(m_faults.isActive(FaultKind::Stall, side.axis, m_stepped));
    const std::optional<double> jam = m_faults.active(FaultKind::Jam, side.axis, m_stepped);
    plant.setJam(jam ? std::optional(mount.toTurns(Angle::fromDegrees(*jam))) : std::nullopt);
    side.drive->setRegisterMapVersion(
        static_cast<int>(faultValue(FaultKind::RegisterMap, side.axis, moteus::kRegisterMapVersion)));
    const int fault = static_cast<int>(faultValue(FaultKind::DriveFault, side.axis, 0.0));
    if (fault != 0 && fault != side.injectedFault && !moteus::isLimit(fault)) {
        side.drive->raiseFault(fault);
    }
    side.injectedFault = fault;
    const double slip = faultValue(FaultKind::EncoderSlip, side.axis, 0.0);
    if (slip != 0.0 && slip != side.injectedSlip) {
        side.drive->slipEncoder(mount.sign * slip / 360.0);
    }
    side.injectedSlip = slip;
}

// The power fails for both drives. During the failure somebody may turn an axis by hand.
void SimulatedPair::applyPower()
{
    const bool off = m_faults.isActive(FaultKind::PowerLoss, Axis::Azimuth, m_stepped) ||
                     m_faults.isActive(FaultKind::PowerLoss, Axis::Elevation, m_stepped);
    for (Side& side : m_sides) {
        const Injection* injection = m_faults.find(FaultKind::PowerLoss, side.axis, m_stepped);
        if (injection != nullptr) {
            side.handAngle = injection->value;
        } else if (!off && side.handAngle) {
            side.drive->place(referenceAxis(side.axis).toTurns(Angle::fromDegrees(*side.handAngle)));
            side.handAngle.reset();
        }
        side.drive->setPowered(!off && !m_faults.isActive(FaultKind::BoardPowerLoss, side.axis, m_stepped));
    }
    if (m_supply.isOn() == off) {
        m_supply.setOn(!off);
    }
}

double SimulatedPair::faultValue(FaultKind kind, Axis axis, double otherwise) const
{
    return m_faults.active(kind, axis, m_stepped).value_or(otherwise);
}

bool SimulatedPair::happens(FaultKind kind, Axis axis)
{
    const std::optional<double> probability = m_faults.active(kind, axis, m_now);
    return probability && std::uniform_real_distribution<double>(0.0, 1.0)(m_random) < *probability;
}

std::vector<PairReply> SimulatedPair::exchange(const CanFrame& frame, Seconds now)
{
    advanceTo(now);
    std::vector<PairReply> replies;
    for (const auto& [side, said] : ask(frame)) {
        const double delay = m_faults.active(FaultKind::LateReply, side->axis, m_now).value_or(0.0);
        for (const CanFrame& arriving : side->spoiler.spoil(said, m_faults, m_now, otherId(*side))) {
            replies.push_back({.frame = arriving,
                               .due = m_now + Seconds(delay),
                               .damaged = happens(FaultKind::CorruptLine, side->axis)});
        }
    }
    if (const auto said = m_third ? m_third->exchange(frame, (m_stepped - m_now).count()) : std::nullopt) {
        replies.push_back({.frame = *said, .due = m_now});
    }
    std::ranges::stable_sort(replies, arbitratesBefore);
    return replies;
}

std::vector<SimulatedPair::Answer> SimulatedPair::ask(const CanFrame& frame)
{
    std::vector<Answer> answers;
    for (Side& side : m_sides) {
        if (const auto reply = askOne(side, frame)) {
            answers.push_back({.side = &side, .frame = *reply});
        }
    }
    if (answers.size() == 2 && answers[0].frame.id == answers[1].frame.id) {
        // Two boards with one id answer together. If their frames differ, they destroy each other. Equal frames are one
        // frame.
        if (answers[0].frame == answers[1].frame) {
            answers.pop_back();
        } else if (m_collisions >= 1.0 || std::uniform_real_distribution<double>(0.0, 1.0)(m_random) < m_collisions) {
            m_replyCounts.collided += answers.size();
            answers.clear();
        }
    }
    return answers;
}

std::optional<CanFrame> SimulatedPair::askOne(Side& side, const CanFrame& frame)
{
    if (!side.fitted || happens(FaultKind::LostCommand, side.axis)) {
        return std::nullopt;
    }
    std::optional<int> answerAs;
    if (m_faults.isActive(FaultKind::DuplicateId, side.axis, m_now)) {
        answerAs = otherId(side);
    }
    const double age = (m_stepped - m_now).count();
    const std::optional<CanFrame> reply = side.drive->exchange(frame, age, answerAs);
    if (!reply) {
        return std::nullopt;
    }
    ++m_replyCounts.said;
    if (m_faults.isActive(FaultKind::Silence, side.axis, m_now) || happens(FaultKind::LostReply, side.axis)) {
        ++m_replyCounts.lost;
        return std::nullopt;
    }
    return reply;
}

int SimulatedPair::otherId(const Side& side) const
{
    return m_sides[1 - this->side(side.axis)].drive->driveConfig().id;
}

AxisTruth SimulatedPair::truth(Axis axis) const
{
    const SimulatedMoteus& drive = *m_sides[side(axis)].drive;
    const ReferenceAxis& mount = referenceAxis(axis);
    return {.angle = mount.toAngle(drive.plant().loadPosition()),
            .rate = AngularRate::fromTurns(drive.plant().velocity() / mount.sign),
            .torque = drive.outputTorque() / mount.sign,
            .current = drive.isPowered() ? drive.servo().output().qCurrent : 0.0,
            .mode = drive.servo().mode(),
            .faultCode = drive.servo().faultCode(),
            .powered = drive.isPowered()};
}

}  // namespace boresight::sim
