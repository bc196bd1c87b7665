// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/system/fault_run.h"

#include "tests/system/standing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace boresight::system_test {
namespace {

constexpr Seconds kLook{0.001};
// The drives have been on for this time. Otherwise the journal cannot prove that they kept their power.
constexpr Seconds kOn{15.0};
constexpr Seconds kAskPeriod{0.8};  // of a client's stream
constexpr std::chrono::milliseconds kFirstAsk{1000};
constexpr Seconds kKeysHeldOn{0.5};  // until the operator has understood
constexpr Seconds kReturn{5.0};      // for a new drive check
// More than the Coulomb friction (5.5 Nm) and less than the breakaway friction (7 Nm). Friction alone does not stop a
// moving elevation axis that gravity pulls along, but holds an axis that stands still.
constexpr double kFaultRunUnbalance = 6.5;

AxisPosition startOf(Moment moment, const SatellitePass& pass, Seconds passTime)
{
    switch (moment) {
        case Moment::InSlew:
        case Moment::WhileBraking:
            return {.azimuth = 400_deg, .elevation = 50_deg};
        case Moment::AtLowerEnd:
            return {.azimuth = -60_deg, .elevation = 24_deg};
        case Moment::InTrack:
            return {.azimuth = pass.at(passTime).azimuth, .elevation = pass.at(passTime).elevation};
        case Moment::InJog:
            return {.azimuth = 425_deg, .elevation = 45_deg};
        case Moment::AtRest:
        case Moment::WhileEnabling:
            break;
    }
    return {.azimuth = 180_deg, .elevation = 45_deg};
}

sim::PairSettings unbalanced(const AxisPosition& start)
{
    sim::PairSettings pair = sim::commissionedPair(start);
    pair.elevation.plant.gravityTorque = kFaultRunUnbalance;
    return pair;
}

// The two clients of a case take turns.
profile::Profile lastMoves()
{
    profile::Profile profile = anyPort();
    profile.rotctld.control = profile::ControlRule::Last;
    return profile;
}

Angle outside(const TravelRange& travel, Angle angle)
{
    return std::max({angle - travel.max, travel.min - angle, Angle()});
}

}  // namespace

FaultRun::FaultRun(const FaultCase& faultCase)
    : m_case(faultCase),
      rig(lastMoves(), unbalanced(startOf(faultCase.moment, m_pass, m_passTime))),
      m_client(rig.connect())
{
    // There is always a little wind: 2 Nm on azimuth, 1 Nm on elevation in the direction of gravity.
    rig.link->inject({.kind = sim::FaultKind::Wind, .axis = Axis::Azimuth, .value = 2.0});
    rig.link->inject({.kind = sim::FaultKind::Wind, .axis = Axis::Elevation, .value = -1.0});
    rig.run(kOn);
    if (m_case.moment == Moment::InTrack) {
        m_gpredict.emplace(rig.connect(), m_pass);
    }
}

FaultOutcome FaultRun::run()
{
    reach();
    breakDown();
    if (m_case.fault.outcome == Outcome::Latches) {
        stayUntilRearmed();
        rearm();
    }
    moveAgain();
    return m_outcome;
}

void FaultRun::reach()
{
    const auto azimuth = [this] { return rig.truth().azimuth; };
    switch (m_case.moment) {
        case Moment::AtRest:
            EXPECT_EQ(m_client->ask("P 181 45.5\n"), "RPRT 0\n");
            EXPECT_TRUE(rig.settle());
            break;
        case Moment::InSlew:
        case Moment::WhileBraking:
            EXPECT_EQ(m_client->ask("P 90 90\n"), "RPRT 0\n");
            EXPECT_TRUE(rig.runUntil([&] { return azimuth() > (m_case.moment == Moment::InSlew ? 436_deg : 446_deg); },
                                     Seconds(10.0)));
            break;
        case Moment::AtLowerEnd:
            EXPECT_EQ(m_client->ask("P 270 0\n"), "RPRT 0\n");
            EXPECT_TRUE(rig.runUntil([&] { return azimuth() < Angle::fromDegrees(-89.6); }, Seconds(10.0)));
            break;
        case Moment::InTrack:
            while (m_passTime < Seconds(-20.0)) {
                tick();
            }
            break;
        case Moment::InJog:
            m_keysHeld = true;
            for (int i = 0; i < 125; ++i) {
                tick();
            }
            break;
        case Moment::WhileEnabling:
            EXPECT_EQ(m_client->ask("P 200 60\n"), "RPRT 0\n");
            rig.run(2 * SimulatedStation::kTick);
            break;
    }
}

