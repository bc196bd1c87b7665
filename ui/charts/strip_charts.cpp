// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/strip_charts.h"

#include "ui/charts/strip_chart.h"
#include "ui/charts/time_axis.h"
#include "ui/kit/axes.h"
#include "ui/kit/choice_button.h"
#include "ui/kit/command_button.h"
#include "ui/kit/format.h"
#include "ui/kit/theme.h"
#include "ui/kit/value_label.h"

#include <QButtonGroup>
#include <QComboBox>
#include <QGridLayout>
#include <QKeyEvent>
#include <QPainter>
#include <QVBoxLayout>

#include <algorithm>

namespace boresight::ui {

namespace {

constexpr std::array kStrips{Strip::Position, Strip::Error, Strip::Drive};
constexpr std::array kWindows{std::chrono::seconds(10), std::chrono::seconds(60), std::chrono::seconds(300),
                              std::chrono::seconds(1800)};
constexpr std::array kQuantities{DriveQuantity::Torque, DriveQuantity::Current, DriveQuantity::Voltage,
                                 DriveQuantity::Temperature};
constexpr std::chrono::seconds kDescribePeriod{1};

}  // namespace

StripCharts::StripCharts(const Clock& clock, QWidget* parent)
    : QWidget(parent),
      m_clock(clock),
      m_windows(new QButtonGroup(this)),
      m_axes(new QButtonGroup(this)),
      m_quantity(new QComboBox(this)),
      m_time(new TimeAxis(this)),
      m_notice(new ValueLabel(tr("Remark on the charts"), fonts::label(), tr("Wrap unknown"), this)),
      m_pause(new ChoiceButton(tr("Pause"),
                               tr("Freeze the charts. Boresight still records the data (Space in the charts)")))
{
    setAccessibleName(tr("Axis charts"));
    setToolTip(tr("Point at a curve to read it, or press Tab and then the arrow keys. Space pauses"));
    setFocusPolicy(Qt::TabFocus);
    auto* const row = new QHBoxLayout(this);
    row->setContentsMargins(4, 2, 4, 2);
    row->setSpacing(8);
    row->addWidget(makeStrips(), 1);
    row->addWidget(makeControls());
    chooseWindow(m_choice.window);
    chooseQuantity(m_choice.quantity);
}

QWidget* StripCharts::makeStrips()
{
    auto* const box = new QWidget(this);
    auto* const column = new QVBoxLayout(box);
    column->setContentsMargins(2, 2, 2, 2);
    column->setSpacing(2);
    for (const Strip which : kStrips) {
        auto* const chart = new StripChart(box);
        m_strips[static_cast<std::size_t>(which)] = chart;
        chart->setForm(formOf(which, m_choice.quantity));
        connect(chart, &StripChart::cursorMoved, this, [this](int at) { moveCursor(at); });
        connect(chart, &StripChart::cursorLeft, this, [this] { moveCursor(std::nullopt); });
        column->addWidget(chart, 1);
    }
    column->addWidget(m_time);
    return box;
}

QWidget* StripCharts::makeControls()
{
    auto* const box = new QWidget(this);
    auto* const grid = new QGridLayout(box);
    grid->setContentsMargins(0, 2, 0, 2);
    grid->setSpacing(4);
    addWindowButtons(*grid);
    addAxisButtons(*grid);
    addQuantityBox(*grid);
    addViewButtons(*grid);
    m_notice->setLines(3);
    m_notice->setStretching(true);
    grid->addWidget(m_notice, 5, 0, 1, 2);
    grid->setRowStretch(6, 1);
    box->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Preferred);
    return box;
}

void StripCharts::addWindowButtons(QGridLayout& grid)
{
    int place = 0;
    for (const std::chrono::seconds window : kWindows) {
        auto* const button =
            new ChoiceButton(timeText(window), tr("Show the last %1").arg(timeText(window)), grid.parentWidget());
        button->setChecked(window == m_choice.window);
        m_windows->addButton(button, static_cast<int>(window.count()));
        connect(button, &QAbstractButton::clicked, this, [this, window] { chooseWindow(window); });
        grid.addWidget(button, place / 2, place % 2);
        ++place;
    }
}

