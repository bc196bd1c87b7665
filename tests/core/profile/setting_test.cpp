// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/profile/setting.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <string>
#include <vector>

using namespace boresight;
using namespace boresight::profile;

namespace {

std::vector<std::string> keysOf(const std::vector<Problem>& problems)
{
    std::vector<std::string> keys;
    for (const Problem& problem : problems) {
        keys.push_back(problem.key);
    }
    return keys;
}

}  // namespace

TEST(Settings, AreDescribedOnceEach)
{
    std::set<std::string> keys;
    for (const Setting& setting : settings()) {
        EXPECT_TRUE(keys.insert(setting.key).second) << setting.key << " twice";
        EXPECT_NE(setting.key.find('.'), std::string::npos) << setting.key;
        EXPECT_FALSE(setting.text.empty()) << setting.key;
        EXPECT_TRUE(setting.text.ends_with('.')) << setting.key;
    }
}

// What get() returns, set() takes and leaves the profile as it was: defaults are inside their own ranges.
TEST(Settings, DefaultsAreValid)
{
    Profile profile;
    for (const Setting& setting : settings()) {
        const auto done = setting.set(profile, setting.get(profile));
        EXPECT_TRUE(done) << setting.key;
    }
    EXPECT_TRUE(crossCheck(profile).empty());
    for (const Setting& setting : settings()) {
        EXPECT_EQ(setting.get(profile), setting.get(Profile{})) << setting.key;
    }
}

TEST(Settings, RefuseTheWrongTypeAndLeaveTheProfile)
{
    for (const Setting& setting : settings()) {
        Profile profile;
        const bool isText = setting.type == SettingType::Text || setting.type == SettingType::Choice;
        const SettingValue wrong = isText ? SettingValue{std::int64_t{1}} : SettingValue{std::string("1")};
        EXPECT_FALSE(setting.set(profile, wrong)) << setting.key;
        EXPECT_EQ(profile, Profile{}) << setting.key;
    }
}

TEST(Settings, RefuseWhatIsOutOfRange)
{
    for (const Setting& setting : settings()) {
        if (setting.type != SettingType::Number && setting.type != SettingType::Integer) {
            continue;
        }
        Profile profile;
        const auto as = [&](double value) {
            return setting.type == SettingType::Number ? SettingValue{value}
                                                       : SettingValue{static_cast<std::int64_t>(value)};
        };
        EXPECT_TRUE(setting.set(profile, as(setting.min))) << setting.key;
        EXPECT_TRUE(setting.set(profile, as(setting.max))) << setting.key;
        const Profile before = profile;
        EXPECT_FALSE(setting.set(profile, as(setting.min - 1.0))) << setting.key;
        EXPECT_FALSE(setting.set(profile, as(setting.max + 1.0))) << setting.key;
        if (setting.type == SettingType::Number) {
            EXPECT_FALSE(setting.set(profile, std::numeric_limits<double>::quiet_NaN())) << setting.key;
            EXPECT_FALSE(setting.set(profile, std::numeric_limits<double>::infinity())) << setting.key;
        }
        EXPECT_EQ(profile, before) << setting.key;
    }
}

TEST(Settings, ChoicesAreAllTaken)
{
    for (const Setting& setting : settings()) {
        for (const std::string& name : setting.choices) {
            Profile profile;
            ASSERT_TRUE(setting.set(profile, name)) << setting.key;
            EXPECT_EQ(std::get<std::string>(setting.get(profile)), name);
        }
    }
    Profile profile;
    ASSERT_TRUE(findSetting("rotctld.azimuth")->set(profile, std::string("-180..180")));
    EXPECT_EQ(profile.rotctld.azimuth, AzimuthConvention::PlusMinus180);
    ASSERT_TRUE(findSetting("elevation.gear_in")->set(profile, std::string("host")));
    EXPECT_EQ(profile.elevation.geometry.gearIn, pointing::GearIn::Host);
    ASSERT_TRUE(findSetting("control.on_exit")->set(profile, std::string("off")));
    EXPECT_EQ(profile.control.onExit, OnExit::Off);
    ASSERT_TRUE(findSetting("recovery.bus")->set(profile, std::string("interval")));
    EXPECT_EQ(profile.recovery.bus, Retry::Interval);
    EXPECT_EQ(profile.recovery.supply, Retry::Never) << "nothing recovers by itself unless it is asked for";
}

