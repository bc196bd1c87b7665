// SPDX-License-Identifier: GPL-3.0-or-later
// A mount that does not know north. Targets and reported positions are true directions. The axes are driven by axis
// angles.
#include "core/clients/station_rotator.h"
#include "tests/core/control/station_rig.h"
#include "tests/fakes/random_pointing.h"
#include "tests/fakes/text_of.h"

#include <gtest/gtest.h>

namespace boresight {
namespace {

const rotctld::Client kGpredict{.id = 1, .address = "127.0.0.1:50000"};
const pointing::PointingTerms kTerms{.azimuthOffset = 37.4_deg, .tiltNorth = 0.6_deg};

profile::Profile leaning(const pointing::PointingTerms& terms = kTerms,
                         profile::AzimuthConvention convention = profile::AzimuthConvention::ZeroTo360)
{
    profile::Profile profile;
    profile.pointing = terms;
    profile.rotctld.azimuth = convention;
    return profile;
}

struct ModelRig : StationRig
{
    explicit ModelRig(const profile::Profile& settings = leaning()) : StationRig(settings) { run(Seconds(0.2)); }

    Result<QString> pointTo(double trueAzimuth, double trueElevation)
    {
        return rotator.pointTo(
            kGpredict, {.azimuth = Angle::fromDegrees(trueAzimuth), .elevation = Angle::fromDegrees(trueElevation)});
    }
    void apply(const pointing::PointingTerms& terms)
    {
        profile.pointing = terms;
        setProfile(profile);
    }
    [[nodiscard]] AxisPosition axes() const
    {
        const StationStatus status = control.status();
        return {*status.azimuth.actual, *status.elevation.actual};
    }
    void expectBeam(double trueAzimuth, double trueElevation, double tolerance = 1e-3)
    {
        const auto told = rotator.position(kGpredict);
        ASSERT_TRUE(told);
        EXPECT_NEAR(told->azimuth.degrees(), trueAzimuth, tolerance);
        EXPECT_NEAR(told->elevation.degrees(), trueElevation, tolerance);
    }

