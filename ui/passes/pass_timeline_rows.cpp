// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/passes/pass_timeline_rows.h"

#include "core/targets/target.h"

#include <algorithm>
#include <map>
#include <unordered_map>
#include <utility>

namespace boresight::ui {

namespace {

// The plan of the schedule, by satellite number.
class PlanIndex
{
public:
    struct Planned
    {
        UtcTime highest{};
        PassPlan plan = PassPlan::None;
        std::vector<passes::Stretch> tracked = {};
    };

    explicit PlanIndex(const schedule::NightPlan& plan)
    {
        for (const schedule::WatchedPass& pass : plan.chosen) {
            if (!pass.rest) {  // a rest belongs to an omitted pass, which is added with the conflicts
                add(pass, PassPlan::Tracked, {{.from = pass.rises(), .to = pass.sets()}});
            }
        }
        for (const schedule::Conflict& conflict : plan.conflicts) {
            add(conflict.leftOut, PassPlan::LeftOut, conflict.rests);
        }
        for (const schedule::WatchedPass& pass : plan.hidden) {
            add(pass, PassPlan::LeftOut, {});
        }
    }

    [[nodiscard]] bool watches(std::int64_t number) const { return m_planned.contains(number); }
    [[nodiscard]] Planned of(std::int64_t number, UtcTime highest) const
    {
        const auto [begin, end] = m_planned.equal_range(number);
        const auto found =
            std::find_if(begin, end, [&](const auto& one) { return isSameMoment(one.second.highest, highest); });
        return found == end ? Planned{} : found->second;
    }

private:
    void add(const schedule::WatchedPass& pass, PassPlan plan, const std::vector<passes::Stretch>& tracked)
    {
        m_planned.emplace(pass.number, Planned{.highest = pass.pass.tca.utc, .plan = plan, .tracked = tracked});
    }

    std::multimap<std::int64_t, Planned> m_planned;
};

}  // namespace

Timeline timelineOf(const PassTable& passes, const orbit::SatelliteMarks& marks, const schedule::NightPlan& plan)
{
    const PlanIndex index(plan);
    const auto rankOf = [&](std::int64_t number) {
        return orbit::isFavourite(marks, number) ? 0 : index.watches(number) ? 1 : 2;
    };
    struct Found
    {
        std::size_t satellite = 0;  // index in the book
        std::int64_t number = 0;
        int rank = 0;
    };
    std::vector<Found> found;
    std::unordered_map<std::size_t, std::vector<int>> rowsOf;  // rows of the table, by index of the satellite
    for (int row = 0; row < passes.rowCount(); ++row) {
        const BookedPass& one = passes.pass(row);
        std::vector<int>& rows = rowsOf[one.satellite];
        if (rows.empty()) {
            const std::int64_t number = passes.book()->elementsOf(one).number;
            found.push_back({.satellite = one.satellite, .number = number, .rank = rankOf(number)});
        }
        rows.push_back(row);
    }
    std::ranges::stable_sort(found, {}, &Found::rank);
    Timeline timeline;
    for (const Found& satellite : found) {
        if (timeline.rows.size() == kMostTimelineRows) {
            timeline.leftOut = found.size() - kMostTimelineRows;
            break;
        }
        TimelineRow row{.number = satellite.number,
                        .name = targets::satelliteName(passes.book()->satellites->at(satellite.satellite)),
                        .isFavourite = satellite.rank == 0,
                        .bars = {}};
        for (const int at : rowsOf[satellite.satellite]) {
            const passes::Pass& pass = passes.pass(at).pass;
            PlanIndex::Planned planned = index.of(satellite.number, pass.tca.utc);
            row.bars.push_back({.rises = pass.aos.utc,
                                .highest = pass.tca.utc,
                                .sets = pass.los.utc,
                                .elevation = pass.tca.direction.elevation,
                                .plan = planned.plan,
                                .tracked = std::move(planned.tracked)});
        }
        timeline.rows.push_back(std::move(row));
    }
    return timeline;
}

}  // namespace boresight::ui
