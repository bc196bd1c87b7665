// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/north/deviation_plot.h"

#include "ui/kit/format.h"
#include "ui/kit/theme.h"
#include "ui/north/deviation_items.h"

#include <QEvent>
#include <QPainter>
#include <QVBoxLayout>
#include <qwt_plot.h>
#include <qwt_plot_canvas.h>
#include <qwt_plot_grid.h>
#include <qwt_plot_layout.h>
#include <qwt_scale_div.h>
#include <qwt_scale_draw.h>
#include <qwt_scale_map.h>
#include <qwt_scale_widget.h>

#include <algorithm>

namespace boresight::ui {

namespace {

constexpr double kLimits[] = {2.0, 5.0, 10.0, 15.0, 20.0, 30.0, 45.0, 60.0, 90.0};  // degrees
constexpr double kNoSwing = 10.0;                                                   // degrees, up and down
constexpr double kOtherSide = 0.25;   // of the higher side: otherwise the numbers at 0 and at the lower end overlap
constexpr int kDeviationPlotGap = 5;  // px, between the parts of the legend

double limitFor(double largest)
{
    const auto fitting = std::ranges::find_if(kLimits, [&](double limit) { return limit >= largest; });
    return fitting == std::end(kLimits) ? 180.0 : *fitting;
}

int captionRoom()
{
    return QFontMetrics(fonts::label()).height() + 2;
}

}  // namespace

DeviationPlot::DeviationPlot(QWidget* parent)
    : QWidget(parent),
      m_grid(std::make_unique<QwtPlotGrid>()),
      m_item(std::make_unique<SwingItem>()),
      m_plot(new QwtPlot(this))
{
    setAccessibleName(tr("Compass error"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, captionRoom(), 0, 0);
    column->addWidget(m_plot);
    setUpPlot();
    setColours();
    fitScale();
}

DeviationPlot::~DeviationPlot() = default;

void DeviationPlot::setUpPlot()
{
    m_plot->setAutoDelete(false);  // the plot owns these items itself
    m_plot->setMinimumSize(1, 1);
    m_plot->setAxisScale(QwtAxis::XBottom, 0.0, 360.0, 90.0);
    for (const int axis : {QwtAxis::XBottom, QwtAxis::YLeft}) {
        m_plot->setAxisMaxMinor(axis, 0);
        m_plot->setAxisFont(axis, fonts::label());
        m_plot->axisWidget(axis)->setMargin(0);
        m_plot->axisScaleDraw(axis)->enableComponent(QwtAbstractScaleDraw::Backbone, false);
    }
    m_plot->plotLayout()->setCanvasMargin(0);
    auto* const canvas = new QwtPlotCanvas;
    canvas->setFrameStyle(QFrame::NoFrame);
    m_plot->setCanvas(canvas);
    m_grid->attach(m_plot);
    m_item->attach(m_plot);
}

void DeviationPlot::setColours()
{
    m_grid->setMajorPen(QPen(currentTheme().grid, 1.0));
    m_plot->setCanvasBackground(currentTheme().plotGround);
    QPalette labels = palette();
    labels.setColor(QPalette::Text, currentTheme().secondary);
    labels.setColor(QPalette::WindowText, currentTheme().secondary);
    for (const int axis : {QwtAxis::XBottom, QwtAxis::YLeft}) {
        m_plot->axisWidget(axis)->setPalette(labels);
    }
    m_plot->replot();
}

void DeviationPlot::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange) {
        setColours();
    }
    QWidget::changeEvent(event);
}