    StationRotator rotator{control, inForce, log, clock};
};

// The mount leans 0.6° to the north. At true azimuth 100° the azimuth axis stands 0.6° sin 100° tan 20° = 0.215°
// farther, and the elevation axis 0.6° cos 100° = -0.104° lower.
// REQ-CONTROL-32 (StationPointingModel.*): Targets, reported positions and displayed directions are true directions.
// Travel, limits, cable, trim, park and journal are axis angles. Applying a pointing model moves nothing. A client's
// stream uses the model from its next target on.
TEST(StationPointingModel, AClientsTargetIsATrueDirection)
{
    ModelRig rig;
    ASSERT_TRUE(rig.pointTo(100, 20));
    rig.settle();
    EXPECT_NEAR(rig.azimuthDegrees(), 62.6 + 0.215, 0.005);
    EXPECT_NEAR(rig.elevationDegrees(), 20.0 - 0.104, 0.005);
    rig.expectBeam(100.0, 20.0);
    const StationStatus status = rig.control.status();
    for (const auto& shown : {status.actual, status.commanded, status.target}) {
        ASSERT_TRUE(shown);
        EXPECT_NEAR(fakes::separation(*shown, {100_deg, 20_deg}), 0.0, 1e-3);
    }
    for (const auto beam : {&BeamAngles::actual, &BeamAngles::commanded, &BeamAngles::target}) {
        ASSERT_TRUE(status.azimuth.beam.*beam && status.elevation.beam.*beam);
        EXPECT_NEAR((status.azimuth.beam.*beam)->degrees(), 100.0, 1e-3);
        EXPECT_NEAR((status.elevation.beam.*beam)->degrees(), 20.0, 1e-3);
    }
    EXPECT_EQ(status.targetText, QStringLiteral("go to 100.00° 20.00°"));
}

TEST(StationPointingModel, TheOperatorsGoToIsATrueDirectionToo)
{
    ModelRig rig;
    ASSERT_TRUE(rig.point(300, 45, kOperator));
    rig.settle();
    EXPECT_NEAR(fakes::separation(*rig.control.status().actual, {300_deg, 45_deg}), 0.0, 1e-3);
    EXPECT_EQ(rig.state(), StationState::Hold);
}

TEST(StationPointingModel, ApplyingOneMovesNothingAndReckonsAnew)
{
    ModelRig rig(leaning({}));
    ASSERT_TRUE(rig.point(100, 20, kOperator));
    rig.settle();
    const AxisPosition before = rig.axes();
    rig.expectBeam(100.0, 20.0);
    rig.apply(kTerms);
    rig.run(Seconds(2.0));
    EXPECT_FALSE(rig.moving());
    EXPECT_NEAR(rig.axes().azimuth.degrees(), before.azimuth.degrees(), 1e-9);
    EXPECT_NEAR(rig.axes().elevation.degrees(), before.elevation.degrees(), 1e-9);
    const SkyPointing beam = pointing::PointingModel(kTerms).toSky(before);
    rig.expectBeam(beam.azimuth.degrees(), beam.elevation.degrees());
    EXPECT_NEAR(fakes::separation(*rig.control.status().target, beam), 0.0, 1e-3);
}

TEST(StationPointingModel, AStreamGoesOnWithTheNewModelFromItsNextPoint)
{
    ModelRig rig(leaning({}));
    double azimuth = 100.0;
    const auto follow = [&](int seconds) {
        for (int i = 0; i < seconds; ++i) {
            azimuth += 0.5;
            ASSERT_TRUE(rig.pointTo(azimuth, 30));
            rig.run(Seconds(1.0));
        }
    };
    ASSERT_TRUE(rig.pointTo(azimuth, 30));
    rig.settle();
    follow(10);
    rig.apply({.azimuthOffset = 3_deg});
    EXPECT_EQ(rig.state(), StationState::Track);
    follow(20);
    EXPECT_EQ(rig.state(), StationState::Track);
    rig.expectBeam(azimuth, 30.0, 0.6);  // one target a second, half a degree apart
    EXPECT_NEAR(rig.azimuthDegrees(), azimuth - 3.0, 0.6);
}

TEST(StationPointingModel, ContinuousClientsCountTheTurnsOn)
{
    ModelRig rig(leaning(kTerms, profile::AzimuthConvention::Continuous));
    EXPECT_NEAR(rig.rotator.limits().minAzimuth.degrees(), -90 + 37.4 - 0.6, 1e-9);
    EXPECT_NEAR(rig.rotator.limits().maxAzimuth.degrees(), 450 + 37.4 + 0.6, 1e-9);
    ASSERT_TRUE(rig.pointTo(100, 20));
    rig.settle();
    rig.expectBeam(100, 20);
    ASSERT_TRUE(rig.pointTo(460, 20));
    rig.settle();
    EXPECT_NEAR(rig.azimuthDegrees(), 422.6 + 0.215, 0.005);
    rig.expectBeam(460, 20);
    ASSERT_TRUE(rig.pointTo(-30, 20));
    rig.settle();
    EXPECT_LT(rig.azimuthDegrees(), 0.0);
    rig.expectBeam(-30, 20);
    double last = -30.0;
    for (double azimuth = -29.0; azimuth <= 400.0; azimuth += 11.0) {
        ASSERT_TRUE(rig.pointTo(azimuth, 20));
        rig.settle();
        const double told = rig.rotator.position(kGpredict)->azimuth.degrees();
        EXPECT_GT(told, last);
        EXPECT_LT(told, last + 20.0);
        last = told;
    }
}

TEST(StationPointingModel, TheOtherConventionsTellTheTrueAzimuth)
{
    for (const auto& [convention, told] : {std::pair{profile::AzimuthConvention::ZeroTo360, 300.0},
                                           std::pair{profile::AzimuthConvention::PlusMinus180, -60.0}}) {
        ModelRig rig(leaning(kTerms, convention));
        ASSERT_TRUE(rig.pointTo(300, 10));
        rig.settle();
        rig.expectBeam(told, 10);
    }
}

// The limits that clients receive are true directions. They include everything that the axes can reach.
TEST(StationPointingModel, LimitsForClientsAreTrueDirections)
{
    const ModelRig rig(leaning({.azimuthOffset = 37.4_deg, .elevationOffset = -1_deg, .tiltEast = 0.5_deg}));
    EXPECT_NEAR(rig.rotator.limits().minElevation.degrees(), -1.5, 1e-9);
    EXPECT_NEAR(rig.rotator.limits().maxElevation.degrees(), 89.5, 1e-9);
    EXPECT_NEAR(rig.rotator.limits().maxAzimuth.degrees(), 450 + 37.4 + 0.5, 1e-9);
    const ModelRig plumb(leaning({.azimuthOffset = 37.4_deg}));
    EXPECT_NEAR(plumb.rotator.limits().maxElevation.degrees(), 90.0, 1e-9);
}

TEST(StationPointingModel, ATrimIsReckonedInTheAxesAndTakenOutOfWhatTheClientIsTold)
{
    ModelRig rig;
    ASSERT_TRUE(rig.pointTo(100, 20));
    rig.settle();
    ASSERT_TRUE(rig.ask(request::Nudge{.azimuth = 1_deg, .elevation = 0_deg}));
    rig.ask(request::GiveAuthority{});
    rig.settle();
    EXPECT_NEAR(rig.azimuthDegrees(), 63.6 + 0.215, 0.005);
    rig.expectBeam(100, 20);
    EXPECT_NEAR(rig.control.status().actual->azimuth.degrees(), 101.0, 0.01);
}

// A mast in the north-west, at 300…330°: the beam stays out of this true direction.
TEST(StationPointingModel, KeepOutsAreTrueDirections)
{
    profile::Profile profile = leaning();
    profile.limits.keepOuts = {
        {.name = "mast", .azimuthFrom = 300_deg, .azimuthTo = 330_deg, .elevationMin = 0_deg, .elevationMax = 40_deg}};
    ModelRig rig(profile);
    const auto refused = rig.point(315, 20, kOperator);
    ASSERT_FALSE(refused);
    EXPECT_NE(textOf(refused.error()).find("315.0° / 20.0° lies in keep-out \"mast\""), std::string::npos)
        << textOf(refused.error());
    ASSERT_TRUE(rig.point(280, 20, kOperator));
    rig.settle();
    ASSERT_TRUE(rig.point(345, 20, kOperator));
    for (int i = 0; i < 3000 && (i < 10 || rig.moving()); ++i) {
        rig.tick();
        const SkyPointing beam = *rig.control.status().commanded;
        EXPECT_FALSE(beam.azimuth > 300_deg && beam.azimuth < 330_deg && beam.elevation < 40_deg);
    }
    EXPECT_NEAR(fakes::separation(*rig.control.status().actual, {345_deg, 20_deg}), 0.0, 1e-3);
}

}  // namespace
}  // namespace boresight
