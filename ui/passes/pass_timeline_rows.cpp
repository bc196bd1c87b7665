// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/passes/pass_timeline_rows.h"

#include "core/targets/target.h"

#include <algorithm>
#include <map>
#include <unordered_map>

namespace boresight::ui {

namespace {

// The plan by satellite.
class PlanIndex
{
public:
    explicit PlanIndex(const schedule::NightPlan& plan)
    {
        for (const schedule::WatchedPass& pass : plan.chosen) {
            add(pass, PassPlan::Tracked);
        }
        for (const schedule::Conflict& conflict : plan.conflicts) {
            add(conflict.leftOut, PassPlan::LeftOut);
        }
        for (const schedule::WatchedPass& pass : plan.hidden) {
            add(pass, PassPlan::LeftOut);
        }
    }

    [[nodiscard]] bool watches(std::int64_t number) const { return m_moments.contains(number); }
    [[nodiscard]] PassPlan planOf(std::int64_t number, UtcTime highest) const
    {
        const auto [begin, end] = m_moments.equal_range(number);
        const auto found =
            std::find_if(begin, end, [&](const auto& one) { return isSameMoment(one.second.highest, highest); });
        return found == end ? PassPlan::None : found->second.plan;
    }

private:
    struct Moment
    {
        UtcTime highest{};
        PassPlan plan = PassPlan::None;
    };

    void add(const schedule::WatchedPass& pass, PassPlan plan)
    {
        m_moments.emplace(pass.number, Moment{pass.pass.tca.utc, plan});
    }

    std::multimap<std::int64_t, Moment> m_moments;
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
        std::size_t satellite = 0;  // of the book
        std::int64_t number = 0;
        int rank = 0;
    };
    std::vector<Found> found;
    std::unordered_map<std::size_t, std::vector<int>> rowsOf;  // of the table, by satellite
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
            row.bars.push_back({.rises = pass.aos.utc,
                                .highest = pass.tca.utc,
                                .sets = pass.los.utc,
                                .elevation = pass.tca.direction.elevation,
                                .plan = index.planOf(satellite.number, pass.tca.utc)});
        }
        timeline.rows.push_back(std::move(row));
    }
    return timeline;
}

}  // namespace boresight::ui
