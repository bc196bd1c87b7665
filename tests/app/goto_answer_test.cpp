// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/boresightctl/goto_answer.h"

#include <gtest/gtest.h>

namespace boresight::ctl {
namespace {

std::string textFor(const SkyPointing& asked, const char* outcome, bool goesThere)
{
    const GotoAnswer answer = gotoAnswer(asked, QString::fromUtf8(outcome));
    EXPECT_EQ(answer.goesThere, goesThere) << outcome;
    return answer.text.toStdString();
}

// Story: "goto 30 95" said that the station accepted the elevation 95°, and the mount went to 90°.
// REQ-CTL-306: goto reports where the mount goes if it does not go to the target, with the reason. The exit status is 1
// then. A target on another wrap, or over the top, is the same direction.
TEST(GotoAnswer, ReportsTheDirectionThatIsNotTheTarget)
{
    EXPECT_EQ(textFor({30_deg, 95_deg}, "30.0° / 90.0°: elevation 95.0° above limit 90.0°", false),
              "Elevation 95.0° above limit 90.0°. The mount goes to 30.0° / 90.0°, the nearest permitted direction.");
    EXPECT_EQ(textFor({328_deg, 10_deg}, "330.0° / 10.0°: 328.0° / 10.0° lies in keep-out \"mast\"", false),
              "328.0° / 10.0° lies in keep-out \"mast\". The mount goes to 330.0° / 10.0°, the nearest permitted "
              "direction.");
    EXPECT_EQ(textFor({30_deg, 40_deg}, "31.0° / 40.0°", false),
              "The mount goes to 31.0° / 40.0° instead of the target.");
}

// REQ-CTL-306
TEST(GotoAnswer, KnowsTheSameDirection)
{
    EXPECT_EQ(textFor({113_deg, 10_deg}, "", true),
              "The station accepted the target azimuth 113.00°, elevation 10.00°.");
    EXPECT_EQ(textFor({400_deg, 30_deg}, "az 40.0° (one turn less)", true),
              "The station accepted the target azimuth 40.00°, elevation 30.00°.");
    EXPECT_EQ(
        textFor({30_deg, 120_deg}, "210.0° / 60.0° (the same direction)", true),
        "The station accepted the target azimuth 30.00°, elevation 120.00°. The mount goes to 210.0° / 60.0°, the same "
        "direction.");
    EXPECT_TRUE(gotoAnswer({210_deg, 60_deg}, QStringLiteral("30.0° / 120.0° (the same direction)")).goesThere);
}

}  // namespace
}  // namespace boresight::ctl
