// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/strip_chart.h"

#include "ui/charts/strip_items.h"
#include "ui/charts/time_axis.h"
#include "ui/kit/theme.h"

#include <QEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QVBoxLayout>
#include <qwt_interval.h>
#include <qwt_plot.h>
#include <qwt_plot_canvas.h>
#include <qwt_plot_grid.h>
#include <qwt_plot_layout.h>
#include <qwt_scale_map.h>
#include <qwt_scale_widget.h>

#include <algorithm>

namespace boresight::ui {

namespace {

constexpr int kStripChartGap = 4;  // px, between the parts of the caption
constexpr int kSample = 16;        // px, of line in the legend

int captionHeight()
{
    return QFontMetrics(fonts::label()).height() + 2;
}

}  // namespace

StripChart::StripChart(QWidget* parent)
    : QWidget(parent),
      m_scale(1.0),
      m_grid(std::make_unique<QwtPlotGrid>()),
      m_traces(std::make_unique<TracesItem>()),
      m_marks(std::make_unique<MarksItem>()),
      m_plot(new QwtPlot(this)),
      m_labels(new ValueScaleDraw)
{
    setFont(fonts::label());
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, captionHeight(), 0, 0);
    column->addWidget(m_plot);
    setUpPlot();
    setColours();
}

StripChart::~StripChart() = default;

void StripChart::setUpPlot()
{
    m_plot->setAutoDelete(false);  // the plot owns these items itself
    m_plot->setAttribute(Qt::WA_TransparentForMouseEvents);
    m_plot->setMinimumSize(1, 1);
    m_plot->setAxisVisible(QwtAxis::XBottom, false);  // TimeAxis draws one axis for all strips
    m_plot->setAxisScaleDraw(QwtAxis::YLeft, m_labels);
    m_plot->setAxisMaxMinor(QwtAxis::YLeft, 0);
    m_plot->setAxisFont(QwtAxis::YLeft, fonts::label());
    m_plot->axisWidget(QwtAxis::YLeft)->setMargin(0);
    // The same room for the labels in every strip, so that equal times are below each other.
    m_labels->setMinimumExtent(QFontMetrics(fonts::label()).horizontalAdvance(QStringLiteral("-0.005")) + 14);
    m_labels->enableComponent(QwtAbstractScaleDraw::Backbone, false);
    m_plot->plotLayout()->setCanvasMargin(0);
    auto* const canvas = new QwtPlotCanvas;
    canvas->setFrameStyle(QFrame::NoFrame);
    canvas->setPaintAttribute(QwtPlotCanvas::BackingStore, false);  // the same picture is never painted twice
    m_plot->setCanvas(canvas);
    m_traces->setFrame(m_frame);
    m_marks->setFrame(m_frame);
    m_grid->setZ(1.0);
    m_marks->setZ(2.0);
    m_traces->setZ(3.0);
    for (QwtPlotItem* const item : std::initializer_list<QwtPlotItem*>{m_grid.get(), m_marks.get(), m_traces.get()}) {
        item->attach(m_plot);
    }
    setWindow(std::chrono::seconds(60));
    fitScale();
}

void StripChart::setColours()
{
    m_grid->setMajorPen(QPen(currentTheme().grid, 1.0));
    m_plot->setCanvasBackground(currentTheme().plotGround);
    QPalette labels = palette();
    labels.setColor(QPalette::Text, currentTheme().secondary);
    labels.setColor(QPalette::WindowText, currentTheme().secondary);
    m_plot->axisWidget(QwtAxis::YLeft)->setPalette(labels);
}

void StripChart::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange) {
        setColours();
    }
    QWidget::changeEvent(event);
}

void StripChart::setForm(const StripForm& form)
{
    m_form = form;
    m_scale = StripScale(form.leastSpan, form.scale);
    fitScale();
    update();
}

void StripChart::setWindow(std::chrono::seconds window)
{
    const auto seconds = static_cast<double>(window.count());
    m_plot->setAxisScale(QwtAxis::XBottom, -seconds, 0.0, static_cast<double>(timeStep(window).count()));
    m_plot->updateAxes();
}

