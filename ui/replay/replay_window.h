// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "ui/kit/request_desk.h"
#include "ui/link/profile_draft.h"
#include "ui/replay/event_model.h"
#include "ui/replay/replay_player.h"
#include "ui/replay/replay_tape.h"

#include <QWidget>

#include <memory>
#include <optional>

class QTableView;

// The replay of one recording: sky, charts, events and numbers of the moment that the time slider shows. A window of
// its own, without any control of the station. Its requests go nowhere. Gui thread.
namespace boresight::ui {

class MomentNumbers;
class PlayBar;
class PolarPlot;
class ReplayCharts;
class ValueLabel;

class ReplayWindow : public QWidget
{
    Q_OBJECT

public:
    // The clock measures the speed of the replay, and must outlive the window.
    ReplayWindow(const Clock& clock, SharedTape tape, QWidget* parent = nullptr);
    ~ReplayWindow() override;

    // Jumps to the last start of a motion before the moment that is shown, and shows why it began. Pauses. The next
    // call shows the start before that.
    void showWhyItMoved();
    [[nodiscard]] UtcTime momentOf(std::size_t event) const;

    [[nodiscard]] ReplayPlayer& player() { return m_player; }

protected:
    void keyPressEvent(QKeyEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void build();
    [[nodiscard]] QWidget* makeSky();
    [[nodiscard]] QWidget* makeEvents();
    [[nodiscard]] QString title() const;
    [[nodiscard]] QString detail() const;
    [[nodiscard]] std::vector<UtcTime> motionStarts() const;
    [[nodiscard]] bool act(int key);
    void jumpTo(std::size_t event);
    void showMoment();
    void showSky(const StationStatus& status);
    void selectEvent(UtcTime moment);

    SharedTape m_tape;
    std::shared_ptr<const profile::Profile> m_profile;
    // Nobody receives their requests.
    RequestDesk m_desk;
    ProfileDraft m_draft{m_desk};
    ReplayPlayer m_player;
    RecordedEventModel m_events;
    PolarPlot* m_plot;
    MomentNumbers* m_numbers;
    ReplayCharts* m_charts;
    QTableView* m_table;
    ValueLabel* m_why;
    PlayBar* m_bar;
    std::optional<std::size_t> m_answer;  // the start of a motion that is shown
    std::optional<UtcTime> m_trailUntil;  // the plot has the trail up to this moment
};

}  // namespace boresight::ui
