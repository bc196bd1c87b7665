// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/budget/error_budget.h"
#include "ui/sky/cable_words.h"
#include "ui/sky/sky_frame.h"

#include <QWidget>

#include <functional>
#include <optional>

class QPainter;

// The contents of the free corners of the plot: the tools (edit the limits, magnify, save a picture), the error of the
// mount, the cable in words, and during editing the numbers under the cursor. The widget is as large as the plot, and
// every click beside a button passes through.
namespace boresight::ui {

class ErrorCorner;
class PlotButton;
class ValueLabel;

class PlotTools : public QWidget
{
    Q_OBJECT

public:
    explicit PlotTools(QWidget* parent = nullptr);

    void setPainter(const std::function<void(QPainter&)>& paint) { m_paint = paint; }
    void setFrame(const SkyFrame& frame);  // of the whole sky
    void showEditing(bool on);
    void hideEditing();  // for a sky that is only looked at
    void showZoom(bool on);
    void showOffTarget(const std::optional<Angle>& error, Angle beamWidth, bool unplanned);
    void showBudget(const std::optional<budget::ErrorBudget>& budget, UtcTime utc);
    void showCable(const CableWords& words);
    void setReadout(const QString& text);
    void save(const QString& path);
    void paintWords(QPainter& painter) const;  // for a picture of the plot

    [[nodiscard]] int readoutHeight() const;
    [[nodiscard]] bool hasReadout() const;
    [[nodiscard]] QList<QWidget*> corners() const;  // these must lie beside the disc

Q_SIGNALS:
    void editToggled(bool on);
    void zoomToggled();
    void readoutToggled();  // the legend, which has the same place, comes or goes

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void place();
    void placeButtons();
    void askWhereTo();
    void showMask();

    std::function<void(QPainter&)> m_paint;
    SkyFrame m_frame;
    PlotButton* m_edit;
    PlotButton* m_zoom;
    PlotButton* m_save;
    ErrorCorner* m_error;
    ValueLabel* m_cable;
    ValueLabel* m_travel;
    ValueLabel* m_readout;
    bool m_hasEditing = true;
};

}  // namespace boresight::ui