void StripChart::showFrame(const StripFrame& frame)
{
    m_frame = frame;
    fitScale();
    m_plot->canvas()->update();
    update(0, 0, width(), captionHeight());
}

void StripChart::fitScale()
{
    std::optional<PeakRange> shown;
    for (const Trace& trace : m_frame.traces) {
        for (const PeakColumn& column : trace.columns) {
            shown = shown.value_or(column.range);
            shown->include(column.range);
        }
    }
    if (shown) {
        m_scale.fit(static_cast<double>(shown->min), static_cast<double>(shown->max));
    }
    const QwtInterval now = m_plot->axisInterval(QwtAxis::YLeft);
    if (now.minValue() != m_scale.lower() || now.maxValue() != m_scale.upper()) {
        m_labels->setDecimals(m_scale.decimals());
        m_plot->setAxisScale(QwtAxis::YLeft, m_scale.lower(), m_scale.upper(), m_scale.step());
        m_plot->updateAxes();
    }
}

QRect StripChart::canvas() const
{
    const QWidget* const canvas = m_plot->canvas();
    return {canvas->mapTo(this, QPoint(0, 0)), canvas->size()};
}

int StripChart::columns() const
{
    return static_cast<int>(canvas().width() * devicePixelRatioF());
}

QPointF StripChart::pixel(int column, double value) const
{
    return {canvas().left() + (column + 0.5) / devicePixelRatioF(),
            canvas().top() + m_plot->canvasMap(QwtAxis::YLeft).transform(value)};
}

QString StripChart::caption() const
{
    QString text = m_form.title + m_form.unit;
    for (const Trace& trace : m_frame.traces) {
        text += QStringLiteral("  %1 %2").arg(trace.word, valueText(trace.value, m_form.decimals));
    }
    return text;
}

// The legend with the values. If it is too long the words are left out, because lines and bands still identify the
// curves.
void StripChart::paintEvent(QPaintEvent*)
{
    const bool words = paintCaption(nullptr, true) <= width();
    QPainter painter(this);
    paintCaption(&painter, words);
}

// Returns the width. Without a painter the caption is only measured.
int StripChart::paintCaption(QPainter* painter, bool words) const
{
    const Theme& colours = currentTheme();
    int x = 0;
    const auto write = [&](const QFont& font, const QColor& colour, const QString& text) {
        if (painter != nullptr) {
            painter->setFont(font);
            painter->setPen(colour);
            painter->drawText(QRect(x, 0, width() - x, captionHeight()), Qt::AlignLeft | Qt::AlignVCenter, text);
        }
        x += QFontMetrics(font).horizontalAdvance(text) + kStripChartGap;
    };
    QFont title = fonts::label();
    title.setBold(true);
    write(title, colours.text, m_form.title);
    for (const Trace& trace : m_frame.traces) {
        if (painter != nullptr) {
            painter->setPen(tracePen(trace.line));
            painter->drawLine(x + kStripChartGap, captionHeight() / 2, x + kStripChartGap + kSample,
                              captionHeight() / 2);
        }
        x += kSample + 3 * kStripChartGap;
        if (words && !trace.word.isEmpty()) {
            write(fonts::label(), colours.secondary, trace.word);
        }
        write(fonts::small(), colours.text, valueText(trace.value, m_form.decimals) + m_form.unit);
    }
    return x;
}

void StripChart::putCursor(double x)
{
    const int column = static_cast<int>((x - canvas().left()) * devicePixelRatioF());
    if (column >= 0 && column < columns()) {
        Q_EMIT cursorMoved(column);
    } else {
        Q_EMIT cursorLeft();
    }
}

void StripChart::mouseMoveEvent(QMouseEvent* event)
{
    putCursor(event->position().x());
}

void StripChart::mousePressEvent(QMouseEvent* event)
{
    putCursor(event->position().x());
}

void StripChart::leaveEvent(QEvent*)
{
    Q_EMIT cursorLeft();
}

}  // namespace boresight::ui

#include "moc_strip_chart.cpp"
