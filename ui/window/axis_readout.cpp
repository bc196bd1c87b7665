// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/axis_readout.h"

#include "ui/kit/axes.h"
#include "ui/kit/caption.h"
#include "ui/kit/format.h"
#include "ui/kit/value_label.h"
#include "ui/kit/widest.h"

#include <QGridLayout>
#include <QHelpEvent>
#include <QStringList>
#include <QToolTip>

#include <cmath>

namespace boresight::ui {

namespace {

struct Worded
{
    QString word;
    Tone tone = Tone::Normal;
    Symbol symbol = Symbol::None;
};

// On an unknown turn the word says so, unless there is something worse, or the axis moves.
Worded worded(const AxisStatus& axis, bool turnKnown)
{
    const AxisState state = freshness(axis.age) == Freshness::NoData ? AxisState::NoData : axis.state;
    switch (state) {
        case AxisState::NoData:
        case AxisState::Fault:
            return {word(state), Tone::Alarm, Symbol::Alarm};
        case AxisState::Moving:
            return {word(state)};
        default:
            break;
    }
    if (!turnKnown) {
        return {AxisReadout::tr("TURN?"), Tone::Warning, Symbol::Warning};
    }
    return state == AxisState::Limit ? Worded{word(state), Tone::Warning, Symbol::Warning} : Worded{word(state)};
}

// Late data names its age, whatever else there is to say.
QString detailText(const AxisStatus& axis, bool turnKnown)
{
    if (freshness(axis.age) != Freshness::Live && axis.age) {
        return AxisReadout::tr("age %1").arg(ageText(*axis.age));
    }
    return turnKnown || !axis.age || !axis.stateText.isEmpty() ? axis.stateText
                                                               : AxisReadout::tr("the turn is not known");
}

QString line(const QString& what, const std::optional<double>& value, const char* format)
{
    return value ? QLatin1Char('\n') + what + QString::asprintf(format, *value) : QString();
}

// What the drive says of itself: volts, degrees, amperes.
QString driveHelp(const QString& axisName, const AxisStatus& axis, const QString& registers)
{
    QString text =
        AxisReadout::tr("%1 axis, %2 … %3").arg(axisName, angleText(axis.travel.min, 1), angleText(axis.travel.max, 1));
    if (axis.actual && axis.turnKnown) {
        text += AxisReadout::tr("\nmechanical angle %1").arg(angleText(*axis.actual));
    }
    if (axis.rate) {
        text += AxisReadout::tr("\nrate %1").arg(rateText(*axis.rate));
    }
    text += line(AxisReadout::tr("supply "), axis.busVoltage, "%.1f V");
    text += line(AxisReadout::tr("drive "), axis.boardTemperature, "%.0f °C");
    text += line(AxisReadout::tr("motor "), axis.motorTemperature, "%.0f °C");
    text += line(AxisReadout::tr("torque "), axis.torque, "%.2f Nm");
    text += line(AxisReadout::tr("current "), axis.current, "%.1f A");
    for (const QString& more : {registers, axis.stateText}) {
        text += more.isEmpty() ? QString() : QLatin1Char('\n') + more;
    }
    return text;
}

Angle trimOf(const std::optional<SkyPointing>& trim, Axis which)
{
    return !trim ? 0_deg : which == Axis::Azimuth ? trim->azimuth : trim->elevation;
}

QString widestState()
{
    return widest(fonts::text(), {widestAxisState(fonts::text()), AxisReadout::tr("TURN?")});
}

}  // namespace

AxisReadout::AxisReadout(QWidget* parent) : QWidget(parent)
{
    auto* const grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(0);
    int column = 1;
    for (const QString& text : {tr("ACTUAL"), tr("TARGET"), tr("ERROR")}) {
        grid->addWidget(makeCaption(text, this), 0, column++, Qt::AlignRight);
    }
    grid->addWidget(makeCaption(tr("STATE"), this), 0, 4);
    for (const Axis axis : {Axis::Azimuth, Axis::Elevation}) {
        const int top = axis == Axis::Azimuth ? 1 : 3;  // numbers, below them a line for the detail
        auto* const name = new QLabel(axis == Axis::Azimuth ? tr("AZ") : tr("EL"), this);
        name->setFont(fonts::text());
        const Row row = makeRow(axis);
        grid->addWidget(name, top, 0);
        grid->addWidget(row.actual, top, 1);
        grid->addWidget(row.target, top, 2);
        grid->addWidget(row.error, top, 3);
        grid->addWidget(row.state, top, 4);
        grid->addWidget(row.detail, top + 1, 1, 1, 4);
        m_rows[axis == Axis::Azimuth ? 0 : 1] = row;
    }
    grid->setColumnStretch(4, 1);
}

AxisReadout::Row AxisReadout::makeRow(Axis axis)
{
    const QString axisName = name(axis);
    const QString widest = QStringLiteral("-000.00°");
    Row row{.actual = new ValueLabel(tr("Actual %1").arg(axisName), fonts::actual(), QStringLiteral("000.00°"), this),
            .target = new ValueLabel(tr("Target %1").arg(axisName), fonts::value(), QStringLiteral("000.00°"), this),
            .error = new ValueLabel(tr("Error of %1").arg(axisName), fonts::value(), widest, this),
            .state = new ValueLabel(tr("State of %1").arg(axisName), fonts::text(), widestState(), this),
            .detail = new ValueLabel(tr("Detail of %1").arg(axisName), fonts::label(), {}, this)};
    for (ValueLabel* const number : {row.actual, row.target, row.error}) {
        number->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    }
    row.state->setSymbolRoom(true);
    row.detail->setStretching(true);
    row.detail->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    return row;
}

void AxisReadout::showStatus(const StationStatus& status)
{
    m_shown = {status.azimuth, status.elevation};
    m_registers = {driveOf(status, Axis::Azimuth).registers, driveOf(status, Axis::Elevation).registers};
    m_trim = status.trim;
    m_hasModel = status.profile->pointing != pointing::PointingTerms{};
    for (const Axis axis : kAxes) {
        showRow(axis, isTurnKnown(status, axis), isTurnAwaited(status, axis));
    }
}

void AxisReadout::showRow(Axis which, bool turnKnown, bool turnAwaited)
{
    const Row& row = m_rows[axisIndex(which)];
    const AxisStatus& axis = m_shown[axisIndex(which)];
    const auto shown = [which](Angle angle) { return which == Axis::Azimuth ? angle.wrapped360() : angle; };
    const Freshness age = freshness(axis.age);
    // On an unknown turn the drive counts from anywhere: no number at all.
    const bool missing = axis.state == AxisState::Missing;
    const bool known = axis.actual && age != Freshness::NoData && turnKnown && !missing;
    const Tone tone = age == Freshness::Live ? Tone::Normal : Tone::Secondary;
    const auto actual = known ? axis.beam.actual : std::nullopt;
    const auto target = missing ? std::nullopt : axis.beam.target;
    row.actual->setValue(actual ? angleText(shown(*actual)) : noValue(), actual ? tone : Tone::Secondary);
    row.target->setValue(target ? angleText(shown(*target)) : noValue(), target ? Tone::Normal : Tone::Secondary);
    const bool comparable = known && axis.target;
    row.error->setValue(comparable ? signedAngleText(*axis.target - *axis.actual) : noValue(),
                        comparable ? tone : Tone::Secondary);
    const Worded state = worded(axis, turnKnown || turnAwaited);
    row.state->setValue(state.word, state.tone, state.symbol);
    const bool live = age == Freshness::Live;
    const bool trimmed = trimOf(m_trim, which) != 0_deg;
    row.detail->setValue(detail(which), !live ? Tone::Warning : trimmed ? Tone::Accent : Tone::Secondary);
}

QString AxisReadout::detail(Axis which) const
{
    const AxisStatus& axis = m_shown[axisIndex(which)];
    const bool turnKnown = axis.turnKnown;
    QStringList parts;
    if (const Angle trim = trimOf(m_trim, which); trim != 0_deg) {
        parts << tr("trim %1").arg(signedAngleText(trim));
    }
    if (axis.actual && turnKnown && m_hasModel && freshness(axis.age) != Freshness::NoData) {
        parts << tr("axis %1").arg(angleText(*axis.actual));
    }
    if (const QString text = detailText(axis, turnKnown); !text.isEmpty()) {
        parts << text;
    }
    return parts.join(QStringLiteral(", "));
}

bool AxisReadout::event(QEvent* event)
{
    if (event->type() == QEvent::ToolTip) {
        const auto* const help = static_cast<QHelpEvent*>(event);
        const bool lower = help->pos().y() > m_rows[0].detail->geometry().bottom();
        const Axis axis = lower ? Axis::Elevation : Axis::Azimuth;
        const std::size_t i = axisIndex(axis);
        QToolTip::showText(help->globalPos(), driveHelp(name(axis), m_shown[i], m_registers[i]), this);
        return true;
    }
    return QWidget::event(event);
}

}  // namespace boresight::ui

#include "moc_axis_readout.cpp"
