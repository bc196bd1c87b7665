// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/axis_readout.h"

#include "ui/axes.h"
#include "ui/format.h"
#include "ui/value_label.h"
#include "ui/widest.h"

#include <QGridLayout>
#include <QHelpEvent>
#include <QLabel>
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
QString driveHelp(const QString& axisName, const AxisStatus& axis, bool turnKnown)
{
    QString text =
        AxisReadout::tr("%1 axis, %2 … %3").arg(axisName, angleText(axis.travel.min, 1), angleText(axis.travel.max, 1));
    if (axis.actual && turnKnown) {
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
    text += AxisReadout::tr("\nmoteus mode %1, fault %2").arg(axis.mode).arg(axis.faultCode);
    return axis.stateText.isEmpty() ? text : text + QLatin1Char('\n') + axis.stateText;
}

QLabel* heading(const QString& text, QWidget* parent)
{
    auto* const label = new QLabel(text, parent);
    label->setFont(fonts::label());
    return label;
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
        grid->addWidget(heading(text, this), 0, column++, Qt::AlignRight);
    }
    grid->addWidget(heading(tr("STATE"), this), 0, 4);
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
    m_turnKnown = {isTurnKnown(status, Axis::Azimuth), isTurnKnown(status, Axis::Elevation)};
    m_trim = status.trim;
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
    const bool known = axis.actual && age != Freshness::NoData && turnKnown;
    const Tone tone = age == Freshness::Live ? Tone::Normal : Tone::Secondary;
    row.actual->setValue(known ? angleText(shown(*axis.actual)) : noValue(), known ? tone : Tone::Secondary);
    row.target->setValue(axis.target ? angleText(shown(*axis.target)) : noValue(),
                         axis.target ? Tone::Normal : Tone::Secondary);
    const bool comparable = known && axis.target;
    row.error->setValue(comparable ? signedAngleText(*axis.target - *axis.actual) : noValue(),
                        comparable ? tone : Tone::Secondary);
    const Worded state = worded(axis, turnKnown || turnAwaited);
    row.state->setValue(state.word, state.tone, state.symbol);
    const Angle trim = !m_trim ? 0_deg : which == Axis::Azimuth ? m_trim->azimuth : m_trim->elevation;
    const QString detail = detailText(axis, turnKnown);
    const Tone detailTone = age == Freshness::Live ? Tone::Secondary : Tone::Warning;
    if (trim == 0_deg) {
        row.detail->setValue(detail, detailTone);
    } else {
        const QString text = tr("trim %1").arg(signedAngleText(trim));
        row.detail->setValue(detail.isEmpty() ? text : tr("%1, %2").arg(text, detail),
                             age == Freshness::Live ? Tone::Accent : Tone::Warning);
    }
}

bool AxisReadout::event(QEvent* event)
{
    if (event->type() == QEvent::ToolTip) {
        const auto* const help = static_cast<QHelpEvent*>(event);
        const bool lower = help->pos().y() > m_rows[0].detail->geometry().bottom();
        const Axis axis = lower ? Axis::Elevation : Axis::Azimuth;
        const std::size_t i = axisIndex(axis);
        QToolTip::showText(help->globalPos(), driveHelp(name(axis), m_shown[i], m_turnKnown[i]), this);
        return true;
    }
    return QWidget::event(event);
}

}  // namespace boresight::ui
