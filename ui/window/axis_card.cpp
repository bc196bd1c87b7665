// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/axis_card.h"

#include "ui/kit/axes.h"
#include "ui/kit/caption.h"
#include "ui/kit/format.h"
#include "ui/kit/value_label.h"
#include "ui/kit/widest.h"
#include "ui/look/paint.h"
#include "ui/window/error_bar.h"

#include <QGridLayout>
#include <QHelpEvent>
#include <QLabel>
#include <QPainter>
#include <QStringList>
#include <QToolTip>
#include <QVBoxLayout>

#include <cmath>

namespace boresight::ui {

namespace {

constexpr int kCardSides = 12;    // px
constexpr int kNarrowSides = 4;   // px, when two cards are side by side
constexpr int kCardEnds = 3;      // px
constexpr int kAroundDigits = 6;  // px, above and below
constexpr double kTurn = 360.0;   // degrees

struct Worded
{
    QString word;
    Tone tone = Tone::Normal;
    Symbol symbol = Symbol::None;
};

// While the wrap is unknown the word says so, unless there is something worse, or the axis moves.
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
        return {AxisCard::tr("WRAP?"), Tone::Warning, Symbol::Warning};
    }
    return state == AxisState::Limit ? Worded{word(state), Tone::Warning, Symbol::Warning} : Worded{word(state)};
}

// Late data shows its age, whatever else there is to report.
QString detailText(const AxisStatus& axis, bool turnKnown)
{
    if (freshness(axis.age) != Freshness::Live && axis.age) {
        return AxisCard::tr("age %1").arg(ageText(*axis.age));
    }
    return turnKnown || !axis.age || !axis.stateText.isEmpty() ? axis.stateText
                                                               : AxisCard::tr("the cable wrap is unknown");
}

QString line(const QString& what, const std::optional<double>& value, const char* format)
{
    return value ? QLatin1Char('\n') + what + QString::asprintf(format, *value) : QString();
}

// What the drive reports: voltage, temperature, current.
QString driveHelp(const QString& axisName, const AxisStatus& axis, const QString& registers)
{
    QString text =
        AxisCard::tr("%1 axis, %2 … %3").arg(axisName, angleText(axis.travel.min, 1), angleText(axis.travel.max, 1));
    if (axis.actual && axis.turnKnown) {
        text += AxisCard::tr("\nmechanical angle %1").arg(angleText(*axis.actual));
    }
    if (axis.rate) {
        text += AxisCard::tr("\nrate %1").arg(rateText(*axis.rate));
    }
    text += line(AxisCard::tr("supply "), axis.busVoltage, "%.1f V");
    text += line(AxisCard::tr("drive "), axis.boardTemperature, "%.0f °C");
    text += line(AxisCard::tr("motor "), axis.motorTemperature, "%.0f °C");
    text += line(AxisCard::tr("torque "), axis.torque, "%.2f Nm");
    text += line(AxisCard::tr("current "), axis.current, "%.1f A");
    for (const QString& more : {registers, axis.stateText}) {
        text += more.isEmpty() ? QString() : QLatin1Char('\n') + more;
    }
    return text;
}

QWidget* makeName(const QString& text, QWidget* parent)
{
    auto* const label = new QLabel(text, parent);
    QFont bold = fonts::text();
    bold.setBold(true);
    label->setFont(bold);
    label->setIndent(2);  // as the state below
    return label;
}

QLayout* stacked(std::initializer_list<QWidget*> parts)
{
    auto* const column = new QVBoxLayout;
    for (QWidget* const part : parts) {
        column->addWidget(part);
    }
    column->addStretch(1);
    return column;
}

// The last part is wider by this stretch. 0: as wide as it needs.
QLayout* inRow(std::initializer_list<QWidget*> parts, int stretchOfLast, int spacing)
{
    auto* const row = new QHBoxLayout;
    row->setSpacing(spacing);
    for (QWidget* const part : parts) {
        row->addWidget(part, stretchOfLast == 0 ? 0 : 1);
    }
    row->setStretch(row->count() - 1, stretchOfLast);
    return row;
}

