// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plan/plan_pass.h"
#include "core/pointing/antenna.h"
#include "core/pointing/pointing_model.h"
#include "core/profile/profile.h"
#include "core/targets/target.h"

#include <QObject>
#include <QString>
#include <QThreadPool>

#include <memory>
#include <stop_token>

// Plans one pass on another thread, with the lowest priority. A plan takes some milliseconds, and up to a second for a
// pass through the keyhole. A new question drops the previous one. The answer arrives on the gui thread. Gui thread.
namespace boresight::ui {

struct PlanQuestion
{
    targets::Target target;
    plan::PlanTask task;
    std::shared_ptr<const profile::Profile> profile;
    pointing::Antenna antenna;
};

// Whether both have the same answer. The beginning of a pass that is up already does not count, because it moves on. A
// place of the axes within some degrees is the same place.
[[nodiscard]] bool isSameQuestion(const PlanQuestion& one, const PlanQuestion& other);

struct PlanAnswer
{
    plan::PassPlan plan;     // the best variant first
    QString obstacle;        // why there is no plan; empty: there is one
    TravelRange azimuths{};  // the ends of the cable
    pointing::PointingModel pointing;
};

using SharedAnswer = std::shared_ptr<const PlanAnswer>;

// Computes at once. Any thread.
[[nodiscard]] PlanAnswer answerTo(const PlanQuestion& question);

class PassPlanner : public QObject
{
    Q_OBJECT

public:
    explicit PassPlanner(QObject* parent = nullptr);
    ~PassPlanner() override;

    void plan(const PlanQuestion& question);
    void drop();  // no answer arrives any more

Q_SIGNALS:
    void planned(const std::shared_ptr<const boresight::ui::PlanAnswer>& answer);

private:
    QThreadPool m_pool;
    std::stop_source m_stop;
};

}  // namespace boresight::ui
