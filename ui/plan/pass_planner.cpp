// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plan/pass_planner.h"

#include "core/plan/plan_mount.h"
#include "core/targets/target_path.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace boresight::ui {

namespace {

constexpr Angle kSamePlace = Angle::fromDegrees(10.0);

bool isSamePlace(const AxisPosition& one, const AxisPosition& other)
{
    return abs(one.azimuth - other.azimuth) < kSamePlace && abs(one.elevation - other.elevation) < kSamePlace;
}

// The operator reads the variants from above: the best one, and then the others in the order of their loss.
void sortVariants(plan::PassPlan& plan)
{
    const auto best = plan.variants.begin() + static_cast<std::ptrdiff_t>(plan.chosen);
    std::rotate(plan.variants.begin(), best, best + 1);
    plan.chosen = 0;
    std::ranges::stable_sort(plan.variants.begin() + 1, plan.variants.end(), {}, [](const plan::PlanVariant& one) {
        return std::tuple(one.forecast.beyond, one.forecast.peak);
    });
}

}  // namespace

bool isSameQuestion(const PlanQuestion& one, const PlanQuestion& other)
{
    const bool isSameBegin = one.task.begins == plan::Begins::Now || one.task.from == other.task.from;
    return one.target == other.target && one.profile == other.profile && one.antenna == other.antenna &&
           one.task.begins == other.task.begins && isSameBegin && one.task.to == other.task.to &&
           isSamePlace(one.task.now, other.task.now);
}

PlanAnswer answerTo(const PlanQuestion& question)
{
    const profile::Profile& profile = *question.profile;
    const Result<plan::PlanMount> mount = plan::planMount(profile, question.antenna);
    if (!mount) {
        return {.obstacle = mount.error().text};
    }
    targets::TargetPath path(question.target, profile.site.place(), profile.orbit.refraction);
    const auto directionAt = [&path](UtcTime utc) -> std::optional<SkyPointing> {
        const Result<SkyPointing> direction = path.at(utc);
        return direction ? std::optional(SkyPointing{direction->azimuth, std::max(direction->elevation, 0_deg)})
                         : std::nullopt;
    };
    PlanAnswer answer{.plan = plan::planPass(directionAt, question.task, *mount),
                      .azimuths = mount->region.ranges().azimuth,
                      .pointing = mount->pointing};
    if (answer.plan.variants.empty()) {
        answer.obstacle = PassPlanner::tr("The mount reaches no part of this pass.");
    } else {
        sortVariants(answer.plan);
    }
    return answer;
}

PassPlanner::PassPlanner(QObject* parent) : QObject(parent)
{
    m_pool.setMaxThreadCount(1);
    m_pool.setThreadPriority(QThread::LowestPriority);
}

PassPlanner::~PassPlanner()
{
    drop();
    m_pool.waitForDone();
}

void PassPlanner::drop()
{
    m_stop.request_stop();
}

void PassPlanner::plan(const PlanQuestion& question)
{
    drop();
    m_stop = std::stop_source();
    m_pool.start([this, question, stop = m_stop.get_token()] {
        if (stop.stop_requested()) {
            return;
        }
        const auto answer = std::make_shared<const PlanAnswer>(answerTo(question));
        QMetaObject::invokeMethod(this, [this, stop, answer] {
            if (!stop.stop_requested()) {
                Q_EMIT planned(answer);
            }
        });
    });
}

}  // namespace boresight::ui

#include "moc_pass_planner.cpp"
