// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/profile/profile_diff.h"

#include "core/profile/profile_file.h"
#include "tests/fakes/text_of.h"

#include <gtest/gtest.h>

using namespace boresight;
using namespace boresight::profile;

namespace {

using Keys = std::vector<std::string>;

// A change in the form that gtest compares.
struct Told
{
    std::string key;
    std::string before;
    std::string after;
    Applies applies = Applies::Now;

    bool operator==(const Told&) const = default;
};

std::vector<Told> toldBetween(const Profile& from, const Profile& to)
{
    std::vector<Told> told;
    for (const Change& change : changesBetween(from, to)) {
        told.push_back({change.key, change.before.toStdString(), change.after.toStdString(), change.applies});
    }
    return told;
}

}  // namespace

// REQ-PROFILE-10 (ProfileDiff.*): Two profiles are compared key by key, with both values and with the time when the
// change applies. Lists and the site are one line each.
TEST(ProfileDiff, TellsEachKeyWithBothValuesAndWhenItApplies)
{
    const Profile from;
    Profile to = from;
    to.mount.name = "West \"2\"";
    to.azimuth.geometry.travel.max = 270.5_deg;
    to.control.onExit = OnExit::Brake;
    to.rotctld.allow = {"10.0.0.0/8", "::1"};
    EXPECT_EQ(toldBetween(from, to),
              (std::vector<Told>{
                  {"mount.name", "\"Boresight mount\"", "\"West \\\"2\\\"\"", Applies::OnReconnect},
                  {"azimuth.travel_max_deg", "450.0 °", "270.5 °", Applies::OnReconnect},
                  {"control.on_exit", "\"hold\"", "\"brake\"", Applies::Now},
                  {"rotctld.allow", "[]", "[\"10.0.0.0/8\", \"::1\"]", Applies::Now},
              }));
    EXPECT_TRUE(changesBetween(to, to).empty());
}

// REQ-PROFILE-19
TEST(ProfileDiff, DoesNotSaySecrets)
{
    Profile from;
    from.mqtt.user = "mount";
    Profile to = from;
    to.mqtt.password = "s3cret";
    EXPECT_EQ(toldBetween(from, to), (std::vector<Told>{{"mqtt.password", "\"\"", "(hidden)", Applies::Now}}));
    from.mqtt.password = "s3cre7";
    EXPECT_EQ(toldBetween(from, to), (std::vector<Told>{{"mqtt.password", "(hidden)", "(hidden)", Applies::Now}}));
}

TEST(ProfileDiff, ListsAndTheSiteAreOneLineEach)
{
    Profile from;
    from.limits.horizon = {{0_deg, -5_deg}, {90_deg, -3_deg}};
    from.limits.keepOuts = {{"mast", 350_deg, 10_deg, 40_deg, 90_deg}, {"tree", 50_deg, 60_deg, 40_deg, 90_deg}};
    Profile to = from;
    to.limits.horizon.push_back({180_deg, -2_deg});
    to.limits.keepOuts = {{"mast", 340_deg, 10_deg, 40_deg, 90_deg}, {"roof", 50_deg, 60_deg, 40_deg, 90_deg}};
    to.presets = {{"north", {}}};
    to.site = {.known = true, .latitude = -33.9_deg, .longitude = 151.25_deg, .heightMetres = 12.0};
    EXPECT_EQ(toldBetween(from, to),
              (std::vector<Told>{
                  {"limits.horizon", "2 points", "3 points", Applies::Now},
                  {"keep_out", "\"mast\" (different), \"tree\"", "\"mast\" (different), \"roof\"", Applies::Now},
                  {"preset", "none", "\"north\"", Applies::Now},
                  {"site", "not set", "-33.9 °, 151.25 °, 12.0 m", Applies::Now},
              }));
    to = from;
    to.limits.horizon[1].elevation = -3.5_deg;
    EXPECT_EQ(toldBetween(from, to),
              (std::vector<Told>{{"limits.horizon", "2 points, 1 different", "2 points, 1 different", Applies::Now}}));
}

