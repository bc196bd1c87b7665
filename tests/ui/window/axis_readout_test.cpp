// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/axis_readout.h"

#include "tests/ui/find_widget.h"
#include "tests/ui/sample_permissions.h"
#include "tests/ui/sample_status.h"
#include "ui/kit/format.h"
#include "ui/kit/value_label.h"

#include <gtest/gtest.h>

namespace boresight::ui {
namespace {

QString shown(const AxisReadout& readout, const char* name)
{
    return findNamed<ValueLabel>(readout, name)->text();
}

// At 62.6° and 20° of the axes, on the way to 72.6°.
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

// REQ-UI-39 (AxisReadout.*): Numbers and plot show true directions. What counts the axis (the readout's second line,
// cable, limits) says so. Limits are drawn and dragged where the beam looks.
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

}  // namespace
}  // namespace boresight::ui