void DeviationPlot::showSwing(std::shared_ptr<const SwingOutcome> swing)
{
    m_swing = std::move(swing);
    m_turns = false;
    m_dots.clear();
    m_item->setSwing(m_swing);
    m_item->setDots({});
    fitScale();
    setAccessibleDescription(m_swing ? tr("%1 samples, first harmonic %2, second %3, scatter %4")
                                           .arg(m_swing->fit.samples.size())
                                           .arg(angleText(m_swing->fit.curve.firstAmplitude(), 1),
                                                angleText(m_swing->fit.curve.secondAmplitude(), 1),
                                                angleText(m_swing->fit.curve.scatter, 1))
                                     : tr("no swing yet"));
    m_plot->replot();
    update();
}

void DeviationPlot::showDots(const std::vector<calibration::SwingDot>& dots, const QString& said)
{
    if (accessibleDescription() != said) {
        setAccessibleDescription(said);
    }
    if (m_turns && dots == m_dots) {
        return;
    }
    m_swing.reset();
    m_turns = true;
    m_dots = dots;
    m_item->setSwing(nullptr);
    m_item->setDots(dots);
    fitScale();
    m_plot->replot();
    update();
}

// Dots that the fit has not used may lie far out, so they do not change the scale. Before the swing ends, the scale has
// at least the range kNoSwing. Upper and lower end are independent, so the curve fills the plot and the scatter of the
// readings is visible.
void DeviationPlot::fitScale()
{
    const double atFirst = m_swing ? 0.0 : kNoSwing;
    double least = -atFirst;
    double most = atFirst;
    const auto take = [&](Angle error, bool isUsed) {
        least = isUsed ? std::min(least, error.degrees()) : least;
        most = isUsed ? std::max(most, error.degrees()) : most;
    };
    for (const calibration::SwingDot& dot : m_dots) {
        take(dot.error, dot.isUsed);
    }
    if (m_swing) {
        for (const calibration::SwingResidual& one : m_swing->fit.samples) {
            take(one.error, one.fate == calibration::SampleFate::Used);
        }
    }
    m_lowest = -limitFor(std::max(-least, most * kOtherSide));
    m_highest = limitFor(std::max(most, -least * kOtherSide));
    const QList<double> ticks{m_lowest, 0.0, m_highest};
    m_plot->setAxisScaleDiv(QwtAxis::YLeft, QwtScaleDiv(m_lowest, m_highest, {}, {}, ticks));
    m_plot->updateAxes();
}

QPointF DeviationPlot::pixel(Angle heading, Angle error) const
{
    const QWidget* const canvas = m_plot->canvas();
    const QPointF inCanvas(m_plot->canvasMap(QwtAxis::XBottom).transform(heading.degrees()),
                           m_plot->canvasMap(QwtAxis::YLeft).transform(error.degrees()));
    return canvas->mapTo(this, QPoint(0, 0)) + inCanvas;
}

// The legend above the plot.
void DeviationPlot::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(fonts::label());
    const QFontMetrics metrics(painter.font());
    const double middle = captionRoom() / 2.0;
    int x = 0;
    const auto write = [&](const QString& text, const QColor& colour) {
        painter.setPen(colour);
        painter.drawText(QRect(x, 0, width() - x, captionRoom()), Qt::AlignLeft | Qt::AlignVCenter, text);
        x += metrics.horizontalAdvance(text) + 2 * kDeviationPlotGap;
    };
    write(tr("Compass error (°) by heading"), currentTheme().text);
    for (const auto& [shape, word] :
         {std::pair(SampleShape::Clockwise, tr("clockwise")), std::pair(SampleShape::Back, tr("back")),
          std::pair(SampleShape::LeftOut, tr("left out"))}) {
        drawSample(painter, shape, QPointF(x + kDeviationPlotGap, middle));
        x += 3 * kDeviationPlotGap;
        write(word, currentTheme().secondary);
    }
    painter.fillRect(QRectF(x, middle - 5.0, 12.0, 10.0), QBrush(currentTheme().secondary, Qt::BDiagPattern));
    x += 12 + kDeviationPlotGap;
    write(tr("unreliable"), currentTheme().secondary);
}

}  // namespace boresight::ui

#include "moc_deviation_plot.cpp"
