// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/passes/pass_timeline_rows.h"

#include <QAbstractScrollArea>

#include <optional>

// The coming passes of a day as a picture: a row for each satellite and a bar for each pass. A higher pass has a
// stronger bar. A click or the arrow keys select a pass. Passive: it paints the given timeline. Gui thread, UTC.
namespace boresight::ui {

class PassTimeline : public QAbstractScrollArea
{
    Q_OBJECT

public:
    explicit PassTimeline(QWidget* parent = nullptr);

    void show(const Timeline& timeline);
    void setNow(UtcTime now);
    void setSelected(std::int64_t number, UtcTime highest);

    [[nodiscard]] const Timeline& timeline() const { return m_timeline; }
    [[nodiscard]] QRectF barBox(std::size_t row, const TimelineBar& bar) const;  // in pixels of the viewport
    [[nodiscard]] QString leftOutText() const;  // the number of satellites without a row; empty: none
    [[nodiscard]] std::size_t rowCount() const;
    [[nodiscard]] QString summary() const;  // the picture in words, for a screen reader
    [[nodiscard]] QRectF nameBox(std::size_t row) const;

    [[nodiscard]] QSize minimumSizeHint() const override { return {200, 80}; }

Q_SIGNALS:
    void passChosen(std::int64_t number, boresight::UtcTime highest);
    void stepWanted(int passes);  // 1: the next pass in the order of time, -1: the previous one

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool viewportEvent(QEvent* event) override;

private:
    struct Place
    {
        std::size_t row = 0;
        std::size_t bar = 0;
    };

    [[nodiscard]] double pixelOf(UtcTime utc) const;
    [[nodiscard]] double rowHeight() const;
    [[nodiscard]] double nameWidth() const;
    [[nodiscard]] double headHeight() const;
    [[nodiscard]] QRectF rowBox(std::size_t row) const;
    [[nodiscard]] bool isSelected(const TimelineRow& row, const TimelineBar& bar) const;
    [[nodiscard]] std::optional<Place> placeAt(const QPointF& at) const;
    [[nodiscard]] QString helpAt(const QPointF& at) const;
    void fitScrollBar();
    void showSelectedRow();
    void paintRow(QPainter& painter, std::size_t row) const;
    void paintBar(QPainter& painter, std::size_t row, const TimelineBar& bar) const;
    void paintHours(QPainter& painter) const;
    void paintSelectedSpan(QPainter& painter) const;

    Timeline m_timeline;
    double m_widestName = 0.0;  // px
    UtcTime m_now{};
    UtcTime m_begin{};  // at the left edge: the beginning of the present hour
    std::int64_t m_number = 0;
    UtcTime m_highest{};
};

}  // namespace boresight::ui
