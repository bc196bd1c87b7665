// SPDX-License-Identifier: GPL-3.0-or-later
// High passes, and the least possible peak error of two rotors.
#include "core/units/angle_between.h"
#include "tests/core/plan/plan_tables.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace boresight::plan {
namespace {

using namespace std::chrono_literals;

struct Rotor
{
    AxisSpeeds azimuth;
    AxisSpeeds elevation;
};

const std::map<std::string, Rotor> kRotors{{"fast30", {{30.0, 60.0}, {30.0, 60.0}}},
                                           {"yaesu6", {{6.0, 12.0}, {2.5, 5.0}}}};

// What a mount would do that moves by the plan, looked at much more often than the plan has moments.
struct Measured
{
    Angle peak{};
    double azimuthRate = 0.0;  // °/s
    double elevationRate = 0.0;
    double azimuthAcceleration = 0.0;  // °/s²
};

Measured measure(const PlanVariant& variant, const DirectionAt& directionAt)
{
    Measured found;
    constexpr UtcTime::duration kStep = 20ms;
    constexpr double kSeconds = 0.02;
    const UtcTime last = variant.moments.back().utc - kStep;
    for (UtcTime at = variant.moments.front().utc + kStep; at < last; at += kStep) {
        const AxisPosition before = variant.placeAt(at - kStep);
        const AxisPosition here = variant.placeAt(at);
        const AxisPosition after = variant.placeAt(at + kStep);
        found.peak = std::max(found.peak, angleBetween({here.azimuth, here.elevation}, directionAt(at).value()));
        found.azimuthRate =
            std::max(found.azimuthRate, abs(after.azimuth - before.azimuth).degrees() / (2.0 * kSeconds));
        found.elevationRate =
            std::max(found.elevationRate, abs(after.elevation - before.elevation).degrees() / (2.0 * kSeconds));
        found.azimuthAcceleration =
            std::max(found.azimuthAcceleration,
                     abs(after.azimuth - 2.0 * here.azimuth + before.azimuth).degrees() / (kSeconds * kSeconds));
    }
    return found;
}

void expectMeets(const Row& answer, const Row& scenario, const orbit::ElementSet& set)
{
    const Rotor& rotor = kRotors.at(answer.at("rotor"));
    const Angle highest = answer.at("mode") == "opt_el90" ? 90_deg : 180_deg;
    const PlanMount mount = mountWith(rotor.azimuth, rotor.elevation, {-360_deg, 720_deg}, {0_deg, highest});
    const Site site{degrees(scenario, "lat_deg"), degrees(scenario, "lon_deg"), number(scenario, "alt_m")};
    const DirectionAt directionAt = directionsOf(set, site);
    const PassPlan plan = planPass(directionAt,
                                   {.from = utc(scenario, "aos_utc"),
                                    .to = utc(scenario, "los_utc"),
                                    .now = {0_deg, 0_deg},
                                    .bound = 180_deg},  // so that the peak decides
                                   mount);
    ASSERT_FALSE(plan.variants.empty());
    const PlanVariant& best = plan.best();
    const Measured measured = measure(best, directionAt);
    const double optimum = number(answer, "peak_err_deg");
    EXPECT_LE(measured.peak.degrees(), 1.05 * optimum + 0.05) << keyOf(best.way).toStdString();
    EXPECT_NEAR(best.forecast.peak.degrees(), measured.peak.degrees(), 0.03) << "the plan promises what comes";
    EXPECT_LE(measured.azimuthRate, 1.01 * rotor.azimuth.speed);
    EXPECT_LE(measured.elevationRate, 1.01 * rotor.elevation.speed);
    EXPECT_LE(measured.azimuthAcceleration, 1.05 * rotor.azimuth.acceleration);
    testing::Test::RecordProperty(answer.at("id") + answer.at("rotor") + answer.at("mode"),
                                  std::to_string(measured.peak.degrees()));
}

}  // namespace

// REQ-PLAN-01: Through the keyhole the peak error of a plan is within 5 % and 0.05° of the least error that the speeds
// and accelerations of the mount permit, with elevations to 90° and to 180°. The forecast is what a mount does that
// moves by the plan.
TEST(Keyhole, PlansAreAsGoodAsCanBe)
{
    if (!hasTable("TLE_SATS", "tle_sats.txt")) {
        GTEST_SKIP() << "no " << tablePath("TLE_SATS", "tle_sats.txt");
    }
    const auto sets = elementsByName();
    std::map<std::string, Row> scenarios;
    for (const Row& row : tableRows("KEYHOLE_SCENARIOS", "keyhole_scenarios.csv")) {
        scenarios[row.at("id")] = row;
    }
    int met = 0;
    for (const Row& answer : tableRows("KEYHOLE_ANSWERS", "keyhole_answers.csv")) {
        if (!answer.at("mode").starts_with("opt_")) {
            continue;
        }
        SCOPED_TRACE(answer.at("id") + " " + answer.at("rotor") + " " + answer.at("mode"));
        const Row& scenario = scenarios.at(answer.at("id"));
        ASSERT_TRUE(sets.contains(scenario.at("name"))) << scenario.at("name");
        ASSERT_TRUE(kRotors.contains(answer.at("rotor"))) << "its speeds are not known here";
        expectMeets(answer, scenario, sets.at(scenario.at("name")));
        ++met;
    }
    EXPECT_GT(met, 0);
}

}  // namespace boresight::plan
