// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/messages/station_status.h"
#include "ui/charts/strip_frame.h"
#include "ui/charts/telemetry_store.h"

#include <QWidget>

#include <array>
#include <memory>
#include <optional>

class QButtonGroup;
class QComboBox;
class QGridLayout;

// The charts of one axis, one above the other: position, error, and a quantity of its drive, with the buttons that
// choose the contents. The present is at the right end. When paused, the picture stands still and data are still
// collected. Where the drives reported nothing, nothing is drawn. A mount without such drives has no third chart. The
// charts are in their panel or, in a wide window, beside it.
// More than 15 members: the widgets that it composes, and their contents.
namespace boresight::ui {

class ChoiceButton;
class StripChart;
class TimeAxis;
class ValueLabel;

class StripCharts : public QWidget
{
    Q_OBJECT

public:
    // The clock must outlive the charts. The times of the samples are from this clock.
    explicit StripCharts(const Clock& clock, QWidget* parent = nullptr);

    void add(const std::vector<TickSample>& samples);
    void showStatus(const StationStatus& status);
    void clear();        // the next samples may be older
    void setRecorded();  // for a replay: the right end is a moment of a recording, and its owner pauses

    [[nodiscard]] StripChart& strip(Strip strip) { return *m_strips[static_cast<std::size_t>(strip)]; }
    [[nodiscard]] const ChartChoice& choice() const { return m_choice; }
    void choose(const ChartChoice& choice);  // ignores a choice that is not offered
    [[nodiscard]] const TelemetryStore& store() const { return *m_store; }

protected:
    void showEvent(QShowEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    QWidget* makeStrips();
    QWidget* makeControls();
    void addWindowButtons(QGridLayout& grid);
    void addAxisButtons(QGridLayout& grid);
    void addQuantityBox(QGridLayout& grid);
    void addViewButtons(QGridLayout& grid);
    void chooseWindow(std::chrono::seconds window);
    void chooseAxis(Axis axis);
    void chooseQuantity(DriveQuantity quantity);
    void pause(bool on);
    void moveCursor(std::optional<int> column);
    void refresh();
    void showTime(const ChartSpan& span);
    void showNotice();
    void describeOnceASecond();
    [[nodiscard]] SteadyTime newest() const;
    [[nodiscard]] UtcTime utcOf(SteadyTime time) const;

    const Clock& m_clock;
    std::unique_ptr<TelemetryStore> m_store = std::make_unique<TelemetryStore>();
    ChartChoice m_choice;
    QButtonGroup* m_windows;
    QButtonGroup* m_axes;
    QComboBox* m_quantity;
    // From the status that was shown last, because the cursor redraws the limits between two status values.
    ChartLimits m_limits;
    std::array<bool, 2> m_turnKnown{true, true};  // by Axis
    std::optional<SteadyTime> m_pausedAt;
    std::optional<int> m_cursor;
    bool m_isRecorded = false;
    SteadyTime m_described{};
    std::array<StripChart*, 3> m_strips{};  // by Strip
    TimeAxis* m_time;
    ValueLabel* m_notice;
    ChoiceButton* m_pause;
};

}  // namespace boresight::ui
