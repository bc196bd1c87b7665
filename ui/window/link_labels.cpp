// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/link_labels.h"

#include "ui/kit/axes.h"
#include "ui/kit/format.h"
#include "ui/kit/value_label.h"
#include "ui/kit/widest.h"
#include "ui/link/end_switch_words.h"
#include "ui/window/motor_words.h"

#include <QStringList>

#include <algorithm>

namespace boresight::ui {

namespace {

struct Shown
{
    QString text;
    Tone tone = Tone::Secondary;
    Symbol symbol = Symbol::Healthy;
};

Shown lineShown(const StationStatus& status)
{
    const QString& kind = status.line.kind;
    if (kind.isEmpty()) {
        return {QString(), Tone::Secondary, Symbol::None};
    }
    if (drivesOf(status).released) {
        return {LinkLabels::tr("%1 off").arg(kind), Tone::Advisory, Symbol::Advisory};
    }
    switch (status.line.state) {
        case MountLine::State::Up:
            return {kind};
        case MountLine::State::Down:
            return {LinkLabels::tr("%1 down").arg(kind), Tone::Alarm, Symbol::Alarm};
        case MountLine::State::Lost:
            return {LinkLabels::tr("%1 lost").arg(kind), Tone::Alarm, Symbol::Alarm};
        case MountLine::State::Closed:
            break;
    }
    return {LinkLabels::tr("%1 off").arg(kind), Tone::Warning, Symbol::Warning};
}

// Whether an end switch of this axis is pressed.
bool isAtEnd(const StationStatus& status, Axis axis)
{
    return std::ranges::any_of(status.endSwitches, [axis](const EndSwitchStatus& one) {
        return one.which.axis == axis && one.state == end_switches::SwitchState::Pressed;
    });
}

Shown driveShown(const QString& name, const AxisStatus& axis, bool released, bool atEnd)
{
    const bool missing = axis.state == AxisState::Missing;
    if (missing || (freshness(axis.age) == Freshness::NoData && released)) {
        return {name, Tone::Secondary, Symbol::Lost};
    }
    if (freshness(axis.age) == Freshness::NoData) {
        return {LinkLabels::tr("%1 silent").arg(name), Tone::Alarm, Symbol::Alarm};
    }
    if (axis.state == AxisState::Fault) {
        return {LinkLabels::tr("%1 fault").arg(name), Tone::Alarm, Symbol::Alarm};
    }
    if (atEnd) {
        return {LinkLabels::tr("%1 switch").arg(name), Tone::Warning, Symbol::Warning};
    }
    if (freshness(axis.age) == Freshness::Late) {
        return {LinkLabels::tr("%1 late").arg(name), Tone::Warning, Symbol::Warning};
    }
    return {name};
}

// Empty without a sensor: then the label takes no room.
Shown sensorShown(const SensorStatus& sensor)
{
    if (!sensor.configured()) {
        return {QString(), Tone::Secondary, Symbol::None};
    }
    if (sensor.dead || sensor.presence == orientation::Presence::Lost) {
        return {LinkLabels::tr("Sensor lost"), Tone::Warning, Symbol::Warning};
    }
    if (sensor.disagrees) {
        return {LinkLabels::tr("Sensor differs"), Tone::Warning, Symbol::Warning};
    }
    if (sensor.presence == orientation::Presence::Late) {
        return {LinkLabels::tr("Sensor late"), Tone::Warning, Symbol::Warning};
    }
    // The broker or the port does not answer. The readout, if there is room for it, and the alarm give the reason.
    if (sensor.presence == orientation::Presence::Awaited && !sensor.problem.isEmpty()) {
        return {LinkLabels::tr("Sensor silent"), Tone::Warning, Symbol::Warning};
    }
    return sensor.presence == orientation::Presence::Awaited
               ? Shown{LinkLabels::tr("Sensor awaited"), Tone::Secondary, Symbol::Lost}
               : Shown{LinkLabels::tr("Sensor")};
}

QString sensorHelp(const SensorStatus& sensor)
{
    QString text = LinkLabels::tr("%1: %2 values, %3 refused, %4 outliers")
                       .arg(sensor.source)
                       .arg(sensor.counts.accepted)
                       .arg(sensor.counts.allRefused())
                       .arg(sensor.outliers);
    for (const QString& more : {sensor.problem, sensor.doubt}) {
        text += more.isEmpty() ? QString() : QLatin1Char('\n') + more;
    }
    return text;
}

// Empty without an output: then the label takes no room.
Shown transmitShown(const TransmitStatus& transmit)
{
    if (transmit.output.isEmpty()) {
        return {QString(), Tone::Secondary, Symbol::None};
    }
    if (!transmit.problem.isEmpty()) {
        return {LinkLabels::tr("TX output failed"), Tone::Warning, Symbol::Warning};
    }
    return transmit.on ? Shown{LinkLabels::tr("TX on"), Tone::Normal}
                       : Shown{LinkLabels::tr("TX off"), Tone::Secondary, Symbol::Lost};
}

QString transmitHelp(const TransmitStatus& transmit)
{
    QString text = LinkLabels::tr("The output %1 is on only while the beam is less than %2 from the target.")
                       .arg(transmit.output, angleText(transmit.within));
    for (const QString& more : {transmit.problem, transmit.whyOff}) {
        text += more.isEmpty() ? QString() : QLatin1Char('\n') + more;
    }
    return text;
}

// Empty without a brake: then the label takes no room.
Shown brakeShown(const BrakeStatus& brake)
{
    if (brake.output.isEmpty()) {
        return {QString(), Tone::Secondary, Symbol::None};
    }
    if (!brake.problem.isEmpty()) {
        return {LinkLabels::tr("Brake failed"), Tone::Alarm, Symbol::Alarm};
    }
    switch (brake.state) {
        case brake::BrakeState::Set:
            return {LinkLabels::tr("Brake set"), Tone::Secondary};
        case brake::BrakeState::Releasing:
            return {LinkLabels::tr("Brake opens"), Tone::Normal};
        case brake::BrakeState::Released:
            return {LinkLabels::tr("Brake open"), Tone::Normal};
        case brake::BrakeState::Setting:
            break;
    }
    return {LinkLabels::tr("Brake closes"), Tone::Secondary};
}

QString brakeHelp(const BrakeStatus& brake)
{
    const QString text =
        LinkLabels::tr("The output %1 is on while the brake is open. Nothing moves before the brake is open.")
            .arg(brake.output);
    return brake.problem.isEmpty() ? text : brake.problem + QLatin1Char('\n') + text;
}

// What is shown of an axis under the pointer, and each of its end switches.
QString driveHelp(const StationStatus& status, Axis axis)
{
    const bool isAzimuth = axis == Axis::Azimuth;
    QStringList lines{
        axisHelp(isAzimuth ? status.azimuth : status.elevation, status.capabilities.axes[isAzimuth ? 0 : 1])};
    for (const EndSwitchStatus& one : status.endSwitches) {
        if (one.which.axis == axis) {
            lines << endSwitchLine(one);
        }
    }
    lines.removeAll(QString());
    return lines.join(QLatin1Char('\n'));
}

QString lineHelp(const StationStatus& status)
{
    const MountLine& line = status.line;
    const QString text = LinkLabels::tr("%1: %2 frames sent, %3 received, %4 dropped, %5 bus errors")
                             .arg(line.name)
                             .arg(line.sent)
                             .arg(line.received)
                             .arg(line.dropped)
                             .arg(line.errors);
    QStringList lines{line.problem, line.condition, text};
    lines.removeAll(QString());
    return lines.join(QLatin1Char('\n'));
}

QString widestMountLine(const QString& kind)
{
    return kind.isEmpty()
               ? QString()
               : widest(fonts::label(), {LinkLabels::tr("%1 off").arg(kind), LinkLabels::tr("%1 down").arg(kind),
                                         LinkLabels::tr("%1 lost").arg(kind)});
}

QString widestDrive(const QString& name)
{
    return widest(fonts::label(), {LinkLabels::tr("%1 silent").arg(name), LinkLabels::tr("%1 fault").arg(name),
                                   LinkLabels::tr("%1 late").arg(name), LinkLabels::tr("%1 switch").arg(name)});
}

void setShown(ValueLabel& label, const Shown& shown)
{
    label.setValue(shown.text, shown.tone, shown.symbol);
}

}  // namespace

LinkLabels::LinkLabels(QWidget* header)
    : m_line(new ValueLabel(tr("Line to the mount"), fonts::label(), {}, header)),
      m_azimuth(new ValueLabel(tr("Azimuth drive"), fonts::label(), widestDrive(tr("AZ")), header)),
      m_elevation(new ValueLabel(tr("Elevation drive"), fonts::label(), widestDrive(tr("EL")), header)),
      m_sensor(new ValueLabel(tr("Orientation sensor"), fonts::label(), tr("Sensor awaited"), header)),
      m_transmit(new ValueLabel(tr("Transmit output"), fonts::label(), tr("TX off"), header)),
      m_brake(new ValueLabel(tr("Brake"), fonts::label(), tr("Brake closes"), header))
{
    for (ValueLabel* const link : {m_line, m_azimuth, m_elevation, m_sensor, m_transmit, m_brake}) {
        link->setSymbolRoom(true);
    }
    for (ValueLabel* const mayBeMissing : {m_line, m_sensor, m_transmit, m_brake}) {
        mayBeMissing->setCollapsing(true);
    }
}

std::array<QWidget*, 3> LinkLabels::ofTheMount() const
{
    return {m_line, m_azimuth, m_elevation};
}

std::array<QWidget*, 3> LinkLabels::besideTheTarget() const
{
    return {m_brake, m_transmit, m_sensor};
}

void LinkLabels::showStatus(const StationStatus& status)
{
    m_line->setWidest(widestMountLine(status.line.kind));
    setShown(*m_line, lineShown(status));
    m_line->setToolTip(status.line.kind.isEmpty() ? QString() : lineHelp(status));
    const bool released = drivesOf(status).released;
    setShown(*m_azimuth,
             driveShown(shortName(Axis::Azimuth, status), status.azimuth, released, isAtEnd(status, Axis::Azimuth)));
    m_azimuth->setToolTip(driveHelp(status, Axis::Azimuth));
    setShown(*m_elevation, driveShown(shortName(Axis::Elevation, status), status.elevation, released,
                                      isAtEnd(status, Axis::Elevation)));
    m_elevation->setToolTip(driveHelp(status, Axis::Elevation));
    setShown(*m_sensor, sensorShown(status.sensor));
    m_sensor->setToolTip(status.sensor.configured() ? sensorHelp(status.sensor) : QString());
    setShown(*m_transmit, transmitShown(status.transmit));
    m_transmit->setToolTip(status.transmit.output.isEmpty() ? QString() : transmitHelp(status.transmit));
    setShown(*m_brake, brakeShown(status.brake));
    m_brake->setToolTip(status.brake.output.isEmpty() ? QString() : brakeHelp(status.brake));
}

}  // namespace boresight::ui
