// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/station_transmit.h"

#include "core/alarms/catalogue.h"
#include "core/base/text.h"
#include "core/units/degrees_text.h"

namespace boresight {
namespace {

using transmit::Obstacle;

const QString kTransmitSource = QStringLiteral("transmit");
constexpr int kTransmitLinesPerSecond = 2;

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
      m_output(
          profile, [](const profile::Profile& named) -> const std::string& { return named.transmit.output; },
          QStringLiteral("transmit"), clock, this)
{
    connect(&m_output, &outputs::NamedOutput::reached, this, &StationTransmit::reached);
    connect(&m_output, &outputs::NamedOutput::failed, this, &StationTransmit::fail);
}

StationTransmit::~StationTransmit()
{
    close();
}

void StationTransmit::open()
{
    m_output.open();
}

void StationTransmit::close()
{
    m_output.close();
    forget();
}

void StationTransmit::forget()
{
    settleAnew();
    m_failedOn.reset();
    m_problem.clear();
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
    if (m_output.differs(before, after)) {
        forget();
        m_output.reopen();
    } else if (m_output.isThere()) {
        settleAnew();
        m_output.order(false);
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
    if (!m_output.isThere()) {
        return;
    }
    const SteadyTime now = m_clock.now();
    const bool before = m_decision.on();
    m_within = antennaOf(status).beamWidth * m_profile->transmit.beamFraction;
    m_decision = m_gate.decide(inputOf(status), now);
    if (m_decision.on() != before) {
        show(m_decision.on());
    }
    const bool staysOff = m_failedOn && now - *m_failedOn < kStaysOff;
    m_output.order(m_decision.on() && !staysOff);
}

// A failure is over when the output is as decided: on again, or off and not needed.
void StationTransmit::reached(bool on)
{
    if (on == m_decision.on()) {
        m_failedOn.reset();
        m_problem.clear();
        m_alarms.clear(alarmEntry("transmit.output-failed"));
    }
}

void StationTransmit::fail(const QString& reason)
{
    if (m_output.ordered()) {
        m_failedOn = m_clock.now();
    }
    m_problem = reason;
    m_alarms.raise(alarmEntry("transmit.output-failed"), {m_output.name(), reason});
}

void StationTransmit::show(bool on)
{
    m_lines.add(Severity::Advisory, kTransmitSource,
                on ? Text::tr("on: the beam is %1 from the target").arg(degreesText(*m_decision.error, 2))
                   : Text::tr("off: %1").arg(whyOff(m_decision, m_within)));
}

TransmitStatus StationTransmit::status() const
{
    if (!m_output.isThere()) {
        return m_output.isAwaited() ? TransmitStatus{.output = m_output.name(),
                                                     .whyOff = Text::tr("The previous output has not answered yet.")}
                                    : TransmitStatus{};
    }
    return {.output = m_output.name(),
            .on = m_output.isOn(),
            .whyOff = whyOff(m_decision, m_within),
            .problem = m_problem,
            .within = m_within,
            .error = m_decision.error};
}

}  // namespace boresight

#include "moc_station_transmit.cpp"