void StripCharts::addAxisButtons(QGridLayout& grid)
{
    for (const Axis axis : kAxes) {
        auto* const button = new ChoiceButton(shortName(axis), tr("Charts of the %1").arg(name(axis)));
        button->setChecked(axis == m_choice.axis);
        m_axes->addButton(button, static_cast<int>(axis));
        connect(button, &QAbstractButton::clicked, this, [this, axis] { chooseAxis(axis); });
        grid.addWidget(button, 2, static_cast<int>(axisIndex(axis)));
    }
}

void StripCharts::addQuantityBox(QGridLayout& grid)
{
    QComboBox* const box = m_quantity;
    box->setFont(fonts::label());
    box->setAccessibleName(tr("Quantity of the drive"));
    box->setToolTip(tr("Quantity in the lowest strip"));
    box->setMinimumHeight(kTouchSize);
    box->setFocusPolicy(Qt::TabFocus);
    for (const DriveQuantity quantity : kQuantities) {
        box->addItem(ui::name(quantity));
    }
    connect(box, &QComboBox::currentIndexChanged, this,
            [this](int index) { chooseQuantity(kQuantities[static_cast<std::size_t>(index)]); });
    grid.addWidget(box, 3, 0, 1, 2);
}

void StripCharts::addViewButtons(QGridLayout& grid)
{
    connect(m_pause, &QAbstractButton::toggled, this, &StripCharts::pause);
    grid.addWidget(m_pause, 4, 0, 1, 2);
}

void StripCharts::choose(const ChartChoice& choice)
{
    for (QAbstractButton* const button :
         {m_windows->button(static_cast<int>(choice.window.count())), m_axes->button(static_cast<int>(choice.axis))}) {
        if (button != nullptr) {
            button->click();
        }
    }
    const auto quantity = std::find(kQuantities.begin(), kQuantities.end(), choice.quantity);
    if (quantity != kQuantities.end()) {
        m_quantity->setCurrentIndex(static_cast<int>(quantity - kQuantities.begin()));
    }
}

void StripCharts::chooseWindow(std::chrono::seconds window)
{
    m_choice.window = window;
    m_time->setWindow(window);
    for (StripChart* const chart : m_strips) {
        chart->setWindow(window);
        chart->setForm(chart->form());  // draws again with the new scale, because the contents are the same
    }
    refresh();
}

void StripCharts::chooseAxis(Axis axis)
{
    m_choice.axis = axis;
    for (StripChart* const chart : m_strips) {
        chart->setForm(chart->form());
    }
    showNotice();
    refresh();
}

void StripCharts::chooseQuantity(DriveQuantity quantity)
{
    m_choice.quantity = quantity;
    strip(Strip::Drive).setForm(formOf(Strip::Drive, quantity));
    refresh();
}

void StripCharts::pause(bool on)
{
    m_pausedAt = on ? std::optional(m_clock.now()) : std::nullopt;
    showNotice();
    refresh();
}

void StripCharts::add(const std::vector<TickSample>& samples)
{
    m_store->add(samples);
}

void StripCharts::clear()
{
    m_store = std::make_unique<TelemetryStore>();
}

void StripCharts::setRecorded()
{
    m_isRecorded = true;
    m_pause->hide();
    setToolTip(tr("Point at a curve to read it, or press Tab and then the arrow keys"));
}

void StripCharts::showStatus(const StationStatus& status)
{
    m_limits = {.profile = status.profile, .beamWidth = antennaOf(status).beamWidth};
    for (const Axis axis : kAxes) {
        m_turnKnown[axisIndex(axis)] = isTurnKnown(status, axis);
        m_axes->button(static_cast<int>(axis))->setText(shortName(axis, status));
    }
    strip(Strip::Drive).setVisible(status.drives.has_value());
    m_quantity->setVisible(status.drives.has_value());
    showNotice();
    refresh();
}

void StripCharts::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    refresh();
}

SteadyTime StripCharts::newest() const
{
    return m_pausedAt.value_or(m_clock.now());
}

UtcTime StripCharts::utcOf(SteadyTime time) const
{
    return m_clock.utc() - std::chrono::duration_cast<UtcTime::duration>(m_clock.now() - time);
}