int pointsOf(Numerals numerals)
{
    switch (numerals) {
        case Numerals::Bare:
            return 17;
        case Numerals::Beside:
            return 22;
        case Numerals::Small:
            return 28;
        case Numerals::Row:
        case Numerals::Usual:
            return 44;
        case Numerals::Large:
            break;
    }
    return 60;
}

// The expected angle of the axis. On the way to a fixed target, and while it waits, this is the set-point: the rest of
// the way is planned.
std::optional<Angle> expectedAngle(const StationStatus& status, const BeamAngles& beam)
{
    const bool isPlanned = status.slew || !status.route.empty() || status.state == StationState::Hold;
    return isPlanned ? beam.commanded : beam.target;
}

Angle steady(SteadyNumber& number, Angle measured)
{
    return Angle::fromDegrees(number.shown(measured.degrees()));
}

QString widestState(const QFont& font)
{
    return widest(font, {widestAxisState(font), AxisCard::tr("WRAP?")});
}

}  // namespace

AxisCard::AxisCard(Axis axis, QWidget* parent)
    : QWidget(parent), m_axis(axis), m_steadyActual(2, axis == Axis::Azimuth ? kTurn : 0.0)
{
    const QString axisName = name(axis);
    const QString widest = QStringLiteral("-000.00°");
    m_actual = new ValueLabel(tr("Actual %1").arg(axisName), {}, QStringLiteral("000.00°"), this);
    m_target = new ValueLabel(tr("Target %1").arg(axisName), fonts::value(), widest, this);
    m_error = new ValueLabel(tr("Error of %1").arg(axisName), fonts::value(), widest, this);
    m_rate = new ValueLabel(tr("Rate of %1").arg(axisName), fonts::value(), QStringLiteral("-00.0°/s"), this);
    m_name = makeName(m_axis == Axis::Azimuth ? tr("AZ") : tr("EL"), this);
    m_targetCaption = makeCaption(tr("target"), this);
    m_errorCaption = makeCaption(tr("error"), this);
    m_rateCaption = makeCaption(tr("rate"), this);
    m_state = new ValueLabel(tr("State of %1").arg(axisName), fonts::text(), widestState(fonts::text()), this);
    m_bar = new ErrorBar(tr("Error bar of %1").arg(axisName), this);
    m_detail = new ValueLabel(tr("Detail of %1").arg(axisName), fonts::label(), {}, this);
    for (ValueLabel* const number : {m_actual, m_target, m_error, m_rate}) {
        number->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    }
    m_state->setSymbolRoom(true);
    m_detail->setStretching(true);
    m_detail->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    setNumerals(Numerals::Small);
}

// The name with the state below it, the number, and beside it a line for each further value. In the narrow cards the
// lines of target and error are one line, below the number.
void AxisCard::build(Numerals numerals)
{
    delete layout();
    auto* const grid = new QGridLayout(this);
    const int sides = areBeside(numerals) ? kNarrowSides : kCardSides;
    grid->setContentsMargins(sides, kCardEnds, sides, kCardEnds);
    grid->setHorizontalSpacing(areBeside(numerals) ? kGrid / 2 : kGrid);
    grid->setVerticalSpacing(0);
    if (numerals == Numerals::Row) {
        buildRow(*grid);
    } else if (areBeside(numerals)) {
        buildBeside(*grid, numerals);
    } else {
        grid->addLayout(stacked({m_name, m_state}), 0, 0, 3, 1);
        grid->addWidget(m_actual, 0, 1, 3, 1, Qt::AlignRight | Qt::AlignVCenter);
        grid->addWidget(m_targetCaption, 0, 2);
        grid->addWidget(m_target, 0, 3);
        grid->addWidget(m_errorCaption, 1, 2);
        grid->addWidget(m_error, 1, 3);
        grid->addWidget(m_rateCaption, 2, 2);
        grid->addWidget(m_rate, 2, 3);
        grid->addLayout(inRow({m_bar, m_detail}, 1, kGrid), 3, 0, 1, 4);
    }
    grid->setColumnStretch(1, 1);
}

