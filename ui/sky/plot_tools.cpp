// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sky/plot_tools.h"

#include "ui/kit/choice_button.h"
#include "ui/kit/file_dialog.h"
#include "ui/kit/value_label.h"
#include "ui/sky/plot_picture.h"

namespace boresight::ui {

namespace {
constexpr int kPlotToolsGap = 4;  // px
constexpr int kButtonWidth = 64;
constexpr int kReadoutLines = 3;
}  // namespace

PlotTools::PlotTools(QWidget* parent)
    : QWidget(parent),
      m_edit(new ChoiceButton(tr("Edit"), tr("Change limits, horizon and keep-outs on the plot (Ctrl+E)"), this)),
      m_zoom(new ChoiceButton(tr("Zoom"), tr("Magnify around the target (Ctrl+0; Ctrl++, Ctrl+-, wheel)"), this)),
      m_save(new ChoiceButton(tr("Save …"), tr("Save the plot as a picture (PNG or SVG)"), this)),
      m_readout(new ValueLabel(tr("Under the cursor"), fonts::label(), QStringLiteral("az 000.0°…000.0°"), this))
{
    m_save->setCheckable(false);
    m_readout->setLines(kReadoutLines);
    m_readout->setAlignment(Qt::AlignLeft | Qt::AlignBottom);
    connect(m_edit, &QToolButton::toggled, this, &PlotTools::editToggled);
    connect(m_zoom, &QToolButton::clicked, this, &PlotTools::zoomToggled);
    connect(m_save, &QToolButton::clicked, this, &PlotTools::askWhereTo);
}

int PlotTools::readoutHeight() const
{
    return m_readout->sizeHint().height();
}

void PlotTools::resizeEvent(QResizeEvent*)
{
    const int left = width() - kButtonWidth;
    const int high = m_edit->minimumHeight();
    m_edit->setGeometry(left, 0, kButtonWidth, high);
    m_zoom->setGeometry(left, high + kPlotToolsGap, kButtonWidth, high);
    m_save->setGeometry(left, height() - high, kButtonWidth, high);
    const QSize text = m_readout->sizeHint();
    m_readout->setGeometry(kPlotToolsGap, height() - text.height() - kPlotToolsGap, text.width(), text.height());
    showMask();
}

// What is not masked is the plot's, for eye and mouse.
void PlotTools::showMask()
{
    QRegion region;
    for (const QWidget* const one : std::initializer_list<QWidget*>{m_edit, m_zoom, m_save}) {
        region += one->geometry();
    }
    if (!m_readout->text().isEmpty()) {
        region += m_readout->geometry();
    }
    setMask(region);
}

void PlotTools::showEditing(bool on)
{
    m_edit->setChecked(on);
}

void PlotTools::showZoom(bool on)
{
    m_zoom->setChecked(on);
}

void PlotTools::setReadout(const QString& text)
{
    const bool was = m_readout->text().isEmpty();
    m_readout->setValue(text);
    if (was != text.isEmpty()) {
        showMask();
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
