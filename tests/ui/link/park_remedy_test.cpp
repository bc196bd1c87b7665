// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/link/park_remedy.h"

#include "tests/ui/find_widget.h"
#include "ui/kit/command_button.h"
#include "ui/kit/value_label.h"
#include "ui/link/profile_draft_bar.h"

#include <QLayout>
#include <QTest>

#include <gtest/gtest.h>

#include <algorithm>

namespace boresight::ui {
namespace {

profile::Profile parkedAt(AxisPosition place)
{
    profile::Profile profile;
    profile.park = place;
    return profile;
}

// REQ-UI-711: When an edit makes the park position forbidden, the bar says so and offers a button that moves the park
// position to the next allowed elevation.
TEST(ParkRemedy, TheNextElevationAtTheSameAzimuth)
{
    profile::Profile profile = parkedAt({0_deg, 0_deg});
    EXPECT_FALSE(parkRemedy(profile)) << "it is permitted";
    profile.limits.horizon = {{345_deg, 0_deg}, {0_deg, 14.5_deg}, {15_deg, 0_deg}};
    std::ranges::sort(profile.limits.horizon, {}, &pointing::HorizonPoint::azimuth);
    auto remedy = parkRemedy(profile);
    ASSERT_TRUE(remedy);
    EXPECT_EQ(remedy->place, (AxisPosition{0_deg, 15_deg}));
    EXPECT_EQ(remedy->text, QStringLiteral("Move park to 15°"));
    profile.limits.horizon.clear();
    profile.limits.keepOuts = {{"mast", 350_deg, 10_deg, 0_deg, 48_deg}};
    EXPECT_EQ(parkRemedy(profile)->place, (AxisPosition{0_deg, 48_deg}));
    profile.limits.keepOuts.clear();
    profile.limits.elevation.min = 5.5_deg;
    EXPECT_EQ(parkRemedy(profile)->text, QStringLiteral("Move park to 5.5°"));
}

// REQ-UI-711
TEST(ParkRemedy, AnotherAzimuthWhereNoElevationWillDo)
{
    profile::Profile profile = parkedAt({0_deg, 0_deg});
    profile.limits.keepOuts = {{"wall", 350_deg, 10_deg, -90_deg, 90_deg}};
    const auto remedy = parkRemedy(profile);
    ASSERT_TRUE(remedy);
    EXPECT_NEAR(abs(remedy->place.azimuth).degrees(), 10.0, 1e-6);
    profile.limits.keepOuts.clear();
    profile.limits.azimuth = {200_deg, 300_deg};
    EXPECT_EQ(parkRemedy(profile)->text, QStringLiteral("Move park to 200° / 0°"));
    profile.limits.azimuth = {300_deg, 200_deg};
    EXPECT_FALSE(parkRemedy(profile)) << "another problem comes first";
}

// REQ-UI-711
TEST(ParkRemedy, TheBarSaysItAndOneButtonResolvesIt)
{
    RequestDesk desk;
    ProfileDraft draft(desk);
    ProfileDraftBar bar(draft, desk);
    bar.resize(500, 100);
    bar.show();
    auto* const button = findNamed<CommandButton>(bar, "Move park");
    ASSERT_NE(button, nullptr);
    EXPECT_FALSE(button->isVisible());
    draft.edit([](profile::Profile& profile) {
        profile.limits.horizon = {{0_deg, 14.5_deg}, {15_deg, 0_deg}, {345_deg, 0_deg}};
    });
    EXPECT_FALSE(draft.whyNoApply().isEmpty());
    EXPECT_EQ(findNamed<ValueLabel>(bar, "Changes of the profile")->text(),
              QStringLiteral("park elevation: 0.0° / 0.0° lies below the horizon (14.5°)"));
    ASSERT_TRUE(button->isVisible());
    EXPECT_EQ(button->text(), QStringLiteral("Move park to 15°"));
    // Story: Apply moved to the place of this button, and a click on Revert dropped the drawn limits.
    bar.layout()->activate();
    const QRect apply = findNamed<CommandButton>(bar, "Apply")->geometry();
    QTest::mouseClick(button, Qt::LeftButton);
    bar.layout()->activate();
    EXPECT_EQ(findNamed<CommandButton>(bar, "Apply")->geometry(), apply);
    EXPECT_EQ(draft.edited().park.elevation, 15_deg);
    EXPECT_TRUE(draft.whyNoApply().isEmpty());
    EXPECT_FALSE(button->isVisible());
}

}  // namespace
}  // namespace boresight::ui
