// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "core/targets/sky_moment.h"
#include "ui/passes/pass_book.h"
#include "ui/plan/pass_planner.h"

#include <QStackedWidget>

#include <array>
#include <memory>
#include <optional>
#include <string>

class QTableView;

// The views of the passes: a list, a timeline, and for the selected pass its elevation over time, its track over the
// Earth and its plan. Hidden views compute nothing. Gui thread.
namespace boresight::ui {

class ChoiceButton;
class GroundMap;
class PassCurve;
class PassTable;
class PassTimeline;
class PlanView;

class PassViews : public QStackedWidget
{
    Q_OBJECT

public:
    enum View
    {
        List,
        Timeline,
        Elevation,
        Map,
        Plan
    };

    // Takes the table as the list.
    PassViews(PassTable& passes, QTableView& table, QWidget* parent = nullptr);

    [[nodiscard]] QWidget* makeChoices(QWidget* parent);  // buttons that switch the view; call it once
    void showView(View view);
    [[nodiscard]] View view() const { return static_cast<View>(currentIndex()); }
    [[nodiscard]] const PlanView& plan() const { return *m_plan; }

    void showStatus(const StationStatus& status);  // once a second is enough
    // Empty `pass`: none is selected.
    void select(const std::shared_ptr<const PassBook>& book, const std::optional<BookedPass>& pass,
                const targets::SkyWay& way);

Q_SIGNALS:
    void viewChanged();
    void planChanged();

private:
    // What a plan depends on.
    struct Mount
    {
        std::string antenna;               // chosen by the operator
        std::optional<AxisPosition> rest;  // where the mount stood last
        std::optional<TrackedTarget> tracked;
    };

    void showTimeline();
    void showMap();
    void showPlan();
    void showMoment();
    void step(int passes);
    void choose(std::int64_t number, UtcTime highest);
    [[nodiscard]] std::optional<Angle> lowest() const;
    [[nodiscard]] std::optional<PlanQuestion> planQuestion() const;

    PassTable& m_passes;
    QTableView& m_table;
    PassTimeline* m_timeline;
    PassCurve* m_curve;
    GroundMap* m_map;
    PlanView* m_plan;
    std::array<ChoiceButton*, 5> m_choices{};
    std::shared_ptr<const profile::Profile> m_profile;
    std::shared_ptr<const ScheduleStatus> m_schedule;
    Mount m_mount;
    UtcTime m_now{};
    std::shared_ptr<const PassBook> m_book;  // the book of the selected pass
    std::optional<BookedPass> m_pass;
    bool m_isTimelineOld = true;
    bool m_isTrackOld = true;
};

}  // namespace boresight::ui
