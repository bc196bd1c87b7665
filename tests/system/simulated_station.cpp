// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/system/simulated_station.h"

#include "core/moteus_mount/moteus_connection.h"
#include "tests/fakes/text_of.h"

#include <QTest>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace boresight::system_test {
namespace {

constexpr Seconds kReading{10.0};  // to read the safety settings of the drives over their consoles
constexpr AngularRate kSimulatedStationStill = AngularRate::fromDegrees(0.01);

void turnEventLoop()
{
    QTest::qWait(0);
}

}  // namespace

profile::Profile anyPort()
{
    profile::Profile profile;
    profile.rotctld.listen.port = 0;
    return profile;
}

SimulatedStation::SimulatedStation(const profile::Profile& profile, const sim::PairSettings& pair)
    : step(profile.control.tickPeriod())
{
    auto owned = std::make_unique<SimulatedLink>(clock, pair);
    link = owned.get();
    station = std::make_unique<Station>(
        profile, moteusRotator(std::move(owned), {m_stateDir.path(), simulationOf(Simulation::Off, profile)}),
        m_stateDir.path(), clock);
    QObject::connect(station.get(), &Station::started,
                     [this](const QString& listening) { m_port = listening.section(QLatin1Char(':'), -1).toUShort(); });
    QObject::connect(station.get(), &Station::updated, [this](const StationUpdate& update) {
        log.insert(log.end(), update.log.begin(), update.log.end());
        m_answers = update.answers;
    });
    station->openAll();
    run(Seconds(0.2));
    EXPECT_TRUE(runUntil([this] { return ready(); }, kReading))
        << station->status().drives->armingObstacle.toStdString();
}

bool SimulatedStation::ready() const
{
    const StationStatus now = status();
    return now.drives->armingObstacle.isEmpty() && now.azimuth.turnKnown && now.elevation.turnKnown;
}

void SimulatedStation::tick()
{
    clock.advance(step);
    link->deliver();
    station->tick();
    link->deliver();  // replies that are not late arrive within the tick
    turnEventLoop();
    if (onTick) {
        onTick();
    }
}

void SimulatedStation::run(Seconds time)
{
    const auto ticks = std::lround(time / step);
    for (long i = 0; i < ticks; ++i) {
        tick();
    }
}

bool SimulatedStation::runUntil(const std::function<bool()>& condition, Seconds limit)
{
    for (Seconds waited{0.0}; !condition(); waited += step) {
        if (waited > limit) {
            return false;
        }
        tick();
    }
    return true;
}

bool SimulatedStation::settle(Seconds limit)
{
    run(Seconds(0.2));
    const auto stands = [this](Axis axis) { return abs(link->truth(axis).rate) < kSimulatedStationStill; };
    const auto rests = [](const AxisStatus& axis) { return axis.state != AxisState::Moving; };
    return runUntil(
        [&] {
            if (!stands(Axis::Azimuth) || !stands(Axis::Elevation)) {
                return false;  // a status takes longer than a tick
            }
            const StationStatus now = status();
            return rests(now.azimuth) && rests(now.elevation) && now.state != StationState::Slew;
        },
        limit);
}

std::unique_ptr<fakes::TcpPeer> SimulatedStation::connect() const
{
    return std::make_unique<fakes::TcpPeer>("127.0.0.1", m_port, &turnEventLoop);
}

fakes::CaseTarget SimulatedStation::caseTarget()
{
    return {.host = "127.0.0.1",
            .port = m_port,
            .pump = &turnEventLoop,
            .elapse = [this](std::chrono::milliseconds time) { run(time); },
            .patience = std::chrono::milliseconds(100)};
}

std::string SimulatedStation::ask(const Request& request)
{
    collectLog();
    station->request({.id = ++m_lastRequest, .request = request});
    collectLog();
    const auto answer = std::ranges::find(m_answers, m_lastRequest, &Answer::requestId);
    if (answer == m_answers.end()) {
        return "no answer";
    }
    return answer->error ? textOf(*answer->error) : std::string();
}

AxisPosition SimulatedStation::truth() const
{
    return {.azimuth = link->truth(Axis::Azimuth).angle, .elevation = link->truth(Axis::Elevation).angle};
}

Angle SimulatedStation::farthestFrom(const AxisPosition& place) const
{
    const AxisPosition now = truth();
    return std::max(abs(now.azimuth - place.azimuth), abs(now.elevation - place.elevation));
}

bool SimulatedStation::alarmSays(const QString& words) const
{
    return std::ranges::any_of(status().alarms, [&](const Alarm& alarm) {
        return alarm.what.contains(words, Qt::CaseInsensitive) && !alarm.action.isEmpty() && !alarm.remedy.isEmpty();
    });
}

bool SimulatedStation::logSays(const QString& words)
{
    collectLog();
    return std::ranges::any_of(log, [&](const LogEntry& entry) { return entry.text.contains(words); });
}

void SimulatedStation::collectLog()
{
    station->updateTaken();
    station->publish();
}

}  // namespace boresight::system_test
