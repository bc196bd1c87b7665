// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sky/sky_beam.h"

#include "tests/ui/sample_status.h"
#include "ui/sky/polar_plot.h"

#include <gtest/gtest.h>

namespace boresight::ui {
namespace {

using namespace std::chrono_literals;

const SkyProjection kBeamSky{.zenith = {200.0, 200.0}, .radius = 180.0};
const UtcTime kBeamBegin{std::chrono::sys_days{std::chrono::year{2026} / 3 / 1} + 5h};

// Along 60° of elevation through north, 1° of azimuth each second. From 20 s to 40 s the beam is 3° from the target.
plan::PlanVariant rampOfTwentySeconds()
{
    plan::PlanVariant variant;
    for (int i = 0; i <= 60; ++i) {
        const bool isApart = i >= 20 && i < 40;
        variant.moments.push_back({.utc = kBeamBegin + i * 1s,
                                   .axes = {Angle::fromDegrees(330.0 + i), 60_deg},
                                   .error = isApart ? 3_deg : Angle::fromDegrees(0.02)});
    }
    return variant;
}

// REQ-PASSES-16: The sky shows the planned beam as a dashed line beside the path of the satellite, only where both are
// more than half a degree apart and only the part that is still to come: for the variant that is selected, and for the
// plan of the tracked pass. The legend names the line.
TEST(SkyBeam, HasOnlyThePartsBesideTheTarget)
{
    const PlannedBeam beam = beamOf(rampOfTwentySeconds(), {});
    ASSERT_TRUE(beam);
    SkyBeam line;
    line.setSky(kBeamSky);
    EXPECT_FALSE(line.show(beam, kBeamBegin).isEmpty());
    const QRectF box = line.line().boundingRect();
    EXPECT_NEAR(box.left(), kBeamSky.toPixel({350_deg, 60_deg}).x(), 0.5);
    EXPECT_NEAR(box.right(), kBeamSky.toPixel({10_deg, 60_deg}).x(), 0.5);
    EXPECT_FALSE(line.show(beam, kBeamBegin + 30s).isEmpty());
    EXPECT_GT(line.line().boundingRect().left(), box.left() + 5.0) << "what is to come";
    EXPECT_FALSE(line.show(beam, kBeamBegin + 50s).isEmpty());
    EXPECT_TRUE(line.line().isEmpty());
    EXPECT_TRUE(line.show(beam, kBeamBegin + 55s).isEmpty()) << "nothing to be painted";
}

TEST(SkyBeam, ABeamAtTheTargetHasNoLine)
{
    plan::PlanVariant variant = rampOfTwentySeconds();
    for (plan::PlannedMoment& moment : variant.moments) {
        moment.error = Angle::fromDegrees(0.4);
    }
    EXPECT_FALSE(beamOf(variant, {}));
    variant.moments.back().error = 1_deg;
    ASSERT_TRUE(beamOf(variant, {})) << "it waits until the end";
}

// Over the top the beam is drawn at its place in the sky.
TEST(SkyBeam, IsUpright)
{
    plan::PlanVariant variant = rampOfTwentySeconds();
    for (plan::PlannedMoment& moment : variant.moments) {
        moment.axes = {moment.axes.azimuth - 180_deg, 180_deg - moment.axes.elevation};
    }
    const PlannedBeam beam = beamOf(variant, {});
    ASSERT_TRUE(beam);
    EXPECT_NEAR((*beam)[1].direction.azimuth.degrees(), 350.0, 1e-6);
    EXPECT_NEAR((*beam)[1].direction.elevation.degrees(), 60.0, 1e-6);
}

// REQ-PASSES-16
TEST(SkyBeam, ThePlotShowsThePlanOfTheTrackedPassAndTheSelectedOne)
{
    RequestDesk desk;
    ProfileDraft draft(desk);
    PolarPlot plot(draft, desk);
    plot.resize(500, 520);
    StationStatus status = samples::tracking(60.0);
    status.utc = kBeamBegin;
    status.tracked = TrackedTarget{.name = QStringLiteral("ISS"),
                                   .plan = std::make_shared<const plan::PlanVariant>(rampOfTwentySeconds())};
    plot.showStatus(status);
    EXPECT_FALSE(plot.markers().paths().trackedBeam().line().isEmpty());
    EXPECT_TRUE(plot.markers().paths().chosenBeam().line().isEmpty());
    const QImage withBeam = plot.markers().ground().toImage();
    status.tracked.reset();
    plot.showStatus(status);
    EXPECT_TRUE(plot.markers().paths().trackedBeam().line().isEmpty());
    EXPECT_NE(plot.markers().ground().toImage(), withBeam) << "the legend";
    plot.setChosenBeam(beamOf(rampOfTwentySeconds(), {}));
    plot.showStatus(status);
    EXPECT_FALSE(plot.markers().paths().chosenBeam().line().isEmpty());
}

}  // namespace
}  // namespace boresight::ui
