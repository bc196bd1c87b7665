// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sky/plot_tools.h"

#include "ui/kit/file_dialog.h"
#include "ui/kit/format.h"
#include "ui/kit/value_label.h"
#include "ui/sky/error_corner.h"
#include "ui/sky/plot_button.h"
#include "ui/sky/plot_picture.h"

#include <QPainter>

#include <algorithm>
#include <utility>

namespace boresight::ui {

namespace {
constexpr int kPlotToolsGap = 4;  // px
constexpr int kReadoutLines = 3;

// Over the sky of a magnified plot the words have their own background.
ValueLabel* onGround(ValueLabel* label, Qt::Alignment alignment)
{
    label->setAlignment(alignment);
    label->setAutoFillBackground(true);
    return label;
}
}  // namespace

PlotTools::PlotTools(QWidget* parent)
    : QWidget(parent),
      m_edit(new PlotButton(PlotButton::Glyph::Edit, tr("Edit"),
                            tr("Change limits, horizon and keep-outs on the plot (Ctrl+E)"), this)),
      m_zoom(new PlotButton(PlotButton::Glyph::Zoom, tr("Zoom"),
                            tr("Zoom in on the target (Ctrl+0, Ctrl++, Ctrl+- or wheel)"), this)),
      m_save(
          new PlotButton(PlotButton::Glyph::Save, tr("Save …"), tr("Save the plot as a picture (PNG or SVG)"), this)),
      m_error(new ErrorCorner(*this)),
      m_cable(new ValueLabel(tr("Azimuth cable"), fonts::label(), widestCableWords().place, this)),
      m_travel(new ValueLabel(tr("Travel of the azimuth cable"), fonts::label(), widestCableWords().travel, this)),
      m_readout(new ValueLabel(tr("Under the cursor"), fonts::label(), QStringLiteral("az 000.0°…000.0°"), this))
{
    m_travel->setSymbolRoom(true);
    for (ValueLabel* const label : {m_cable, m_travel}) {
        onGround(label, Qt::AlignRight | Qt::AlignVCenter);
    }
    m_readout->setLines(kReadoutLines);
    onGround(m_readout, Qt::AlignLeft | Qt::AlignBottom);
    m_cable->setToolTip(
        tr("The angle of the azimuth axis. At 0° the cable is not wound. The ring around the sky shows the travel."));
    connect(m_edit, &QToolButton::toggled, this, &PlotTools::editToggled);
    connect(m_zoom, &QToolButton::clicked, this, &PlotTools::zoomToggled);
    connect(m_save, &QToolButton::clicked, this, &PlotTools::askWhereTo);
}

int PlotTools::readoutHeight() const
{
    return m_readout->sizeHint().height();
}

bool PlotTools::hasReadout() const
{
    return !m_readout->text().isEmpty();
}

QList<QWidget*> PlotTools::corners() const
{
    QList<QWidget*> all = QList<QWidget*>{m_zoom, m_save} + m_error->parts() + QList<QWidget*>{m_cable, m_travel};
    if (m_hasEditing) {
        all.prepend(m_edit);
    }
    return all;
}

void PlotTools::setFrame(const SkyFrame& frame)
{
    m_frame = frame;
    place();
}

void PlotTools::resizeEvent(QResizeEvent*)
{
    place();
}

// One below the other if the disc leaves room for this, otherwise around the corner.
void PlotTools::placeButtons()
{
    const int step = PlotButton::kSize + kPlotToolsGap + 2;
    const bool column = m_frame.isFree(QRectF(0, 0, kPlotToolsGap + PlotButton::kSize, 3 * step + kPlotToolsGap));
    m_edit->move(kPlotToolsGap, kPlotToolsGap);
    if (!m_hasEditing) {
        m_zoom->move(kPlotToolsGap, kPlotToolsGap);
        m_save->move(kPlotToolsGap, kPlotToolsGap + step);
        return;
    }
    m_zoom->move(kPlotToolsGap, kPlotToolsGap + step);
    m_save->move(column ? QPoint(kPlotToolsGap, kPlotToolsGap + 2 * step)
                        : QPoint(kPlotToolsGap + step, kPlotToolsGap));
}

void PlotTools::place()
{
    placeButtons();
    const auto right = [this](ValueLabel* label, int top) {
        const QSize size = label->sizeHint();
        label->setGeometry(width() - size.width() - kPlotToolsGap, top, size.width(), size.height());
        return top + size.height();
    };
    m_error->place(m_frame, kPlotToolsGap);
    const int travelTop = height() - m_travel->sizeHint().height() - 2;
    right(m_travel, travelTop);
    right(m_cable, travelTop - m_cable->sizeHint().height());
    const QSize text = m_readout->sizeHint();
    m_readout->setGeometry(kPlotToolsGap, height() - text.height() - 2, text.width(), text.height());
    showMask();
}

// Areas outside the mask belong to the plot, for eye and mouse. A label without text is hidden: Qt does not repaint the
// plot below a label with its own background, although it is masked.
void PlotTools::showMask()
{
    QRegion region;
    QList<QWidget*> all = corners();
    all.append(m_readout);
    for (QWidget* const one : std::as_const(all)) {
        const bool needed = !m_error->isEmpty(*one);
        one->setVisible(needed);
        if (needed) {
            region += one->geometry();
        }
    }
    if (region != mask()) {
        setMask(region);
    }
}

void PlotTools::showEditing(bool on)
{
    m_edit->setChecked(on);
}

void PlotTools::hideEditing()
{
    m_hasEditing = false;
    m_edit->hide();
    place();
}

void PlotTools::showZoom(bool on)
{
    m_zoom->setChecked(on);
}

void PlotTools::showOffTarget(const std::optional<Angle>& error, Angle beamWidth, bool unplanned)
{
    if (m_error->showOffTarget(error, beamWidth, unplanned)) {
        showMask();
    }
}

void PlotTools::showBudget(const std::optional<budget::ErrorBudget>& budget, UtcTime utc)
{
    if (m_error->showBudget(budget, utc)) {
        showMask();
    }
}

void PlotTools::showCable(const CableWords& words)
{
    const bool was = m_cable->text().isEmpty();
    m_cable->setValue(words.place, words.tone);
    m_travel->setValue(words.travel, words.isWarning ? Tone::Warning : Tone::Secondary,
                       words.isWarning ? Symbol::Warning : Symbol::None);
    if (was != m_cable->text().isEmpty()) {
        showMask();
    }
}

void PlotTools::setReadout(const QString& text)
{
    const bool was = m_readout->text().isEmpty();
    m_readout->setValue(text);
    if (was != text.isEmpty()) {
        showMask();
        Q_EMIT readoutToggled();
    }
}

void PlotTools::paintWords(QPainter& painter) const
{
    const QList<const ValueLabel*> all = m_error->words() + QList<const ValueLabel*>{m_cable, m_travel};
    for (const ValueLabel* const label : all) {
        painter.setFont(label->font());
        painter.setPen(currentTheme().colour(label->tone()));
        painter.drawText(label->geometry().adjusted(0, 0, -2, 0), Qt::AlignRight | Qt::AlignVCenter, label->text());
    }
}

void PlotTools::askWhereTo()
{
    const QFileDialog* const dialog = askForFile(*this, tr("Save the plot as a picture"), QFileDialog::AcceptSave,
                                                 {tr("PNG picture (*.png)"), tr("SVG drawing (*.svg)")});
    connect(dialog, &QFileDialog::fileSelected, this, &PlotTools::save);
}

void PlotTools::save(const QString& path)
{
    const Result<> saved = savePicture(path, size(), m_paint);
    setReadout(saved ? tr("Saved") : tr("Not saved: %1").arg(saved.error().text));
}

}  // namespace boresight::ui

#include "moc_plot_tools.cpp"
