// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sky/sky_path.h"

#include "tests/ui/sample_status.h"
#include "tests/ui/sky/expect_near.h"
#include "ui/sky/polar_plot.h"

#include <gtest/gtest.h>

namespace boresight::ui {
namespace {

using namespace std::chrono_literals;

const SkyProjection kPathSky{.zenith = {200.0, 200.0}, .radius = 180.0};
const UtcTime kPathBegin{std::chrono::sys_days{std::chrono::year{2026} / 3 / 1} + 5h + 10min + 30s};

// From the west horizon over the zenith to the east horizon in this time, hidden below 30° in the east.
targets::SkyWay overTheZenith(UtcTime::duration length)
{
    constexpr int kParts = 36;
    auto way = std::make_shared<std::vector<targets::SkyMoment>>();
    for (int i = 0; i <= kParts; ++i) {
        const Angle along = Angle::fromDegrees(5.0 * i);
        const bool east = along > 90_deg;
        way->push_back({.utc = kPathBegin + length * i / kParts,
                        .direction = {.azimuth = east ? 90_deg : 270_deg, .elevation = east ? 180_deg - along : along},
                        .isHidden = along > 150_deg});
    }
    return way;
}

// REQ-PASSES-953: The plot shows the path of the tracked target and of the selected pass: with a dot at each whole
// minute, or each hour of a long path, the times of both ends, and dotted where the limits hide it. The past part is
// not shown.
TEST(SkyPath, HasADotAtEachWholeMinuteAndTheTimesOfItsEnds)
{
    SkyPath path;
    path.setSky(kPathSky);
    EXPECT_FALSE(path.show(overTheZenith(9min), kPathBegin - 1min).isEmpty());
    ASSERT_EQ(path.dots().size(), 9U);
    EXPECT_NEAR(path.dots().front().x(), 20.0 + 360.0 * 0.5 / 9.0, 0.5);
    EXPECT_NEAR(path.dots().back().x(), 20.0 + 360.0 * 8.5 / 9.0, 0.5);
    ASSERT_EQ(path.ends().size(), 2U);
    EXPECT_TRUE(path.ends().front().isBegin);
    EXPECT_EQ(path.ends().front().time.toStdString(), "05:10");
    EXPECT_EQ(path.ends().back().time.toStdString(), "05:19");
    EXPECT_NEAR(path.ends().front().pixel.x(), 20.0, 0.5);
    EXPECT_NEAR(path.ends().back().pixel.x(), 380.0, 0.5);
    EXPECT_NEAR(path.clear().boundingRect().right(), 320.0, 0.5);
    EXPECT_NEAR(path.hidden().boundingRect().left(), 320.0, 0.5);
    EXPECT_NEAR(path.hidden().boundingRect().right(), 380.0, 0.5);
}

TEST(SkyPath, ShowsOnlyWhatIsToCome)
{
    SkyPath path;
    path.setSky(kPathSky);
    const targets::SkyWay way = overTheZenith(9min);
    EXPECT_FALSE(path.show(way, kPathBegin + 4min + 31s).isEmpty());
    ASSERT_EQ(path.ends().size(), 1U) << "it has risen";
    EXPECT_FALSE(path.ends().front().isBegin);
    EXPECT_NEAR(path.clear().boundingRect().left(), 210.0, 0.5);
    EXPECT_EQ(path.dots().size(), 4U);
    EXPECT_TRUE(path.show(way, kPathBegin + 4min + 32s).isEmpty()) << "nothing to be painted";
    EXPECT_FALSE(path.show(way, kPathBegin + 9min).isEmpty());
    EXPECT_TRUE(path.ends().empty());
    EXPECT_TRUE(path.clear().isEmpty());
}

TEST(SkyPath, ALongWayHasADotEachHour)
{
    SkyPath path;
    path.setSky(kPathSky);
    static_cast<void>(path.show(overTheZenith(9h), kPathBegin));
    EXPECT_EQ(path.dots().size(), 9U);
}

// For a path along the horizon as well as for one that rises vertically.
TEST(SkyPath, ATimeStandsBesideTheWayAndNotOnIt)
{
    SkyPath path;
    path.setSky(kPathSky);
    for (const Angle tilt : {0_deg, 30_deg, 60_deg, 90_deg, 150_deg, 240_deg, 300_deg}) {
        auto way = std::make_shared<std::vector<targets::SkyMoment>>();
        for (int i = 0; i <= 60; ++i) {
            way->push_back({.utc = kPathBegin + i * 5s,
                            .direction = {.azimuth = tilt + Angle::fromDegrees(2.0 * i),
                                          .elevation = Angle::fromDegrees(0.02 * i * (60 - i))}});
        }
        static_cast<void>(path.show(way, kPathBegin - 1s));
        for (const SkyPath::End& end : path.ends()) {
            for (const targets::SkyMoment& moment : *way) {
                EXPECT_FALSE(end.text.contains(kPathSky.toPixel(moment.direction))) << tilt.degrees();
            }
        }
    }
}

TEST(SkyPath, NothingIsShownOfNothing)
{
    SkyPath path;
    path.setSky(kPathSky);
    EXPECT_TRUE(path.show(nullptr, kPathBegin).isEmpty());
    EXPECT_FALSE(path.show(overTheZenith(9min), kPathBegin).isEmpty());
    EXPECT_FALSE(path.show(nullptr, kPathBegin).isEmpty()) << "it is taken away";
    EXPECT_TRUE(path.ends().empty());
    EXPECT_TRUE(path.show(std::make_shared<std::vector<targets::SkyMoment>>(), kPathBegin).isEmpty());
}

TEST(SkyPath, ThePlotShowsTheWayOfWhatIsTracked)
{
    RequestDesk desk;
    ProfileDraft draft(desk);
    PolarPlot plot(draft, desk);
    plot.resize(500, 520);
    StationStatus status = samples::tracking(60.0);
    status.utc = kPathBegin + 1min;
    status.tracked = TrackedTarget{
        .name = QStringLiteral("ISS"), .isUp = true, .next = kPathBegin + 9min, .way = overTheZenith(9min)};
    plot.showStatus(status);
    EXPECT_EQ(plot.markers().tracked().ends().size(), 1U);
    status.tracked.reset();
    plot.showStatus(status);
    EXPECT_TRUE(plot.markers().tracked().ends().empty());
}

}  // namespace
}  // namespace boresight::ui