void StripCharts::refresh()
{
    if (!isVisible()) {
        return;
    }
    const ChartSpan span = spanOf(m_choice.window, m_strips.front()->columns(), newest(), m_cursor);
    for (const Strip which : kStrips) {
        strip(which).showFrame(frameOf(*m_store, which, m_choice, span, m_limits));
    }
    showTime(span);
    describeOnceASecond();
}

void StripCharts::showTime(const ChartSpan& span)
{
    const StripChart& top = *m_strips.front();
    const int left = top.mapTo(this, top.canvas().topLeft()).x() - m_time->mapTo(this, QPoint(0, 0)).x();
    m_time->setCanvas(left, top.canvas().width());
    m_time->setNewest(m_pausedAt || m_isRecorded ? clockText(utcOf(newest())) + QLatin1Char('Z') : tr("now"));
    if (const auto time = span.cursorTime()) {
        const int x = left + static_cast<int>(*span.cursor / devicePixelRatioF());
        m_time->setCursor(
            x, tr("−%1 s  %2Z").arg(Seconds(newest() - *time).count(), 0, 'f', 1).arg(clockText(utcOf(*time))));
    } else {
        m_time->setCursor(0, {});
    }
}

void StripCharts::showNotice()
{
    if (!m_turnKnown[axisIndex(m_choice.axis)]) {
        m_notice->setValue(tr("Wrap unknown"), Tone::Warning, Symbol::Warning);
    } else if (m_pausedAt) {
        m_notice->setValue(tr("PAUSED"), Tone::Advisory, Symbol::Advisory);
    } else {
        m_notice->setValue({});
    }
}

void StripCharts::describeOnceASecond()
{
    const auto since = m_clock.now() - m_described;
    if (since < kDescribePeriod && since >= SteadyTime::duration::zero()) {  // a replay may jump back
        return;
    }
    m_described = m_clock.now();
    QString words =
        m_pausedAt ? tr("%1, %2 before %3Z, paused.")
                         .arg(name(m_choice.axis), timeText(m_choice.window), clockText(utcOf(*m_pausedAt)))
        : m_isRecorded
            ? tr("%1, %2 before %3Z.").arg(name(m_choice.axis), timeText(m_choice.window), clockText(utcOf(newest())))
            : tr("%1, last %2.").arg(name(m_choice.axis), timeText(m_choice.window));
    for (StripChart* const chart : m_strips) {
        if (chart->isHidden()) {
            continue;
        }
        words += QLatin1Char(' ') + describe(chart->form(), chart->frame()) + QLatin1Char('.');
    }
    setAccessibleDescription(words);
}

void StripCharts::moveCursor(std::optional<int> column)
{
    m_cursor = column;
    refresh();
}

void StripCharts::keyPressEvent(QKeyEvent* event)
{
    const int last = m_strips.front()->columns() - 1;
    const int at = m_cursor.value_or(last);
    const int step = event->modifiers().testFlag(Qt::ShiftModifier) ? 10 : 1;
    switch (event->key()) {
        case Qt::Key_Left:
            moveCursor(std::max(0, at - step));
            break;
        case Qt::Key_Right:
            moveCursor(std::min(last, at + step));
            break;
        case Qt::Key_Home:
            moveCursor(0);
            break;
        case Qt::Key_End:
            moveCursor(last);
            break;
        case Qt::Key_Space:
            if (!m_isRecorded) {
                m_pause->click();
                break;
            }
            [[fallthrough]];
        default:
            QWidget::keyPressEvent(event);
    }
}

void StripCharts::focusInEvent(QFocusEvent* event)
{
    QWidget::focusInEvent(event);
    update();
}

void StripCharts::focusOutEvent(QFocusEvent* event)
{
    QWidget::focusOutEvent(event);
    moveCursor(std::nullopt);
    update();
}

// Shows the focus.
void StripCharts::paintEvent(QPaintEvent*)
{
    if (hasFocus()) {
        QPainter painter(this);
        painter.setPen(QPen(currentTheme().accent, 2.0));
        painter.drawRect(m_strips.front()->parentWidget()->geometry().adjusted(-1, -1, 1, 1));
    }
}

}  // namespace boresight::ui

#include "moc_strip_charts.cpp"
