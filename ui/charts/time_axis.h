// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include <chrono>

// The time axis below the strips: "now", or the time of the pause, at the right end, and the age before it.
namespace boresight::ui {

class TimeAxis : public QWidget
{
    Q_OBJECT

public:
    explicit TimeAxis(QWidget* parent = nullptr);

    void setWindow(std::chrono::seconds window);
    void setNewest(const QString& text);         // "now"
    void setCanvas(int left, int width);         // where the strips draw
    void setCursor(int x, const QString& text);  // the text below the cursor; empty: no cursor

    [[nodiscard]] const QString& cursorText() const { return m_cursorText; }
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    [[nodiscard]] QRect labelBox(double x, const QString& text) const;

    std::chrono::seconds m_window{60};
    QString m_newest;
    QString m_cursorText;
    int m_cursorX = 0;
    int m_left = 0;
    int m_width = 1;
};

// The step between two lines of the grid, and its label: "2 s", "15 s", "5 min".
[[nodiscard]] std::chrono::seconds timeStep(std::chrono::seconds window);
[[nodiscard]] QString timeText(std::chrono::seconds time);

}  // namespace boresight::ui
