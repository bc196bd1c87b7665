// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotctl/rotctl_command.h"

#include "core/rotctl/rotctl_error.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

namespace boresight::rotctl {
namespace {

AxisPosition at(double azimuth, double elevation)
{
    return {.azimuth = Angle::fromDegrees(azimuth), .elevation = Angle::fromDegrees(elevation)};
}

// REQ-ROTCTL-01: Each command is one line of the rotctld protocol, in the extended or the plain form. Positions have
// two decimals and a decimal point.
TEST(RotctlCommand, IsALineOfTheProtocol)
{
    EXPECT_EQ(askState(Form::Extended), "+\\dump_state\n");
    EXPECT_EQ(askState(Form::Plain), "\\dump_state\n");
    EXPECT_EQ(askPosition(Form::Extended), "+\\get_pos\n");
    EXPECT_EQ(askPosition(Form::Plain), "p\n");
    EXPECT_EQ(stopAll(Form::Extended), "+\\stop\n");
    EXPECT_EQ(stopAll(Form::Plain), "S\n");
    EXPECT_EQ(resetAll(Form::Extended), "+\\reset 1\n");
    EXPECT_EQ(resetAll(Form::Plain), "R 1\n");
    EXPECT_EQ(goTo(Form::Extended, at(123.4, 45.678)), "+\\set_pos 123.40 45.68\n");
    EXPECT_EQ(goTo(Form::Plain, at(-12.0, -0.001)), "P -12.00 0.00\n");
}

// REQ-ROTCTL-02: A position that no rotator can reach, or that is not a number, is never sent and never clipped.
TEST(RotctlCommand, APlaceThatIsNoneIsNoCommand)
{
    EXPECT_TRUE(goTo(Form::Plain, at(-720.0, 360.0)));
    for (const double odd :
         {1e6, -721.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        EXPECT_FALSE(goTo(Form::Extended, at(odd, 10.0))) << odd;
        EXPECT_FALSE(goTo(Form::Plain, at(10.0, odd))) << odd;
    }
}

// REQ-ROTCTL-08: Each error of Hamlib has a text with its number.
TEST(RotctlError, HasWordsAndItsNumber)
{
    std::set<QString> texts;
    for (int code = -1; code >= -30; --code) {
        const QString text = errorInWords(code);
        EXPECT_TRUE(text.endsWith(QStringLiteral(" (RPRT %1)").arg(code))) << text.toStdString();
        texts.insert(text);
    }
    EXPECT_EQ(texts.size(), 30U);
    EXPECT_EQ(errorInWords(-5), QStringLiteral("the rotator did not answer rotctld in time (RPRT -5)"));
    EXPECT_TRUE(isUnavailable(-11));
    EXPECT_FALSE(isUnavailable(-5));
}

}  // namespace
}  // namespace boresight::rotctl
