// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/error_watch.h"

#include "core/elements/julian_date.h"
#include "tests/core/station/moving_station.h"

#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace boresight {
namespace {

using budget::ErrorPart;
using budget::TargetOrigin;

constexpr UtcTime kNow{std::chrono::days(20002)};

// A mount that tracks the ISS by its own orbit, 0.04° behind it in elevation.
StationStatus tracking()
{
    StationStatus status;
    status.state = StationState::Track;
    status.utc = kNow;
    status.aimed = true;
    for (AxisStatus* const axis : {&status.azimuth, &status.elevation}) {
        axis->state = AxisState::Moving;
        axis->age = std::chrono::milliseconds(20);
    }
    status.actual = SkyPointing{120_deg, 59.97_deg};
    status.commanded = SkyPointing{120_deg, 60_deg};
    status.target = SkyPointing{120_deg, 60.04_deg};
    status.commander = {.kind = SourceKind::Operator, .name = QStringLiteral("operator")};
    status.tracked = TrackedTarget{.name = QStringLiteral("ISS"), .number = 25544, .isUp = true, .skyRate = 0.5_deg_s};
    orbit::ElementSet iss{.name = "ISS", .number = 25544};
    iss.epoch = orbit::julianDate(UtcTime(std::chrono::days(20000)));
    iss.revolutionsPerDay = 15.5;
    status.satellites = std::make_shared<const std::vector<orbit::ElementSet>>(std::vector<orbit::ElementSet>{iss});
    status.clock = {.synchronised = true, .error = Seconds(0.1)};
    return status;
}

// REQ-STATION-967: The error budget is made from what the status reports: the target, the clock, the elements by their
// age, the calibration in force, the wind.
TEST(ErrorWatch, TakesTheFactsFromTheStatus)
{
    const auto facts = budgetFacts(tracking(), {});
    ASSERT_TRUE(facts);
    EXPECT_EQ(facts->origin, TargetOrigin::Own);
    EXPECT_NEAR(facts->toTarget.degrees(), 0.04, 1e-9);
    EXPECT_EQ(facts->skyRate, 0.5_deg_s);
    ASSERT_TRUE(facts->elements);
    EXPECT_NEAR(facts->elements->age.count(), 2.0 * 86'400.0, 1.0);
    EXPECT_NEAR(facts->elements->kilometres, 4.0, 0.01);
    EXPECT_TRUE(facts->calibration.points.empty());
    EXPECT_FALSE(facts->calibration.stated);
    EXPECT_EQ(facts->resolution, Angle{});
}

// REQ-STATION-968: Without a direction as the target, and with a position that is older than half a second, there is no
// error budget.
TEST(ErrorWatch, AnOldPositionHasNoBudget)
{
    StationStatus status = tracking();
    status.elevation.age = std::chrono::milliseconds(500);
    EXPECT_FALSE(budgetFacts(status, {}));
    status = tracking();
    status.azimuth.state = AxisState::NoData;
    EXPECT_FALSE(budgetFacts(status, {}));
    status = tracking();
    status.aimed = false;  // a jog, or Park
    EXPECT_FALSE(budgetFacts(status, {}));
    status = tracking();
    status.target.reset();
    EXPECT_FALSE(budgetFacts(status, {}));
    ErrorWatch().fill(status, {}, SteadyTime{});
    EXPECT_FALSE(status.errorBudget);
}

// REQ-STATION-969: The budget knows who computes the target: Boresight, a client by its points, another program, or
// nobody for a fixed direction.
TEST(ErrorWatch, KnowsWhoComputesTheTarget)
{
    StationStatus status = tracking();
    const tracking::StreamError stream{.step = 0.2_deg, .foretold = 0.01_deg};
    status.commander.kind = SourceKind::Client;
    EXPECT_EQ(budgetFacts(status, stream)->origin, TargetOrigin::Own) << "locked to the target of the client";
    status.tracked.reset();
    EXPECT_EQ(budgetFacts(status, stream)->origin, TargetOrigin::Client);
    EXPECT_EQ(budgetFacts(status, {})->origin, TargetOrigin::Fixed) << "one point of a client";
    status.commander.kind = SourceKind::Operator;
    EXPECT_EQ(budgetFacts(status, stream)->origin, TargetOrigin::Fixed);
    status.tracked = TrackedTarget{.name = QStringLiteral("balloon"), .isUp = true};
    EXPECT_EQ(budgetFacts(status, stream)->origin, TargetOrigin::Reported);
    status = tracking();
    status.azel.phase = AzelPhase::Following;
    EXPECT_EQ(budgetFacts(status, {})->origin, TargetOrigin::Reported);
    status.azel.interpolates = true;
    EXPECT_EQ(budgetFacts(status, {})->origin, TargetOrigin::Own);
    status = tracking();
    status.tracked->isUp = false;
    EXPECT_EQ(budgetFacts(status, {})->origin, TargetOrigin::Fixed) << "the mount waits where the target rises";
}

// REQ-STATION-980: The calibration counts with its used points. Without points it counts with the sigmas of the terms
// in force, if that of north is known: an error of north is smaller near the zenith.
TEST(ErrorWatch, TheCalibrationIsThatInForce)
{
    StationStatus status = tracking();
    auto calibration = std::make_shared<CalibrationStatus>();
    calibration->sheet.sigmas[indexOf(calibration::Term::ElevationOffset)] = 0.3_deg;
    status.calibration = calibration;
    EXPECT_FALSE(budgetFacts(status, {})->calibration.stated) << "north is unknown";
    calibration->sheet.sigmas[indexOf(calibration::Term::AzimuthOffset)] = 0.8_deg;
    EXPECT_NEAR(budgetFacts(status, {})->calibration.stated.value().degrees(),
                std::hypot(0.3, 0.8 * std::cos((59.97_deg).radians())), 1e-9);
    calibration->points = {{.sigma = 0.05_deg, .before = {.across = 0.03_deg, .elevation = 0.04_deg}},
                           {.isUsed = false, .before = {.across = 9_deg}}};
    const auto facts = budgetFacts(status, {});
    ASSERT_EQ(facts->calibration.points.size(), 1U);
    EXPECT_NEAR(facts->calibration.points.front().residual.degrees(), 0.05, 1e-9);
    EXPECT_EQ(facts->calibration.points.front().sigma, 0.05_deg);
}

// REQ-STATION-981: In each tick the station measures the angle on the sky between the set-points and the axes. A tick
// without an answer of both axes does not count.
TEST(ErrorWatch, MeasuresTheServoOnTheSky)
{
    ErrorWatch watch;
    const auto sample = [](double seconds, std::optional<Angle> azimuth) {
        TickSample one{.time = SteadyTime{} + std::chrono::milliseconds(std::lround(1e3 * seconds)), .axes = {}};
        one.axes[0].commanded = 120_deg;
        one.axes[0].actual = azimuth;
        one.axes[1].commanded = 60_deg;
        one.axes[1].actual = 60_deg;
        return one;
    };
    watch.keep(sample(0.02, 120.1_deg), {}, {});  // 0.1° of azimuth at 60°
    watch.keep(sample(0.04, {}), {}, {});
    StationStatus status = tracking();
    watch.fill(status, {}, SteadyTime{} + std::chrono::milliseconds(60));
    ASSERT_TRUE(status.errorBudget);
    ASSERT_TRUE(status.errorBudget->lines.front().error);
    EXPECT_NEAR(status.errorBudget->lines.front().error->degrees(), 0.05, 1e-6);
    watch.fill(status, {}, SteadyTime{} + std::chrono::seconds(3));
    EXPECT_FALSE(status.errorBudget->lines.front().error) << "nothing was measured for 2 s";
}

// REQ-STATION-973: While the mount is sent to a direction, each status of the station has the error budget. On the way
// the way counts, at the target only what was measured. After STOP there is no budget.
TEST(ErrorWatch, EachStatusOfAStationHasTheBudget)
{
    const QTemporaryDir folder;
    MovingStation moving(folder.path());
    EXPECT_FALSE(moving.station->status().errorBudget);
    moving.station->request({.id = 1, .request = request::PointSky{{.azimuth = 20_deg, .elevation = 30_deg}}});
    moving.run(Seconds(0.5));
    const auto onTheWay = moving.station->status().errorBudget;
    ASSERT_TRUE(onTheWay);
    EXPECT_GT(onTheWay->sum, 1_deg);
    moving.run(Seconds(40.0));
    const auto there = moving.station->status().errorBudget;
    ASSERT_TRUE(there);
    EXPECT_EQ(there->lines.front().part, ErrorPart::Servo);
    ASSERT_TRUE(there->lines.front().error);
    EXPECT_LT(there->sum, 0.1_deg);
    moving.station->request({.id = 2, .request = request::Stop{}});
    moving.run(Seconds(1.0));
    EXPECT_FALSE(moving.station->status().errorBudget);
}

}  // namespace
}  // namespace boresight