TEST(CrossCheck, FindsEveryClashAtOnce)
{
    Profile profile;
    profile.azimuth.geometry.travel = {.min = 10_deg, .max = 10_deg};
    profile.elevation.geometry.sign = 0;
    profile.park.elevation = 90.5_deg;
    profile.elevation.id = profile.azimuth.id;
    profile.control.tickHz = 20;
    profile.jog.slow = 7_deg_s;
    profile.elevation.limits.jerk = AngularJerk::fromDegrees(7.9);
    EXPECT_EQ(keysOf(crossCheck(profile)),
              (std::vector<std::string>{"azimuth.travel_min_deg", "elevation.sign", "park.elevation_deg",
                                        "elevation.max_jerk_deg_s3", "elevation.id", "control.watchdog_s",
                                        "jog.normal_deg_s"}));
}

TEST(CrossCheck, ThreeTicksMustFitIntoTheWatchdog)
{
    Profile profile;
    profile.control.tickHz = 60;
    profile.control.watchdog = Seconds(0.05);
    EXPECT_TRUE(crossCheck(profile).empty());
    profile.control.tickHz = 59;
    EXPECT_EQ(keysOf(crossCheck(profile)), std::vector<std::string>{"control.watchdog_s"});
}

TEST(CrossCheck, SupervisionHintsComeBeforeStops)
{
    Profile profile;
    profile.supervision.followingHint = 3.1_deg;
    profile.supervision.outsideHint = 1.6_deg;
    profile.supervision.replyAge = Seconds(0.039);
    profile.supervision.supplyStop = 20.0;
    profile.supervision.supplyHigh = 20.0;
    profile.supervision.boardHot = 75.0;
    EXPECT_EQ(keysOf(crossCheck(profile)),
              (std::vector<std::string>{"supervision.following_hint_deg", "supervision.outside_hint_deg",
                                        "supervision.reply_age_s", "supervision.supply_stop_v",
                                        "supervision.supply_low_v", "supervision.board_hot_c"}));
}

TEST(CrossCheck, TwoTicksMustFitIntoTheReplyAge)
{
    Profile profile;
    profile.control.tickHz = 20;
    profile.control.watchdog = Seconds(0.2);
    EXPECT_TRUE(crossCheck(profile).empty()) << "0.1 s are 2 ticks of 20 Hz";
    profile.supervision.replyAge = Seconds(0.099);
    EXPECT_EQ(keysOf(crossCheck(profile)), std::vector<std::string>{"supervision.reply_age_s"});
}

TEST(ListenAddress, IsHostAndPort)
{
    EXPECT_EQ(parseListenAddress("127.0.0.1:4533"), (ListenAddress{"127.0.0.1", 4533}));
    EXPECT_EQ(parseListenAddress("[::1]:0"), (ListenAddress{"::1", 0}));
    EXPECT_EQ(parseListenAddress("shack.local:65535"), (ListenAddress{"shack.local", 65535}));
    EXPECT_EQ(toText({"::1", 1}), "[::1]:1");
    EXPECT_EQ(toText({"0.0.0.0", 4533}), "0.0.0.0:4533");
    for (const char* wrong : {"", "4533", "127.0.0.1", "127.0.0.1:", ":4533", "host:65536", "host:-1", "host:4533x",
                              "::1:4533", "[]:1", "[host]:1", "a host:1", "127.0.0.1:0x10"}) {
        EXPECT_FALSE(parseListenAddress(wrong)) << wrong;
    }
}
