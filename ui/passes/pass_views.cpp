// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/passes/pass_views.h"

#include "ui/kit/choice_button.h"
#include "ui/passes/driven_plan.h"
#include "ui/passes/ground_map.h"
#include "ui/passes/pass_curve.h"
#include "ui/passes/pass_table.h"
#include "ui/passes/pass_timeline.h"
#include "ui/plan/plan_view.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QTableView>

#include <algorithm>
#include <chrono>
#include <utility>

namespace boresight::ui {

PassViews::PassViews(PassTable& passes, QTableView& table, QWidget* parent)
    : QStackedWidget(parent),
      m_passes(passes),
      m_table(table),
      m_timeline(new PassTimeline(this)),
      m_curve(new PassCurve(this)),
      m_map(new GroundMap(this)),
      m_plan(new PlanView(this))
{
    addWidget(&table);
    addWidget(m_timeline);
    addWidget(m_curve);
    addWidget(m_map);
    addWidget(m_plan);
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Expanding);
    const auto becomesOld = [this] { m_isTimelineOld = true; };
    connect(&m_passes, &QAbstractItemModel::modelReset, this, becomesOld);
    connect(&m_passes, &QAbstractItemModel::rowsRemoved, this, becomesOld);
    connect(m_timeline, &PassTimeline::passChosen, this, &PassViews::choose);
    connect(m_timeline, &PassTimeline::stepWanted, this, &PassViews::step);
    connect(m_plan, &PlanView::changed, this, &PassViews::planChanged);
}

QWidget* PassViews::makeChoices(QWidget* parent)
{
    const std::pair<QString, QString> views[] = {{tr("List"), tr("The passes as a list")},
                                                 {tr("Timeline"), tr("The passes of the next 24 hours side by side")},
                                                 {tr("Elevation"), tr("The elevation of the selected pass over time")},
                                                 {tr("Map"), tr("The path of the selected satellite over the Earth")},
                                                 {tr("Plan"), tr("How the mount will track the selected pass")}};
    auto* const box = new QWidget(parent);
    auto* const row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(2);
    auto* const group = new QButtonGroup(box);
    for (std::size_t view = 0; view < m_choices.size(); ++view) {
        auto* const button = new ChoiceButton(views[view].first, views[view].second, box);
        button->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
        m_choices[view] = button;
        group->addButton(button);
        row->addWidget(button);
        connect(button, &QToolButton::clicked, this, [this, view] { showView(static_cast<View>(view)); });
    }
    m_choices[static_cast<std::size_t>(view())]->setChecked(true);
    return box;
}

void PassViews::showView(View view)
{
    m_choices[static_cast<std::size_t>(view)]->setChecked(true);
    setCurrentIndex(view);
    m_isTimelineOld = true;
    showMoment();
    Q_EMIT viewChanged();
}

void PassViews::showStatus(const StationStatus& status)
{
    const bool hasChanged = !m_profile || m_profile->satellites != status.profile->satellites || !m_schedule ||
                            m_schedule->plan != status.schedule->plan;
    m_isTimelineOld = m_isTimelineOld || hasChanged;
    m_profile = status.profile;
    m_schedule = status.schedule;
    m_now = status.utc;
    m_mount.antenna = status.chosenAntenna;
    m_mount.tracked = status.tracked;
    const bool isResting = status.state == StationState::Standby || status.state == StationState::Hold ||
                           status.state == StationState::Parked;
    if (isResting && status.azimuth.actual && status.elevation.actual) {
        m_mount.rest = AxisPosition{.azimuth = *status.azimuth.actual, .elevation = *status.elevation.actual};
    }
    m_map->setSite(m_profile->site.known ? std::optional(m_profile->site.place()) : std::nullopt);
    m_curve->setLowest(lowest());
    if (isVisible()) {
        showMoment();
    }
}

void PassViews::select(const std::shared_ptr<const PassBook>& book, const std::optional<BookedPass>& pass,
                       const targets::SkyWay& way)
{
    m_book = book;
    m_pass = pass;
    m_curve->show(way);
    m_isTrackOld = true;
    m_timeline->setSelected(pass ? book->elementsOf(*pass).number : 0, pass ? pass->pass.tca.utc : UtcTime());
    m_curve->setLowest(lowest());
    showMoment();
}

void PassViews::showMoment()
{
    switch (view()) {
        case List:
            break;
        case Timeline:
            showTimeline();
            break;
        case Elevation:
            m_curve->setNow(m_now);
            break;
        case Map:
            showMap();
            break;
        case Plan:
            showPlan();
            break;
    }
}

void PassViews::showTimeline()
{
    if (m_isTimelineOld && m_profile) {
        m_timeline->show(timelineOf(m_passes, m_profile->satellites, m_schedule->plan));
        m_isTimelineOld = false;
    }
    m_timeline->setNow(m_now);
}

void PassViews::showMap()
{
    if (m_isTrackOld) {
        m_map->show(m_pass ? groundTrackOf(*m_pass, *m_book) : GroundTrack());
        m_isTrackOld = false;
    }
    m_map->setPlace(m_pass ? placeBelow(m_book->elementsOf(*m_pass), m_now) : std::nullopt);
}

void PassViews::showPlan()
{
    m_plan->setDriven(m_pass ? drivenPlan(m_mount.tracked, *m_book, *m_pass) : nullptr);
    m_plan->ask(planQuestion());
    m_plan->setNow(m_now);
}

// Of a pass that has begun, the rest is planned.
std::optional<PlanQuestion> PassViews::planQuestion() const
{
    if (!m_pass || !m_profile) {
        return std::nullopt;
    }
    const orbit::ElementSet& elements = m_book->elementsOf(*m_pass);
    const auto mark = std::ranges::find(m_profile->satellites, elements.number, &orbit::SatelliteMark::number);
    const bool hasOwn = mark != m_profile->satellites.end() && !mark->antenna.empty();
    const bool isUp = m_pass->pass.aos.utc < m_now;
    return PlanQuestion{.target = targets::satelliteTarget(elements),
                        .task = {.from = isUp ? m_now : m_pass->pass.aos.utc,
                                 .to = m_pass->pass.los.utc,
                                 .now = m_mount.rest.value_or(m_profile->park),
                                 .bound = {},
                                 .begins = isUp ? plan::Begins::Now : plan::Begins::Later},
                        .profile = m_profile,
                        .antenna = m_profile->antenna(hasOwn ? mark->antenna : m_mount.antenna)};
}

// The elevation from which the pass counts: that of the watch list, else the lowest elevation of the mount.
std::optional<Angle> PassViews::lowest() const
{
    if (!m_profile) {
        return std::nullopt;
    }
    const std::vector<schedule::WatchEntry>& watched = m_profile->schedule.watch;
    const auto found =
        m_pass ? std::ranges::find(watched, m_book->elementsOf(*m_pass).number, &schedule::WatchEntry::number)
               : watched.end();
    return found == watched.end() ? m_profile->limits.elevation.min : found->leastElevation;
}

void PassViews::choose(std::int64_t number, UtcTime highest)
{
    if (const auto row = m_passes.rowOf(number, highest)) {
        m_table.selectRow(*row);
    }
}

void PassViews::step(int passes)
{
    const int row = m_table.currentIndex().row() + passes;
    if (row >= 0 && row < m_passes.rowCount()) {
        m_table.selectRow(row);
    }
}

}  // namespace boresight::ui

#include "moc_pass_views.cpp"
