// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sky/region_edit.h"

#include "core/pointing/skyline.h"

#include <gtest/gtest.h>

namespace boresight::ui {
namespace {

using pointing::HorizonPoint;
using pointing::KeepOut;
using pointing::Region;

constexpr Travel kTravel{{-90_deg, 450_deg}, {0_deg, 90_deg}};
const SkyProjection kSky{QPointF(250, 250), 225.0};  // 2.5 px per degree
constexpr double kReach = 8.0;

Region sample()
{
    Region region;
    region.horizon = {{30_deg, 10_deg}, {100_deg, 20_deg}, {200_deg, 15_deg}};
    region.keepOuts = {{"mast", 350_deg, 10_deg, 30_deg, 50_deg}};
    return region;
}

std::optional<Grip> at(const Region& region, Angle azimuth, Angle elevation)
{
    return gripAt(region, kTravel, kSky, kSky.toPixel({azimuth, elevation}), kReach);
}

Region dragged(const Region& region, const Grip& grip, SkyPointing from, SkyPointing to, Angle snap = 0.5_deg)
{
    return RegionDrag(region, kTravel, grip, from).to(to, snap);
}

// REQ-UI-21 (RegionGrip.*)
TEST(RegionGrip, FindsEveryPartWhereItIsDrawn)
{
    const Region region = sample();
    EXPECT_EQ(at(region, 100_deg, 20_deg), (Grip{RegionPart::HorizonPoint, 1}));
    EXPECT_EQ(at(region, 0_deg, 40_deg), (Grip{RegionPart::KeepOut, 0, {true, true, true, true}}));
    EXPECT_EQ(at(region, 350_deg, 40_deg), (Grip{RegionPart::KeepOut, 0, {.from = true}}));
    EXPECT_EQ(at(region, 10_deg, 40_deg), (Grip{RegionPart::KeepOut, 0, {.to = true}}));
    EXPECT_EQ(at(region, 0_deg, 30_deg), (Grip{RegionPart::KeepOut, 0, {.min = true}}));
    EXPECT_EQ(at(region, 0_deg, 50_deg), (Grip{RegionPart::KeepOut, 0, {.max = true}}));
    EXPECT_EQ(at(region, 350_deg, 50_deg), (Grip{RegionPart::KeepOut, 0, {.from = true, .max = true}}));
    EXPECT_EQ(at(region, 10_deg, 30_deg), (Grip{RegionPart::KeepOut, 0, {.to = true, .min = true}}));
    EXPECT_EQ(at(region, 150_deg, 0_deg), (Grip{RegionPart::ElevationMin}));
    EXPECT_EQ(at(region, 150_deg, 90_deg), (Grip{RegionPart::ElevationMax}));
    EXPECT_EQ(at(region, 150_deg, 60_deg), std::nullopt);
}

TEST(RegionGrip, AnAzimuthLimitIsTakenAtTheRimWhileTheWholeCircleIsPermitted)
{
    const Region region = sample();
    EXPECT_EQ(at(region, 270_deg, 5_deg), (Grip{RegionPart::AzimuthMin}));  // -90°
    EXPECT_EQ(at(region, 90_deg, 5_deg), (Grip{RegionPart::AzimuthMax}));   // 450°
    EXPECT_EQ(at(region, 270_deg, 40_deg), std::nullopt);
    Region narrow = region;
    narrow.azimuth = {40_deg, 300_deg};
    EXPECT_EQ(at(narrow, 300_deg, 40_deg), (Grip{RegionPart::AzimuthMax}));
}

TEST(RegionGrip, OfTwoAzimuthLimitsInOneDirectionThePermittedSideTells)
{
    Region region;
    region.azimuth = {0_deg, 360_deg};
    EXPECT_EQ(at(region, 1_deg, 5_deg), (Grip{RegionPart::AzimuthMin}));
    EXPECT_EQ(at(region, 359_deg, 5_deg), (Grip{RegionPart::AzimuthMax}));
}

// REQ-UI-21 (RegionDrag.*)
TEST(RegionDrag, AnAzimuthLimitKeepsItsTurnAndStopsAtTheTravel)
{
    const Region region = sample();
    const Grip max{RegionPart::AzimuthMax};
    EXPECT_EQ(dragged(region, max, {90_deg, 5_deg}, {60.2_deg, 3_deg}).azimuth.max, 420_deg);
    EXPECT_EQ(dragged(region, max, {90_deg, 5_deg}, {120_deg, 3_deg}).azimuth.max, 450_deg);
    // Back through north in steps, as a hand drags.
    RegionDrag drag(region, kTravel, max, {90_deg, 5_deg});
    Region now;
    for (const Angle azimuth : {30_deg, 350_deg, 300_deg}) {
        now = drag.to({azimuth, 5_deg}, 0.5_deg);
    }
    EXPECT_EQ(now.azimuth.max, 300_deg);
    EXPECT_EQ(now.azimuth.min, region.azimuth.min);
}

TEST(RegionDrag, ElevationLimitsDoNotCross)
{
    const Region region = sample();
    EXPECT_EQ(dragged(region, {RegionPart::ElevationMin}, {50_deg, 0_deg}, {50_deg, 7.3_deg}).elevation.min, 7.5_deg);
    Region flat = region;
    flat.elevation = {10_deg, 20_deg};
    EXPECT_EQ(dragged(flat, {RegionPart::ElevationMax}, {50_deg, 20_deg}, {50_deg, 3_deg}).elevation.max, 10.5_deg);
}

TEST(RegionDrag, ShiftDrawsFiner)
{
    const Grip point{RegionPart::HorizonPoint, 0};
    const SkyPointing to{31.26_deg, 12.34_deg};
    EXPECT_EQ(dragged(sample(), point, {30_deg, 10_deg}, to).horizon[0], (HorizonPoint{31.5_deg, 12.5_deg}));
    EXPECT_EQ(dragged(sample(), point, {30_deg, 10_deg}, to, 0.1_deg).horizon[0], (HorizonPoint{31.3_deg, 12.3_deg}));
}

TEST(RegionDrag, AHorizonPointPassesOthersAndNorthAndKeepsTheOrder)
{
    RegionDrag drag(sample(), kTravel, {RegionPart::HorizonPoint, 0}, {30_deg, 10_deg});
    Region now = drag.to({150_deg, 10_deg}, 0.5_deg);
    EXPECT_EQ(drag.grip().index, 1u);
    EXPECT_EQ(now.horizon[1], (HorizonPoint{150_deg, 10_deg}));
    now = drag.to({350_deg, 10_deg}, 0.5_deg);
    EXPECT_EQ(drag.grip().index, 2u);
    EXPECT_EQ(now.horizon[2].azimuth, 350_deg);
    now = drag.to({100_deg, 30_deg}, 0.5_deg);  // already used: the azimuth stays, because each is allowed once
    EXPECT_EQ(now.horizon.size(), 3u);
    EXPECT_EQ(now.horizon[0].azimuth, 30_deg);
    EXPECT_EQ(now.horizon[0].elevation, 30_deg);
}

TEST(RegionDrag, SidesAndWholeOfAKeepOut)
{
    const auto drag = [](KeepOutSides sides, SkyPointing to) {
        return dragged(sample(), {RegionPart::KeepOut, 0, sides}, {0_deg, 40_deg}, to).keepOuts[0];
    };
    EXPECT_EQ(drag({.from = true}, {350_deg, 45_deg}), (KeepOut{"mast", 340_deg, 10_deg, 30_deg, 50_deg}));
    EXPECT_EQ(drag({.to = true, .max = true}, {20_deg, 45_deg}), (KeepOut{"mast", 350_deg, 30_deg, 30_deg, 55_deg}));
    EXPECT_EQ(drag({true, true, true, true}, {90_deg, 30_deg}), (KeepOut{"mast", 80_deg, 100_deg, 20_deg, 40_deg}));
    EXPECT_EQ(drag({true, true, true, true}, {0_deg, 90_deg}).elevationMax, 90_deg);
    // Made as narrow as possible it stays half a degree wide, in whatever direction the drag continues.
    EXPECT_EQ(drag({.to = true}, {300_deg, 40_deg}).azimuthTo, 350.5_deg);
    EXPECT_EQ(drag({.min = true}, {0_deg, 85_deg}).elevationMin, 49.5_deg);
}

TEST(RegionEdit, AddsWithFreeAzimuthsAndNamesAndRemoves)
{
    Region region = sample();
    EXPECT_EQ(addHorizonPoint(region, kTravel, {100.1_deg, 5_deg}), 2u);
    EXPECT_EQ(region.horizon[2], (HorizonPoint{100.5_deg, 5_deg}));
    EXPECT_EQ(addKeepOut(region, {5_deg, 85_deg}), 1u);
    EXPECT_EQ(addKeepOut(region, {5_deg, 3_deg}), 2u);
    EXPECT_EQ(region.keepOuts[1], (KeepOut{"keep-out 1", 355_deg, 15_deg, 70_deg, 90_deg}));
    EXPECT_EQ(region.keepOuts[2], (KeepOut{"keep-out 2", 355_deg, 15_deg, 0_deg, 20_deg}));
    remove(region, {RegionPart::KeepOut, 1});
    remove(region, {RegionPart::HorizonPoint, 2});
    remove(region, {RegionPart::ElevationMin});
    EXPECT_EQ(region.keepOuts.size(), 2u);
    EXPECT_EQ(region.keepOuts[1].name, "keep-out 2");
    EXPECT_EQ(region.horizon, sample().horizon);
}

Angle heightAt(const Region& region, Angle azimuth)
{
    return pointing::Skyline(region.horizon).at(azimuth);
}

// Story: the first point of a horizon raised it all round, and the park position was below it.
// REQ-UI-710: A new point of a level horizon changes it only within 15°. A sky without a horizon is level at 0°, or at
// the lowest elevation that the beam can reach.
TEST(RegionEdit, AFirstHorizonPointIsAHill)
{
    Region region;
    const std::size_t peak = addHorizonPoint(region, kTravel, {180_deg, 14.5_deg});
    EXPECT_EQ(region.horizon, (std::vector<HorizonPoint>{{165_deg, 0_deg}, {180_deg, 14.5_deg}, {195_deg, 0_deg}}));
    EXPECT_EQ(peak, 1U);
    for (const Angle azimuth : {0_deg, 90_deg, 160_deg, 200_deg, 300_deg}) {
        EXPECT_EQ(heightAt(region, azimuth), 0_deg);
    }
    // The next hill does not touch the first one.
    addHorizonPoint(region, kTravel, {5_deg, 20_deg});
    EXPECT_EQ(region.horizon.size(), 6U);
    EXPECT_EQ(heightAt(region, 5_deg), 20_deg);
    EXPECT_EQ(heightAt(region, 350_deg), 0_deg);
    EXPECT_EQ(heightAt(region, 100_deg), 0_deg);
    EXPECT_EQ(heightAt(region, 180_deg), 14.5_deg);
}

// REQ-UI-710
TEST(RegionEdit, AHorizonPointOnASlopeOrBesideAnotherAddsNoFeet)
{
    Region region;
    addHorizonPoint(region, kTravel, {180_deg, 20_deg});
    EXPECT_EQ(addHorizonPoint(region, kTravel, {170_deg, 18_deg}), 1U);
    EXPECT_EQ(region.horizon.size(), 4U);
    addHorizonPoint(region, kTravel, {200_deg, 10_deg});  // 5° beside the foot at 195°
    EXPECT_EQ(region.horizon.size(), 6U);
    EXPECT_EQ(heightAt(region, 215_deg), 0_deg);
    EXPECT_EQ(heightAt(region, 195_deg), 0_deg);
}

// REQ-UI-710
TEST(RegionEdit, AFirstHorizonPointLeavesWhatTheBeamReachesBelowZero)
{
    Region region;
    addHorizonPoint(region, {{-90_deg, 450_deg}, {-5.5_deg, 90_deg}}, {180_deg, 20_deg});
    EXPECT_EQ(heightAt(region, 0_deg), -6_deg);
    Region limited;
    limited.elevation.min = 10_deg;
    addHorizonPoint(limited, kTravel, {180_deg, 20_deg});
    EXPECT_EQ(heightAt(limited, 0_deg), 0_deg);
    const Travel leaning{kTravel.azimuth, kTravel.elevation, pointing::PointingModel({.tiltNorth = 0.6_deg})};
    Region tilted;
    addHorizonPoint(tilted, leaning, {90_deg, 20_deg});
    EXPECT_EQ(heightAt(tilted, 270_deg), -1_deg) << "the axes at 0° look below the horizon on one side";
}

TEST(RegionEdit, SaysWhatIsHeld)
{
    EXPECT_EQ(describe(sample(), kTravel, {RegionPart::AzimuthMax}), QStringLiteral("azimuth axis limit\nto 450.0°"));
    EXPECT_EQ(describe(sample(), kTravel, {RegionPart::HorizonPoint, 1}),
              QStringLiteral("horizon\naz 100.0°\nel 20.0°"));
    EXPECT_EQ(describe(sample(), kTravel, {RegionPart::KeepOut, 0}),
              QStringLiteral("mast\naz 350.0°…10.0°\nel 30.0°…50.0°"));
}

// On a mount that does not know north, limits are drawn and dragged where the beam points.
// REQ-UI-39
TEST(RegionDrag, LimitsOfAMountThatLeansAreHeldWhereTheyLook)
{
    const pointing::PointingModel model(
        {.azimuthOffset = 37.4_deg, .elevationOffset = 1_deg, .tiltNorth = 0.6_deg, .collimation = 0.3_deg});
    const Travel leaning{kTravel.azimuth, kTravel.elevation, model};
    Region region = sample();
    region.azimuth = {40_deg, 300_deg};
    const auto grip = [&](const SkyPointing& beam) {
        return gripAt(region, leaning, kSky, kSky.toPixel(beam), kReach);
    };
    EXPECT_EQ(grip(model.toSky({300_deg, 60_deg})), (Grip{RegionPart::AzimuthMax}));
    EXPECT_EQ(grip(model.toSky({40_deg, 60_deg})), (Grip{RegionPart::AzimuthMin}));
    EXPECT_EQ(grip({300_deg, 60_deg}), std::nullopt);
    EXPECT_EQ(grip(model.toSky({150_deg, 0_deg})), (Grip{RegionPart::ElevationMin}));
    const auto drag = [&](RegionPart part, const AxisPosition& from, const AxisPosition& to) {
        return RegionDrag(region, leaning, {part}, model.toSky(from)).to(model.toSky(to), 0.5_deg);
    };
    EXPECT_EQ(drag(RegionPart::AzimuthMax, {300_deg, 40_deg}, {280.1_deg, 70_deg}).azimuth.max, 280_deg);
    EXPECT_EQ(drag(RegionPart::AzimuthMin, {40_deg, 40_deg}, {60.1_deg, 20_deg}).azimuth.min, 60_deg);
    EXPECT_EQ(drag(RegionPart::ElevationMin, {50_deg, 0_deg}, {80_deg, 7.3_deg}).elevation.min, 7.5_deg);
    // A point of the horizon is a true direction.
    const Grip point{RegionPart::HorizonPoint, 0};
    EXPECT_EQ(RegionDrag(region, leaning, point, {30_deg, 10_deg}).to({40.1_deg, 12.1_deg}, 0.5_deg).horizon[0],
              (HorizonPoint{40_deg, 12_deg}));
    EXPECT_EQ(describe(region, leaning, {RegionPart::AzimuthMax}),
              QStringLiteral("azimuth axis limit\nto 300.0°\nof the axis"));
}

}  // namespace
}  // namespace boresight::ui