// The bare card shows the age of late data in the place of the error.
void AxisCard::buildBeside(QGridLayout& grid, Numerals numerals)
{
    const bool bare = numerals == Numerals::Bare;
    auto* const line = new QHBoxLayout;
    for (QWidget* const part :
         {m_targetCaption, static_cast<QWidget*>(m_target), m_errorCaption, static_cast<QWidget*>(m_error)}) {
        line->addWidget(part);
    }
    line->insertStretch(2, 1);
    grid.addLayout(bare ? inRow({m_name, m_state}, 0, kGrid / 2) : stacked({m_name, m_state}), 0, 0);
    grid.addWidget(m_actual, 0, 1, Qt::AlignRight | Qt::AlignVCenter);
    grid.addLayout(line, 1, 0, 1, 2);
    if (bare) {
        line->addWidget(m_detail, 1);
    } else {
        grid.addLayout(inRow({m_bar, m_detail}, 2, kGrid), 2, 0, 1, 2);
    }
}

// The number needs the whole width. Name, state, target and the age of late data share the line below it.
void AxisCard::buildRow(QGridLayout& grid)
{
    grid.addWidget(m_actual, 0, 0, 1, 2, Qt::AlignRight | Qt::AlignVCenter);
    auto* const line = new QHBoxLayout;
    line->setSpacing(kGrid / 2);
    line->addWidget(m_name);
    line->addWidget(m_state);
    line->addStretch(1);
    line->addWidget(m_detail, 20);  // as much of the room as it needs
    line->addWidget(m_targetCaption);
    line->addWidget(m_target);
    grid.addLayout(line, 1, 0, 1, 2);
}

void AxisCard::setNumerals(Numerals numerals)
{
    if (m_numerals == numerals) {
        return;
    }
    m_numerals = numerals;
    m_actual->setFont(fonts::actual(pointsOf(numerals)));
    // Digits need no room for accents and for what is below the line.
    const int digits = m_actual->fontMetrics().tightBoundingRect(QStringLiteral("0°")).height() + kAroundDigits;
    m_actual->setMaximumHeight(numerals == Numerals::Row ? digits : QWIDGETSIZE_MAX);
    for (ValueLabel* const number : {m_target, m_error}) {
        number->setFont(areBeside(numerals) ? fonts::small() : fonts::value());
    }
    const QFont stateFont = areBeside(numerals) ? fonts::label() : fonts::text();
    m_state->setFont(stateFont);
    m_state->setWidest(widestState(stateFont));
    const bool roomForRate = numerals == Numerals::Usual || numerals == Numerals::Large;
    m_rate->setVisible(roomForRate);
    m_rateCaption->setVisible(roomForRate);
    build(numerals);
    chooseShown();
    updateGeometry();
}

void AxisCard::chooseShown()
{
    const bool row = m_numerals == Numerals::Row;
    const bool brief = row || m_numerals == Numerals::Bare;
    const bool live = freshness(m_shown.age) == Freshness::Live;
    m_bar->setVisible(!brief);
    m_detail->setVisible(!brief || !live);
    for (QWidget* const part : {m_errorCaption, static_cast<QWidget*>(m_error)}) {
        part->setVisible(!row && (!brief || live));
    }
    for (QWidget* const part : {m_targetCaption, static_cast<QWidget*>(m_target)}) {
        part->setVisible(!row || live);
    }
}

void AxisCard::showStatus(const StationStatus& status)
{
    m_shown = m_axis == Axis::Azimuth ? status.azimuth : status.elevation;
    m_registers = driveOf(status, m_axis).registers;
    m_trim = status.trim;
    m_hasModel = termsOf(status) != pointing::PointingTerms{};
    m_isXY = hasXY(status);
    const bool turnKnown = isTurnKnown(status, m_axis);
    showNumbers(turnKnown);
    // While the wrap is unknown the count of the drive has no meaning: there is nothing to compare.
    showError(status, freshness(m_shown.age) == Freshness::Live && turnKnown && m_shown.state != AxisState::Missing);
    const Worded state = worded(m_shown, turnKnown || isTurnAwaited(status, m_axis));
    m_state->setValue(state.word, state.tone, state.symbol);
    const bool live = freshness(m_shown.age) == Freshness::Live;
    m_detail->setValue(detail(), !live ? Tone::Warning : trim() != 0_deg ? Tone::Accent : Tone::Secondary);
    chooseShown();
}