void FaultRun::breakDown()
{
    m_began = rig.clock.now();
    m_stood = rig.truth();
    m_faulty = true;
    m_left = true;
    for (const sim::Injection& injection : m_case.fault.injections) {
        m_handles.push_back(rig.link->inject(injection));
    }
    if (m_case.fault.once) {
        m_case.fault.once(rig);
    }
    // During the stall nobody reads the bus. The frames are read afterwards.
    for (Seconds stalled{0.0}; stalled < m_case.fault.stall; stalled += SimulatedStation::kTick) {
        watchUntilTick();
        rig.clock.advance(SimulatedStation::kTick);
        look(sinceFault());
    }
    m_nextAsk = rig.clock.now() + kFirstAsk;
    const SteadyTime over = rig.clock.now() + std::chrono::duration_cast<SteadyTime::duration>(kFaultLasts);
    while (rig.clock.now() < over) {
        m_keysHeld = m_keysHeld && sinceFault() < m_case.fault.stall + kKeysHeldOn;
        if (m_case.fault.eachTick) {
            m_case.fault.eachTick(rig);
        }
        tick();
        noteAlarm();
    }
    m_keysHeld = false;
    for (const Axis axis : kAxes) {
        m_outcome.torque[index(axis)] = std::abs(rig.link->truth(axis).torque);
    }
    for (const auto handle : m_handles) {
        rig.link->pair().faults().remove(handle);
    }
    m_faulty = false;
}

void FaultRun::stayUntilRearmed()
{
    const AxisPosition here = rig.truth();
    for (Seconds passed{0.0}; passed < kAfter; passed += SimulatedStation::kTick) {
        tick();
        noteAlarm();
        const AxisPosition now = rig.truth();
        m_outcome.moved[0] = std::max(m_outcome.moved[0], abs(now.azimuth - here.azimuth));
        m_outcome.moved[1] = std::max(m_outcome.moved[1], abs(now.elevation - here.elevation));
    }
    for (const Axis axis : kAxes) {
        const moteus::Mode mode = rig.link->truth(axis).mode;
        m_outcome.off[index(axis)] = mode == moteus::Mode::Stopped || mode == moteus::Mode::Fault;
    }
    m_outcome.state = word(rig.status().state).toStdString();
}

void FaultRun::rearm()
{
    const AxisPosition here = rig.truth();
    m_left = false;
    m_outcome.again = "Re-arm";
    EXPECT_EQ(rig.ask(request::Rearm{}), "");
    EXPECT_TRUE(rig.runUntil([&] { return rig.status().state != StationState::Fault; }, kReturn));
    EXPECT_TRUE(rig.runUntil([&] { return rig.status().drives->armingObstacle.isEmpty(); }, kReturn))
        << rig.status().drives->armingObstacle.toStdString();
    rig.run(Seconds(1.0));
    m_outcome.movedByRearming = rig.farthestFrom(here);
    for (const Axis axis : kAxes) {
        const StationStatus status = rig.status();
        if (!(axis == Axis::Azimuth ? status.azimuth : status.elevation).turnKnown) {
            EXPECT_EQ(rig.ask(request::ChooseTurn{axis, Angle::fromDegrees(rig.truth(axis))}), "");
            rig.run(Seconds(0.5));
            m_outcome.again = "Re-arm, enter the position";
        }
    }
    EXPECT_EQ(rig.ask(request::GiveAuthority{}), "");
}

