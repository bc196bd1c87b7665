// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tuning/response_chart.h"

#include "ui/kit/theme.h"
#include "ui/tuning/response_item.h"

#include <QEvent>
#include <QPainter>
#include <QVBoxLayout>
#include <qwt_plot.h>
#include <qwt_plot_canvas.h>
#include <qwt_plot_grid.h>
#include <qwt_plot_layout.h>
#include <qwt_scale_draw.h>
#include <qwt_scale_widget.h>

#include <algorithm>
#include <cmath>

namespace boresight::ui {

namespace {

constexpr int kResponseChartGap = 6;  // px, between the parts of the legend
constexpr int kResponseLine = 16;     // px, of line in the legend

int legendRoom()
{
    return QFontMetrics(fonts::label()).height() + 2;
}

// 1, 2 or 5 times a power of ten.
double roundUp(double value)
{
    const double power = std::pow(10.0, std::floor(std::log10(std::max(value, 1e-6))));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * power >= value) {
            return factor * power;
        }
    }
    return 10.0 * power;
}

std::optional<double> valueOf(const response::Sample& sample, ResponseChart::Quantity quantity)
{
    return quantity == ResponseChart::Quantity::Error ? std::optional((sample.actual - sample.wanted).degrees())
                                                      : sample.torque;
}

// A new piece starts after each gap.
std::vector<QPolygonF> piecesOf(const std::vector<response::Sample>& samples, ResponseChart::Quantity quantity)
{
    std::vector<QPolygonF> pieces;
    bool goesOn = false;
    for (const response::Sample& one : samples) {
        const auto value = valueOf(one, quantity);
        if (value) {
            if (!goesOn) {
                pieces.emplace_back();
            }
            pieces.back() << QPointF(one.time.count(), *value);
        }
        goesOn = value.has_value();
    }
    return pieces;
}

}  // namespace

ResponseChart::ResponseChart(QWidget* parent)
    : QWidget(parent),
      m_grid(std::make_unique<QwtPlotGrid>()),
      m_beforeCurve(std::make_unique<ResponseItem>()),
      m_afterCurve(std::make_unique<ResponseItem>()),
      m_plot(new QwtPlot(this))
{
    setAccessibleName(tr("Response of the axis"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, legendRoom(), 0, 0);
    column->addWidget(m_plot);
    setUpPlot();
    setColours();
    showCurves();
}

ResponseChart::~ResponseChart() = default;

void ResponseChart::setUpPlot()
{
    m_plot->setAutoDelete(false);  // the plot owns these items itself
    m_plot->setMinimumSize(1, 1);
    for (const int axis : {QwtAxis::XBottom, QwtAxis::YLeft}) {
        m_plot->setAxisMaxMinor(axis, 0);
        m_plot->setAxisFont(axis, fonts::label());
        m_plot->axisWidget(axis)->setMargin(0);
        m_plot->axisScaleDraw(axis)->enableComponent(QwtAbstractScaleDraw::Backbone, false);
    }
    m_plot->setAxisMaxMajor(QwtAxis::XBottom, 5);
    m_plot->plotLayout()->setCanvasMargin(0);
    auto* const canvas = new QwtPlotCanvas;
    canvas->setFrameStyle(QFrame::NoFrame);
    m_plot->setCanvas(canvas);
    m_grid->attach(m_plot);
    m_beforeCurve->attach(m_plot);
    m_afterCurve->attach(m_plot);
}

void ResponseChart::setColours()
{
    const Theme& colours = currentTheme();
    m_grid->setMajorPen(QPen(colours.grid, 1.0));
    m_beforeCurve->setPen(QPen(colours.secondary, 1.0));
    m_afterCurve->setPen(QPen(colours.accent, 1.8));
    m_plot->setCanvasBackground(colours.plotGround);
    QPalette labels = palette();
    labels.setColor(QPalette::Text, colours.secondary);
    labels.setColor(QPalette::WindowText, colours.secondary);
    for (const int axis : {QwtAxis::XBottom, QwtAxis::YLeft}) {
        m_plot->axisWidget(axis)->setPalette(labels);
    }
    m_plot->replot();
}

void ResponseChart::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange) {
        setColours();
    }
    QWidget::changeEvent(event);
}

void ResponseChart::show(const BeforeAndAfter& results)
{
    const UtcTime before = results.before != nullptr ? results.before->when : UtcTime{};
    const UtcTime after = results.after != nullptr ? results.after->when : UtcTime{};
    if (before == m_beforeTime && after == m_afterTime) {
        return;
    }
    m_beforeTime = before;
    m_afterTime = after;
    m_before = results.before != nullptr ? results.before->samples : std::vector<response::Sample>{};
    m_after = results.after != nullptr ? results.after->samples : std::vector<response::Sample>{};
    showCurves();
}

void ResponseChart::choose(Quantity quantity)
{
    m_quantity = quantity;
    showCurves();
}

void ResponseChart::showCurves()
{
    double largest = 0.0;
    double longest = 1.0;
    for (const auto& [samples, curve] :
         {std::pair(&m_before, m_beforeCurve.get()), std::pair(&m_after, m_afterCurve.get())}) {
        for (const response::Sample& one : *samples) {
            largest = std::max(largest, std::abs(valueOf(one, m_quantity).value_or(0.0)));
            longest = std::max(longest, one.time.count());
        }
        curve->setPieces(piecesOf(*samples, m_quantity));
    }
    m_highest = roundUp(largest > 0.0 ? largest : 1.0);
    m_plot->setAxisScale(QwtAxis::YLeft, -m_highest, m_highest, m_highest);
    m_plot->setAxisScale(QwtAxis::XBottom, 0.0, longest);
    setAccessibleDescription(
        largest > 0.0 ? tr("%1 up to %2 in %3 s").arg(title(), QString::number(largest, 'g', 3)).arg(longest, 0, 'f', 0)
                      : tr("no run yet"));
    m_plot->replot();
    update();
}

QString ResponseChart::title() const
{
    return m_quantity == Quantity::Error ? tr("Tracking error °") : tr("Torque Nm");
}

// The legend above the plot.
void ResponseChart::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(fonts::label());
    const QFontMetrics metrics(painter.font());
    const double middle = legendRoom() / 2.0;
    int x = 0;
    const auto write = [&](const QString& text, const QColor& colour) {
        painter.setPen(colour);
        painter.drawText(QRect(x, 0, width() - x, legendRoom()), Qt::AlignLeft | Qt::AlignVCenter, text);
        x += metrics.horizontalAdvance(text) + kResponseChartGap;
    };
    write(title(), currentTheme().text);
    for (const auto& [pen, word] :
         {std::pair(m_beforeCurve->pen(), tr("before")), std::pair(m_afterCurve->pen(), tr("after"))}) {
        painter.setPen(pen);
        painter.drawLine(QPointF(x, middle), QPointF(x + kResponseLine, middle));
        x += kResponseLine + kResponseChartGap;
        write(word, currentTheme().secondary);
    }
}

}  // namespace boresight::ui

#include "moc_response_chart.cpp"