// Every setting is compared, and can be copied alone by its key.
TEST(ProfileDiff, KnowsEveryKey)
{
    constexpr const char* kOffsets = "accelerometer 1 2 3, magnetometer 4 5 6, gyroscope 7 8 9, radii 1000 700";
    for (const Setting& setting : settings()) {
        const Profile from;
        Profile to;
        SettingValue other = setting.type == SettingType::TextList ? SettingValue(TextList{"::1"}) : setting.max;
        if (setting.type == SettingType::Integer) {
            other = static_cast<std::int64_t>(setting.max - 1.0);
        } else if (setting.type == SettingType::Choice) {
            const std::string& first = setting.choices.front().word;
            other = setting.get(from) == SettingValue(first) ? setting.choices.back().word : first;
        } else if (setting.type == SettingType::Text) {
            other = setting.key == "rotctld.listen"                ? "[::1]:1"
                    : setting.key == "bus.name"                    ? "socketcan:can7"
                    : setting.key == "gpredict.folder"             ? "/mnt/Gpredict"
                    : setting.key == "azel.file"                   ? "/srv/azel.dat"
                    : setting.key == "transmit.output"             ? "file:/srv/transmit"
                    : setting.key == "brake.output"                ? "rts:/dev/ttyUSB0"
                    : setting.key.ends_with("_at_deg")             ? "-3.5"
                    : setting.key == "rotator.sensor_offsets"      ? kOffsets
                    : setting.key.starts_with("end_switches.")     ? "cts:/dev/ttyUSB0"
                    : setting.key == "wind.source"                 ? "udp:4541"
                    : setting.key == "sensor.deviation_unreliable" ? "40.0-80.0"
                                                                   : "::1";
        }
        if (setting.key == "orbit.elements" || setting.key.starts_with("schedule.hook_")) {
            other = setting.type == SettingType::TextList ? SettingValue(TextList{"/srv/elements"}) : other;
        }
        if (setting.key == "bus.watched") {
            other = TextList{"3 polarisation"};
        }
        if (setting.key == "bus.hamlib_settings") {
            other = TextList{"min_az=-90"};
        }
        if (setting.key == "listeners.list") {
            other = TextList{"gs232b drive tcp:127.0.0.1:4534"};
        }
        if (setting.get(from) == other) {
            other = setting.min;
        }
        ASSERT_TRUE(setting.set(to, other)) << setting.key;
        const Keys keys = changedKeys(from, to);
        ASSERT_EQ(keys.size(), 1U) << setting.key;
        EXPECT_EQ(keys.front(), setting.key.starts_with("site.") ? "site" : setting.key);
        Profile taken;
        takeOver(taken, to, keys);
        EXPECT_EQ(taken, to) << setting.key;
        takeOver(taken, from, keys);
        EXPECT_EQ(taken, from) << setting.key;
    }
}

TEST(ProfileDiff, WhatIsWrittenAlikeIsTheSame)
{
    Profile from;
    from.park.azimuth = Angle::fromDegrees(0.1 + 0.2);
    from.limits.horizon = {{Angle::fromDegrees(0.1 + 0.2), -5_deg}};
    const auto read = parseProfile(toToml(from), QStringLiteral("m.toml"));
    ASSERT_TRUE(read) << textOf(read.error());
    EXPECT_TRUE(changesBetween(from, *read).empty());
}

// REQ-PROFILE-11 (Applied.*): The changes of a wanted profile that need a reconnect wait, together with the changes
// that are only valid with them.
TEST(Applied, WhatNeedsAReconnectWaits)
{
    const Profile inForce;
    Profile wanted;
    wanted.jog.fast = 9_deg_s;
    wanted.limits.azimuth.max = 200_deg;
    wanted.limits.horizon = {{0_deg, -5_deg}};
    wanted.azimuth.geometry.travel.max = 270_deg;
    wanted.rotctld.listen.port = 4534;
    wanted.rotctld.control = ControlRule::Last;
    const Application result = applied(inForce, wanted);
    EXPECT_EQ(result.waitingKeys, (Keys{"azimuth.travel_max_deg", "rotctld.listen"}));
    Profile expected = wanted;
    expected.azimuth.geometry.travel.max = 450_deg;
    expected.rotctld.listen.port = 4533;
    EXPECT_EQ(result.inForce, expected);
    EXPECT_EQ(applied(inForce, inForce), (Application{inForce, {}}));
}

// The mount would refuse a park position outside its present travel, so this change waits for the new travel. No other
// change has to wait.
TEST(Applied, WhatMakesSenseOnlyWithWhatWaitsWaitsToo)
{
    const Profile inForce;
    Profile wanted;
    wanted.azimuth.geometry.travel.max = 600_deg;
    wanted.park = {.azimuth = 540_deg, .elevation = 45_deg};
    wanted.jog.fast = 9_deg_s;
    const Application result = applied(inForce, wanted);
    EXPECT_EQ(result.waitingKeys, (Keys{"azimuth.travel_max_deg", "park.azimuth_deg", "park.elevation_deg"}));
    EXPECT_EQ(result.inForce.park, inForce.park);
    EXPECT_EQ(result.inForce.jog.fast, 9_deg_s);
    EXPECT_TRUE(crossCheck(result.inForce).empty());
}

// The new limits exclude the old park position, and the new park position is outside the old travel.
TEST(Applied, WhereOldAndNewDoNotGoTogetherAllWaits)
{
    Profile inForce;
    inForce.azimuth.geometry.travel = {-90_deg, 90_deg};
    Profile wanted;
    wanted.azimuth.geometry.travel = {-90_deg, 400_deg};
    wanted.limits.azimuth = {80_deg, 350_deg};
    wanted.park.azimuth = 200_deg;
    wanted.jog.fast = 9_deg_s;
    ASSERT_TRUE(crossCheck(inForce).empty());
    ASSERT_TRUE(crossCheck(wanted).empty());
    const Application result = applied(inForce, wanted);
    EXPECT_EQ(result.inForce, inForce);
    EXPECT_EQ(result.waitingKeys, changedKeys(inForce, wanted));
}
