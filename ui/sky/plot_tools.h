// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include <functional>

class QPainter;

// The controls in the corners of the plot: edit the limits, magnify, save a picture; and below them the numbers under
// the cursor. The widget itself is as large as the plot and lets every click through that hits no button.
namespace boresight::ui {

class ChoiceButton;
class ValueLabel;

class PlotTools : public QWidget
{
    Q_OBJECT

public:
    explicit PlotTools(QWidget* parent = nullptr);

    void setPainter(const std::function<void(QPainter&)>& paint) { m_paint = paint; }
    void showEditing(bool on);
    void showZoom(bool on);
    void setReadout(const QString& text);
    void save(const QString& path);

    [[nodiscard]] int readoutHeight() const;

Q_SIGNALS:
    void editToggled(bool on);
    void zoomToggled();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void askWhereTo();
    void showMask();

    std::function<void(QPainter&)> m_paint;
    ChoiceButton* m_edit;
    ChoiceButton* m_zoom;
    ChoiceButton* m_save;
    ValueLabel* m_readout;
};

}  // namespace boresight::ui