void FaultRun::moveAgain()
{
    m_left = false;
    if (m_case.fault.outcome == Outcome::GoesOn) {
        m_outcome.state = word(rig.status().state).toStdString();
        m_outcome.again = "none";
        EXPECT_EQ(rig.ask(request::GiveAuthority{}), "");  // the operator may have jogged
    }
    m_gpredict.reset();
    const Angle azimuth = std::clamp(rig.truth().azimuth + 5_deg, -80_deg, 440_deg);
    const Angle elevation = std::clamp(rig.truth().elevation - 5_deg, 5_deg, 80_deg);
    const std::string target =
        "P " + std::to_string(azimuth.wrapped360().degrees()) + " " + std::to_string(elevation.degrees()) + "\n";
    EXPECT_EQ(m_client->ask(target), "RPRT 0\n");
    EXPECT_TRUE(rig.settle(Seconds(20.0)));
    EXPECT_LT(rig.farthestFrom({.azimuth = azimuth, .elevation = elevation}), m_case.fault.arrives) << target;
}

void FaultRun::tick()
{
    watchUntilTick();
    rig.tick();
    m_passTime += SimulatedStation::kTick;
    ask();
    look(sinceFault());
}

// Between two ticks nothing reaches the drives. The simulated mount moves ahead of the clock.
void FaultRun::watchUntilTick()
{
    if (!m_faulty) {
        return;
    }
    sim::SimulatedPair& pair = rig.link->pair();
    const Seconds now = pair.now();
    for (Seconds ahead = kLook; ahead < SimulatedStation::kTick; ahead += kLook) {
        pair.advanceTo(now + ahead);
        look(sinceFault() + ahead);
    }
}

void FaultRun::look(Seconds sinceFault)
{
    const profile::Profile profile = anyPort();
    for (const Axis axis : kAxes) {
        const sim::AxisTruth truth = rig.link->pair().truth(axis);
        const auto i = index(axis);
        if (m_faulty && abs(truth.rate) > kStandingStill) {
            m_outcome.still[i] = sinceFault + kLook;
        }
        const TravelRange& travel = profile.axis(axis).geometry.travel;
        m_outcome.beyond[i] = std::max(m_outcome.beyond[i], outside(travel, truth.angle));
        if (m_left) {
            const Angle stood = axis == Axis::Azimuth ? m_stood.azimuth : m_stood.elevation;
            m_outcome.strayed[i] = std::max(m_outcome.strayed[i], abs(truth.angle - stood));
        }
    }
}

void FaultRun::ask()
{
    if (m_gpredict) {
        m_gpredict->tick(m_passTime);
    }
    if (m_keysHeld && rig.status().tick % 2 == 0) {
        jog();
    }
    const bool streams = m_began != SteadyTime{} && !m_gpredict && m_case.fault.outcome == Outcome::Latches;
    if (streams && rig.clock.now() >= m_nextAsk) {
        m_nextAsk = rig.clock.now() + std::chrono::duration_cast<SteadyTime::duration>(kAskPeriod);
        static_cast<void>(m_client->ask("P 30 20\n"));
    }
}

void FaultRun::jog()
{
    const std::string answer = rig.ask(request::Jog{{.azimuth = 6_deg_s, .elevation = 3_deg_s}});
    if (m_began == SteadyTime{}) {
        EXPECT_EQ(answer, "");
    }
}

void FaultRun::noteAlarm()
{
    if (m_outcome.alarm || m_case.fault.alarm.empty()) {
        return;
    }
    // If the motion ends for good, an alarm must report it. A warning before it does not count.
    const bool latches = m_case.fault.outcome == Outcome::Latches;
    const auto tells = [latches](Severity severity) {
        return latches ? severity == Severity::Alarm : severity != Severity::Advisory;
    };
    for (const Alarm& alarm : rig.status().alarms) {
        if (tells(alarm.severity) &&
            alarm.what.contains(QString::fromStdString(m_case.fault.alarm), Qt::CaseInsensitive)) {
            m_outcome.alarm = sinceFault() - m_case.fault.stall;
            m_outcome.text = alarm.what.toStdString();
            EXPECT_FALSE(alarm.action.isEmpty() || alarm.remedy.isEmpty()) << m_outcome.text;
            return;
        }
    }
}

}  // namespace boresight::system_test
