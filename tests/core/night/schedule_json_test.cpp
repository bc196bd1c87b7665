// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/night/schedule_json.h"

#include <QJsonDocument>

#include <gtest/gtest.h>

namespace boresight {
namespace {

using namespace std::chrono_literals;

std::string lineOf(const schedule::PassMoment& moment)
{
    return QJsonDocument(momentObject(moment, QStringLiteral("roof"), true))
        .toJson(QJsonDocument::Compact)
        .toStdString();
}

// REQ-HOOKS-13: The facts of a moment are the event, the time, the mount, whether it is simulated, the satellite with
// its number and priority, AOS, LOS and largest elevation of the pass, how the pass ended and why. A fact that does not
// apply is null.
TEST(MomentObject, HasAllFacts)
{
    const UtcTime begin = std::chrono::sys_days{std::chrono::year{2026} / 11 / 21};
    schedule::WatchedPass pass{.number = 25544, .priority = 2, .name = QStringLiteral("ISS")};
    pass.pass.aos.utc = begin + 10s;
    pass.pass.los.utc = begin + 400s;
    pass.pass.tca.direction.elevation = 45.26_deg;
    EXPECT_EQ(lineOf({.moment = schedule::Moment::Aos, .utc = begin, .pass = pass}),
              R"({"aos_utc":"2026-11-21T00:00:10Z","end":null,"event":"aos","los_utc":"2026-11-21T00:06:40Z",)"
              R"("max_el":45.3,"mount":"roof","norad":25544,"priority":2,"satellite":"ISS","simulated":true,)"
              R"("utc":"2026-11-21T00:00:00Z","why":null})");
    EXPECT_EQ(lineOf({.moment = schedule::Moment::Fault, .utc = begin, .pass = {}, .why = QStringLiteral("no reply")}),
              R"({"aos_utc":null,"end":null,"event":"fault","los_utc":null,"max_el":null,"mount":"roof","norad":null,)"
              R"("priority":null,"satellite":null,"simulated":true,"utc":"2026-11-21T00:00:00Z","why":"no reply"})");
    const std::string ended = lineOf({.moment = schedule::Moment::Los,
                                      .utc = begin,
                                      .pass = pass,
                                      .end = schedule::PassEnd::Manual,
                                      .why = QStringLiteral("STOP")});
    EXPECT_NE(ended.find(R"("end":"manual","event":"los")"), std::string::npos) << ended;
}

// REQ-SCHEDULE-908: Of a pass that is tracked in part the plan shows the times of this part, and the conflict shows the
// same part beside what was chosen.
TEST(PlanJson, ShowsThePartOfAPass)
{
    const UtcTime begin = std::chrono::sys_days{std::chrono::year{2026} / 11 / 21};
    schedule::WatchedPass whole{.number = 25544, .name = QStringLiteral("ISS")};
    whole.pass.aos.utc = begin;
    whole.pass.los.utc = begin + 600s;
    schedule::WatchedPass part = whole;
    part.rest = passes::Stretch{.from = begin + 400s, .to = begin + 600s};
    ScheduleStatus status;
    status.plan.chosen = {part};
    status.plan.conflicts = {{.leftOut = whole, .chosen = whole, .rests = {*part.rest}}};
    const std::string json = planJson(status).toStdString();
    EXPECT_NE(json.find(R"("passes":[{"aos_utc":"2026-11-21T00:06:40Z","los_utc":"2026-11-21T00:10:00Z",)"
                        R"("max_el":0,"name":"ISS","norad":25544,"part":true,"priority":1}])"),
              std::string::npos)
        << json;
    EXPECT_NE(json.find(R"("tracked":[{"from_utc":"2026-11-21T00:06:40Z","to_utc":"2026-11-21T00:10:00Z"}])"),
              std::string::npos)
        << json;
    EXPECT_NE(json.find(R"("left_out":{"aos_utc":"2026-11-21T00:00:00Z")"), std::string::npos) << json;
}

}  // namespace
}  // namespace boresight
