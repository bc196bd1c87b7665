// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/axis_readout.h"

#include "tests/ui/find_widget.h"
#include "tests/ui/sample_permissions.h"
#include "tests/ui/sample_status.h"
#include "ui/kit/format.h"
#include "ui/kit/value_label.h"
#include "ui/window/error_bar.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace boresight::ui {
namespace {

QString shown(const AxisReadout& readout, const char* name)
{
    return findNamed<ValueLabel>(readout, name)->text();
}

// At axis angles of 62.6° and 20°, on the way to 72.6°.
StationStatus pointed(const pointing::PointingTerms& terms)
{
    StationStatus status = samples::idle();
    auto profile = std::make_shared<profile::Profile>(*status.profile);
    profile->pointing = terms;
    status.profile = profile;
    status.azimuth.actual = 62.6_deg;
    status.azimuth.target = 72.6_deg;
    status.elevation.actual = 20_deg;
    status.elevation.target = 20_deg;
    return samples::judged(status);
}

// REQ-UI-39 (AxisReadout.*): Numbers and plot show true directions. Axis angles (the second line of the readout, cable,
// limits) are marked. Limits are drawn and dragged where the beam points.
TEST(AxisReadout, TheNumbersAreTrueAndTheAxisStandsBelow)
{
    AxisReadout readout;
    readout.showStatus(pointed({.azimuthOffset = 37.4_deg, .elevationOffset = -0.5_deg}));
    EXPECT_EQ(shown(readout, "Actual azimuth"), QStringLiteral("100.00°"));
    EXPECT_EQ(shown(readout, "Target azimuth"), QStringLiteral("110.00°"));
    EXPECT_EQ(shown(readout, "Error of azimuth"), QStringLiteral("+10.00°"));
    EXPECT_TRUE(shown(readout, "Detail of azimuth").contains(QStringLiteral("axis 62.60°")));
    EXPECT_EQ(shown(readout, "Actual elevation"), QStringLiteral("19.50°"));
    EXPECT_TRUE(shown(readout, "Detail of elevation").contains(QStringLiteral("axis 20.00°")));
}

TEST(AxisReadout, WithoutAModelTheAxisIsTheTruth)
{
    AxisReadout readout;
    readout.showStatus(pointed({}));
    EXPECT_EQ(shown(readout, "Actual azimuth"), QStringLiteral("62.60°"));
    EXPECT_FALSE(shown(readout, "Detail of azimuth").contains(QStringLiteral("axis")));
}

// REQ-UI-1754: On an X/Y mount the numbers are those of the beam. X and Y stand below, by name, and error and rate are
// theirs.
TEST(AxisReadout, AnXYMountShowsXAndYBesideTheBeam)
{
    AxisReadout readout;
    StationStatus status = pointed({.geometry = {.kind = pointing::Geometry::XY}});
    status.azimuth.actual = 35.2644_deg;
    status.azimuth.target = 36.2644_deg;
    status.elevation.actual = 30_deg;
    status.elevation.target = 30_deg;
    readout.showStatus(samples::judged(status));
    EXPECT_EQ(shown(readout, "Actual azimuth"), QStringLiteral("45.00°"));
    EXPECT_EQ(shown(readout, "Actual elevation"), QStringLiteral("45.00°"));
    EXPECT_EQ(shown(readout, "Error of azimuth"), QStringLiteral("+1.00°"));
    EXPECT_TRUE(shown(readout, "Detail of azimuth").contains(QStringLiteral("X 35.26°")));
    EXPECT_TRUE(shown(readout, "Detail of elevation").contains(QStringLiteral("Y 30.00°")));
}

// REQ-UI-1004
TEST(AxisReadout, TheNumeralsOfAMountThatStandsDoNotFlip)
{
    AxisReadout readout;
    std::set<std::string> seen;
    for (int i = 0; i < 20; ++i) {
        StationStatus status = pointed({.azimuthOffset = 37.4_deg});
        const Angle noise = i % 2 == 0 ? 0.002_deg : -0.002_deg;
        status.azimuth.target = -37.4_deg;
        status.azimuth.actual = -37.405_deg + noise;
        status.azimuth.rate = AngularRate::fromDegrees(i % 2 == 0 ? 0.036 : -0.036);
        status.elevation.target = 0.0_deg;
        status.elevation.actual = -0.005_deg + noise;
        readout.showStatus(samples::judged(status));
        QStringList all;
        for (const char* const name : {"Actual azimuth", "Error of azimuth", "Rate of azimuth", "Detail of azimuth",
                                       "Actual elevation", "Error of elevation"}) {
            all << shown(readout, name);
        }
        seen.insert(all.join(QLatin1Char(' ')).toStdString());
    }
    EXPECT_EQ(seen.size(), 1U) << *seen.begin() << "\n" << *seen.rbegin();
}

// REQ-MOUNT-03
TEST(AxisReadout, AnAxisThatTheMountDoesNotHaveShowsNoNumbers)
{
    StationStatus status = pointed({});
    status.elevation.state = AxisState::Missing;
    AxisReadout readout;
    readout.showStatus(status);
    EXPECT_EQ(shown(readout, "State of elevation"), QStringLiteral("NONE"));
    EXPECT_EQ(shown(readout, "Actual elevation"), noValue());
    EXPECT_EQ(shown(readout, "Target elevation"), noValue());
    EXPECT_EQ(shown(readout, "Actual azimuth"), QStringLiteral("62.60°"));
}

// REQ-UI-950 (ErrorBar.*): A bar shows the error of each axis in beam widths. Only an unplanned large error has the
// warning colour.
TEST(ErrorBar, IsScaledInBeamWidthsOnTheSky)
{
    StationStatus status = pointed({});
    status.azimuth.target = 64.6_deg;  // 2° of azimuth at 60° elevation are 1° of the sky
    status.elevation.actual = 60_deg;
    status.elevation.target = 57.5_deg;
    status.actual = SkyPointing{62.6_deg, 60_deg};
    auto profile = std::make_shared<profile::Profile>(*status.profile);
    profile->mount.beamWidth = 5_deg;
    status.profile = profile;
    status = samples::judged(status);
    AxisReadout readout;
    readout.showStatus(status);
    EXPECT_NEAR(findNamed<ErrorBar>(readout, "Error bar of azimuth")->error().value(), 0.2, 1e-9);
    EXPECT_NEAR(findNamed<ErrorBar>(readout, "Error bar of elevation")->error().value(), -0.5, 1e-9);
    EXPECT_FALSE(findNamed<ErrorBar>(readout, "Error bar of elevation")->isUnplanned()) << "half a beam width";
}

TEST(ErrorBar, WarnsOfAnErrorThatNobodyPlanned)
{
    StationStatus status = pointed({});
    AxisReadout readout;
    readout.showStatus(status);
    const auto* const bar = findNamed<ErrorBar>(readout, "Error bar of azimuth");
    EXPECT_TRUE(bar->isUnplanned());
    status.slew = SlewProgress{.remaining = Seconds(5.0), .done = 0.5};
    status.azimuth.commanded = status.azimuth.actual;
    readout.showStatus(samples::judged(status));
    EXPECT_FALSE(bar->isUnplanned()) << "on its way";
    status.azimuth.age = std::chrono::milliseconds(700);
    readout.showStatus(samples::judged(status));
    EXPECT_FALSE(bar->error().has_value()) << "an old place is not compared";
}

// REQ-UI-951: The numbers of the axes scale with the window: 44 pt from 1280×760, 60 pt from 1900×1000.
TEST(AxisReadout, TheNumeralsScaleWithTheWindow)
{
    AxisReadout readout;
    const auto points = [&readout](QSize window) {
        readout.setNumerals(numeralsFor(window));
        return findNamed<ValueLabel>(readout, "Actual azimuth")->font().pointSize();
    };
    EXPECT_EQ(points({1024, 700}), 28);
    EXPECT_EQ(points({1280, 800}), 44);
    EXPECT_EQ(points({1920, 1040}), 60);
    EXPECT_EQ(points({1920, 700}), 28);
    EXPECT_FALSE(findNamed<ValueLabel>(readout, "Rate of azimuth")->isVisibleTo(&readout));
}

}  // namespace
}  // namespace boresight::ui