void AxisCard::showNumbers(bool turnKnown)
{
    const auto text = [this](Angle angle) {
        return m_axis == Axis::Azimuth ? azimuthText(angle, 2) : angleText(angle);
    };
    const Freshness age = freshness(m_shown.age);
    const bool missing = m_shown.state == AxisState::Missing;
    // While the wrap is unknown the count of the drive has no meaning: no number is shown.
    const bool known = m_shown.actual && age != Freshness::NoData && turnKnown && !missing;
    const Tone tone = age == Freshness::Live ? Tone::Normal : Tone::Secondary;
    const auto show = [](ValueLabel& label, const QString& value, Tone of) {
        label.setValue(value.isEmpty() ? noValue() : value, value.isEmpty() ? Tone::Secondary : of);
    };
    const auto actual = known ? m_shown.beam.actual : std::nullopt;
    const auto target = missing ? std::nullopt : m_shown.beam.target;
    const bool turns = known && m_shown.rate;
    const bool comparable = known && m_shown.target;
    show(*m_actual, actual ? text(steady(m_steadyActual, *actual)) : QString(), tone);
    show(*m_target, target ? text(*target) : QString(), Tone::Normal);
    show(*m_error, comparable ? signedAngleText(steady(m_steadyError, *m_shown.target - *m_shown.actual)) : QString(),
         tone);
    const auto rate = [this] { return AngularRate::fromDegrees(m_steadyRate.shown(m_shown.rate->degrees())); };
    show(*m_rate, turns ? rateText(rate()) : QString(), tone);
}

void AxisCard::showError(const StationStatus& status, bool known)
{
    const BeamAngles& beam = m_shown.beam;
    if (!known || !beam.actual || !beam.target) {
        m_bar->setError(std::nullopt, false);
        return;
    }
    // The higher the beam, the smaller a degree of azimuth is on the sky.
    const double onSky = m_axis == Axis::Azimuth && status.actual ? std::cos(status.actual->elevation.radians()) : 1.0;
    const Angle width = antennaOf(status).beamWidth;
    const auto off = [&](Angle to) { return m_isXY ? (to - *beam.actual).wrapped180() : to - *beam.actual; };
    const auto share = [&](Angle to) { return off(to) / width * onSky; };
    const std::optional<Angle> expected = expectedAngle(status, beam);
    m_bar->setError(share(*beam.target), expected && std::abs(share(*expected)) > 0.5);
}

Angle AxisCard::trim() const
{
    return !m_trim ? 0_deg : m_axis == Axis::Azimuth ? m_trim->azimuth : m_trim->elevation;
}

// The cards without a line for details have room for the age only.
QString AxisCard::detail()
{
    if (m_numerals == Numerals::Bare || m_numerals == Numerals::Row) {
        return detailText(m_shown, m_shown.turnKnown);
    }
    QStringList parts;
    if (trim() != 0_deg) {
        parts << tr("trim %1").arg(signedAngleText(trim()));
    }
    if (m_shown.actual && m_shown.turnKnown && m_hasModel && freshness(m_shown.age) != Freshness::NoData) {
        const QString angle = angleText(steady(m_steadyAxis, *m_shown.actual));
        parts << (!m_isXY                   ? tr("axis %1").arg(angle)
                  : m_axis == Axis::Azimuth ? tr("X %1").arg(angle)
                                            : tr("Y %1").arg(angle));
    }
    if (const QString text = detailText(m_shown, m_shown.turnKnown); !text.isEmpty()) {
        parts << text;
    }
    return parts.join(QStringLiteral(", "));
}

bool AxisCard::event(QEvent* event)
{
    if (event->type() == QEvent::ToolTip) {
        const auto* const help = static_cast<QHelpEvent*>(event);
        QToolTip::showText(help->globalPos(), driveHelp(name(m_axis), m_shown, m_registers), this);
        return true;
    }
    return QWidget::event(event);
}

void AxisCard::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    paintCard(painter, rect());
}

}  // namespace boresight::ui

#include "moc_axis_card.cpp"
