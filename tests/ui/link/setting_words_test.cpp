// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/link/setting_words.h"

#include "tests/fakes/text_of.h"

#include <gtest/gtest.h>

namespace boresight::ui {
namespace {

using profile::findSetting;
using profile::Profile;

// REQ-UI-29 (SettingWords.*)
TEST(SettingWords, ValuesAreReadWithTheirUnits)
{
    Profile profile;
    EXPECT_EQ(valueText(*findSetting("azimuth.travel_max_deg"), profile), QStringLiteral("450.0 °"));
    EXPECT_EQ(valueText(*findSetting("control.tick_hz"), profile), QStringLiteral("50 Hz"));
    EXPECT_EQ(valueText(*findSetting("mount.name"), profile), QStringLiteral("Boresight mount"));
    EXPECT_EQ(valueText(*findSetting("rotctld.allow"), profile), QStringLiteral("none"));
    EXPECT_EQ(valueText(*findSetting("site.latitude_deg"), profile), QStringLiteral("not set"));
    EXPECT_EQ(valueText(*findSetting("control.on_exit"), profile), QStringLiteral("Hold position"));
    EXPECT_EQ(typedText(*findSetting("control.on_exit"), profile), QStringLiteral("hold"));
    EXPECT_EQ(rangeText(*findSetting("control.on_exit")), QStringLiteral("Hold position, Brake, Torque off"));
    EXPECT_EQ(rangeText(*findSetting("azimuth.max_speed_deg_s")), QStringLiteral("0.01 … 360 °/s"));
}

TEST(SettingWords, ASettingIsNamedAsItIsFoundOnTheScreen)
{
    EXPECT_EQ(settingName("limits.elevation_max_deg"), QStringLiteral("highest elevation"));
    EXPECT_EQ(settingName("keep_out"), QStringLiteral("keep-outs"));
    EXPECT_EQ(settingName("azimuth.id"), QStringLiteral("CAN id (Azimuth axis)"));
    EXPECT_EQ(settingName("limits.horizon[2].azimuth_deg"),
              QStringLiteral("horizon[2].azimuth_deg (Limits of operation)"));
}

TEST(SettingWords, WhatIsShownCanBeTypedAgain)
{
    const Profile profile;
    for (const profile::Setting& setting : profile::settings()) {
        if (!setting.counts(profile)) {
            continue;
        }
        Profile typed;
        EXPECT_TRUE(putTyped(setting, typedText(setting, profile), typed)) << setting.key;
        EXPECT_EQ(typed, profile) << setting.key;
    }
}

TEST(SettingWords, AUnitMayFollowTheNumber)
{
    Profile profile;
    ASSERT_TRUE(putTyped(*findSetting("azimuth.max_speed_deg_s"), QStringLiteral(" 4.5 °/s "), profile));
    EXPECT_EQ(profile.azimuth.limits.speed, 4.5_deg_s);
    ASSERT_TRUE(putTyped(*findSetting("rotctld.allow"), QStringLiteral("10.0.0.0/8, 192.168.1.7"), profile));
    EXPECT_EQ(profile.rotctld.allow, (profile::TextList{"10.0.0.0/8", "192.168.1.7"}));
}

TEST(SettingWords, WhatIsNoValueIsRefusedWithTheReason)
{
    const std::pair<const char*, const char*> wrong[] = {
        {"azimuth.max_speed_deg_s", "fast"},    {"azimuth.max_speed_deg_s", "4,5"}, {"azimuth.max_speed_deg_s", ""},
        {"azimuth.max_speed_deg_s", "1000"},    {"control.tick_hz", "50.5"},        {"control.on_exit", "fall"},
        {"azimuth.max_speed_deg_s", "4.5 rpm"}, {"rotctld.allow", "everybody"},     {"mount.name", " "}};
    for (const auto& [key, typed] : wrong) {
        Profile profile;
        const auto taken = putTyped(*findSetting(key), QString::fromUtf8(typed), profile);
        ASSERT_FALSE(taken) << key << " " << typed;
        EXPECT_TRUE(textOf(taken.error()).starts_with(findSetting(key)->title + ": ")) << textOf(taken.error());
        EXPECT_EQ(profile, Profile());
    }
}

TEST(SettingWords, TheBarShowsWhereTheValueLiesInItsRange)
{
    Profile profile;
    const profile::Setting& end = *findSetting("azimuth.travel_max_deg");  // -3600 … 3600
    ASSERT_TRUE(putTyped(end, QStringLiteral("0"), profile));
    EXPECT_DOUBLE_EQ(*shareOfRange(end, profile), 0.5);
    const profile::Setting& speed = *findSetting("azimuth.max_speed_deg_s");  // 0.01 … 360: logarithmic
    ASSERT_TRUE(putTyped(speed, QStringLiteral("0.01"), profile));
    EXPECT_DOUBLE_EQ(*shareOfRange(speed, profile), 0.0);
    ASSERT_TRUE(putTyped(speed, QStringLiteral("1.897366596"), profile));  // the geometric middle
    EXPECT_NEAR(*shareOfRange(speed, profile), 0.5, 1e-6);
    EXPECT_FALSE(shareOfRange(*findSetting("mount.name"), profile));
}

}  // namespace
}  // namespace boresight::ui
