// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/station_transmit.h"

#include "core/alarms/catalogue.h"
#include "core/base/text.h"
#include "core/outputs/broker_output.h"
#include "core/outputs/command_output.h"
#include "core/outputs/modem_line.h"
#include "core/outputs/serial_modem_port.h"
#include "core/outputs/state_file.h"
#include "core/outputs/threaded_output.h"
#include "core/station/station_broker.h"
#include "core/units/degrees_text.h"

#include <QUuid>

#include <algorithm>
#include <utility>

namespace boresight {
namespace {

using contacts::OutputKind;
using transmit::Obstacle;

const QString kTransmitSource = QStringLiteral("transmit");
constexpr int kTransmitLinesPerSecond = 2;

// A client id of its own: a broker disconnects the first of two clients with the same id.
mqtt::Broker ownBroker(profile::BrokerSettings settings)
{
    if (!settings.clientId.empty()) {
        settings.clientId += "-transmit";
    }
    return brokerOf(settings, QStringLiteral("boresight-") + QUuid::createUuid().toString(QUuid::Id128).left(8));
}

std::unique_ptr<outputs::Output> lineOutput(const QString& port, outputs::Line line)
{
    const auto modem = std::make_shared<outputs::ModemLine>(std::make_unique<outputs::SerialModemPort>(port), line);
    return std::make_unique<outputs::ThreadedOutput>([modem](bool on) { return modem->set(on); });
}

bool isLive(const AxisStatus& axis)
{
    return axis.state == AxisState::Missing || (axis.age && *axis.age < StationTransmit::kOldestReport);
}

// The reasons to stay off that do not depend on the distance between beam and target.
Obstacle obstacleOf(const StationStatus& status)
{
    if (status.stopLatched) {
        return Obstacle::Stopped;
    }
    if (status.state == StationState::Fault || status.state == StationState::Disconnected) {
        return Obstacle::Fault;
    }
    const bool isStale = status.azel.phase == AzelPhase::Stale || status.position.phase == PositionPhase::Stale;
    if (!status.aimed || isStale) {
        return Obstacle::NoTarget;
    }
    if (status.tracked && !status.tracked->isUp) {
        return Obstacle::NotUp;
    }
    // While limited, the target in the status may be the nearest permitted place.
    return status.limited ? Obstacle::OutOfReach : Obstacle::None;
}

QString whyOff(const transmit::GateDecision& decision, Angle limit)
{
    switch (decision.obstacle) {
        case Obstacle::None:
            return {};
        case Obstacle::Simulated:
            return Text::tr("The mount is simulated (transmit.in_simulation).");
        case Obstacle::Stopped:
            return Text::tr("STOP is latched.");
        case Obstacle::Fault:
            return Text::tr("The mount has a fault or does not reply.");
        case Obstacle::NoTarget:
            return Text::tr("The mount has no target.");
        case Obstacle::NotUp:
            return Text::tr("The target is below the horizon.");
        case Obstacle::OutOfReach:
            return Text::tr("The target is outside the limits of the mount.");
        case Obstacle::NoPosition:
            return Text::tr("The mount reports no position.");
        case Obstacle::Settling:
            return Text::tr("The beam has just come to the target.");
        case Obstacle::Away:
            break;
    }
    return Text::tr("The beam is %1 from the target. The limit is %2.")
        .arg(degreesText(decision.error.value_or(Angle{}), 2), degreesText(limit, 2));
}

}  // namespace

StationTransmit::StationTransmit(const profile::InForce& profile, bool simulated, const Clock& clock, EventLog& log,
                                 AlarmBoard& alarms, QObject* parent)
    : QObject(parent),
      m_profile(profile),
      m_simulated(simulated),
      m_clock(clock),
      m_lines(log, clock, kTransmitLinesPerSecond),
      m_alarms(alarms),
      m_make([this](const contacts::OutputName& name) { return make(name); })
{}

StationTransmit::~StationTransmit()
{
    close();
}

std::unique_ptr<outputs::Output> StationTransmit::make(const contacts::OutputName& name) const
{
    switch (name.kind) {
        case OutputKind::File:
            return std::make_unique<outputs::ThreadedOutput>(
                [path = name.place](bool on) { return outputs::writeState(path, on); });
        case OutputKind::Mqtt:
            return std::make_unique<outputs::BrokerOutput>(ownBroker(m_profile->mqtt), name.place, m_clock);
        case OutputKind::Command:
            return std::make_unique<outputs::CommandOutput>(name.place, name.arguments);
        case OutputKind::Dtr:
            return lineOutput(name.place, outputs::Line::Dtr);
        case OutputKind::Rts:
            return lineOutput(name.place, outputs::Line::Rts);
        case OutputKind::None:
            break;
    }
    return nullptr;
}

void StationTransmit::open()
{
    m_open = true;
    begin();
}

void StationTransmit::close()
{
    m_open = false;
    retire();
}

void StationTransmit::begin()
{
    if (!m_open || m_output || m_former) {
        return;
    }
    m_output = m_make(contacts::parseOutput(m_profile->transmit.output).value_or(contacts::OutputName{}));
    if (m_output) {
        connect(m_output.get(), &outputs::Output::reached, this, &StationTransmit::reached);
        connect(m_output.get(), &outputs::Output::failed, this, &StationTransmit::fail);
        order(false);
    }
}

// Switches the output off and keeps it until it is off. The next output may need the same port or file, so it begins
// after that. Nothing waits here: a signal of the output reports its end.
void StationTransmit::retire()
{
    if (m_output) {
        m_former = std::move(m_output);
        m_former->disconnect(this);
        const auto letGo = [this, former = m_former.get()] {
            if (m_former.get() == former && former->isIdle()) {
                m_former.reset();
                begin();
            }
        };
        connect(m_former.get(), &outputs::Output::reached, this, letGo, Qt::QueuedConnection);
        connect(m_former.get(), &outputs::Output::failed, this, letGo, Qt::QueuedConnection);
        m_former->set(false);
    }
    settleAnew();
    m_switching = {};
    m_alarms.clear(alarmEntry("transmit.output-failed"));
}

void StationTransmit::settleAnew()
{
    m_gate = {};
    m_decision = {};
}

// The output goes off, because a change of the profile may have moved the target, the beam or the beam width.
void StationTransmit::profileChanged(const profile::Profile& before, const profile::Profile& after)
{
    const auto name = contacts::parseOutput(after.transmit.output);
    const bool isByBroker = name && name->kind == OutputKind::Mqtt;
    if (before.transmit.output != after.transmit.output || (isByBroker && before.mqtt != after.mqtt)) {
        retire();
        begin();
    } else if (m_output) {
        settleAnew();
        order(false);
    }
}

transmit::GateInput StationTransmit::inputOf(const StationStatus& status) const
{
    const bool isHeld = m_simulated && m_profile->transmit.inSimulation == profile::InSimulation::Off;
    const bool live = isLive(status.azimuth) && isLive(status.elevation);
    return {.obstacle = isHeld ? Obstacle::Simulated : obstacleOf(status),
            .beam = live ? status.actual : std::nullopt,
            .target = status.target,
            .within = m_within};
}

void StationTransmit::tick(const StationStatus& status)
{
    if (!m_output) {
        return;
    }
    const SteadyTime now = m_clock.now();
    const bool before = m_decision.on();
    m_within = antennaOf(status).beamWidth * m_profile->transmit.beamFraction;
    m_decision = m_gate.decide(inputOf(status), now);
    if (m_decision.on() != before) {
        show(m_decision.on());
    }
    const bool staysOff = m_switching.failedOn && now - *m_switching.failedOn < kStaysOff;
    order(m_decision.on() && !staysOff);
    if (m_switching.unanswered && now - *m_switching.unanswered >= kPatience) {
        fail(Text::tr("no answer for %1 s").arg(kPatience.count()));
    }
}

void StationTransmit::order(bool on)
{
    const SteadyTime now = m_clock.now();
    const bool isDue = !m_switching.orderedAt || now - *m_switching.orderedAt >= kRepeat;
    if (on == m_switching.ordered && !isDue) {
        return;
    }
    m_switching.ordered = on;
    m_switching.orderedAt = now;
    m_switching.unanswered = m_switching.unanswered.value_or(now);
    m_output->set(on);
}

// A failure is over when the output is as decided: on again, or off and not needed.
void StationTransmit::reached(bool on)
{
    m_switching.isOn = on;
    m_switching.unanswered.reset();
    if (on == m_decision.on()) {
        m_switching.failedOn.reset();
        m_switching.problem.clear();
        m_alarms.clear(alarmEntry("transmit.output-failed"));
    }
}

void StationTransmit::fail(const QString& reason)
{
    m_switching.isOn = false;
    m_switching.unanswered.reset();
    if (m_switching.ordered) {
        m_switching.failedOn = m_clock.now();
    }
    m_switching.problem = reason;
    m_alarms.raise(alarmEntry("transmit.output-failed"), {toQString(m_profile->transmit.output), reason});
}

void StationTransmit::show(bool on)
{
    m_lines.add(Severity::Advisory, kTransmitSource,
                on ? Text::tr("on: the beam is %1 from the target").arg(degreesText(*m_decision.error, 2))
                   : Text::tr("off: %1").arg(whyOff(m_decision, m_within)));
}

TransmitStatus StationTransmit::status() const
{
    if (!m_output) {
        return m_former && m_open ? TransmitStatus{.output = toQString(m_profile->transmit.output),
                                                   .whyOff = Text::tr("The previous output has not answered yet.")}
                                  : TransmitStatus{};
    }
    return {.output = toQString(m_profile->transmit.output),
            .on = m_switching.isOn,
            .whyOff = whyOff(m_decision, m_within),
            .problem = m_switching.problem,
            .within = m_within,
            .error = m_decision.error};
}

}  // namespace boresight

#include "moc_station_transmit.cpp"
