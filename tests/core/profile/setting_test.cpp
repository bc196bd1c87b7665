// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/profile/setting.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <string>
#include <vector>

using namespace boresight;
using namespace boresight::profile;

// REQ-PROFILE-02: Every key is described once: table, type, unit, range, text, and when a change applies. Its default
// and the ends of its range are valid values.
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

// A value from get() is accepted by set() and leaves the profile unchanged: defaults are inside their ranges.
// REQ-PROFILE-02
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

// REQ-PROFILE-03
TEST(Settings, RefuseTheWrongTypeAndLeaveTheProfile)
{
    for (const Setting& setting : settings()) {
        Profile profile;
        const bool isNumber = setting.type == SettingType::Number || setting.type == SettingType::Integer;
        EXPECT_FALSE(setting.set(profile, isNumber ? SettingValue{std::string("1")} : SettingValue{std::int64_t{1}}))
            << setting.key;
        EXPECT_EQ(setting.set(profile, TextList{}).has_value(), setting.type == SettingType::TextList) << setting.key;
        EXPECT_EQ(profile, Profile{}) << setting.key;
    }
}

// REQ-PROFILE-03
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

// REQ-HOOKS-20: A program for a moment of a pass is a list of its path, which begins with /, and its arguments, one
// line each. An empty list means no program, and is the default.
TEST(Settings, AProgramIsAPathAndArguments)
{
    for (const char* const key :
         {"schedule.hook_before_aos", "schedule.hook_aos", "schedule.hook_los", "schedule.hook_fault"}) {
        const Setting& setting = *findSetting(key);
        Profile profile;
        EXPECT_EQ(setting.get(profile), SettingValue(TextList{}));
        for (const TextList& bad : {TextList{"record"}, TextList{"./record"}, TextList{"~/record"}, TextList{""},
                                    TextList{"/bin/x", "one\ntwo"}, TextList{"/bin/x", std::string(1001, 'a')}}) {
            EXPECT_FALSE(setting.set(profile, bad)) << bad.front();
        }
        EXPECT_FALSE(setting.set(profile, std::string("/bin/x")));
        EXPECT_EQ(profile, Profile{});
        const TextList good{"/usr/local/bin/record", "--name", "$(id) *", ""};
        ASSERT_TRUE(setting.set(profile, good));
        EXPECT_EQ(setting.get(profile), SettingValue(good));
        ASSERT_TRUE(setting.set(profile, TextList{}));
        EXPECT_EQ(profile, Profile{});
    }
}

TEST(Settings, ChoicesAreAllTaken)
{
    for (const Setting& setting : settings()) {
        for (const SettingChoice& choice : setting.choices) {
            Profile profile;
            ASSERT_TRUE(setting.set(profile, choice.word)) << setting.key;
            EXPECT_EQ(std::get<std::string>(setting.get(profile)), choice.word);
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

// Story: the page of the profile showed the words of the file, such as "as_hamlib" and "unwind".
// REQ-PROFILE-968: Each choice of a setting has a name for people, which is unique within the setting. The file keeps
// its word.
TEST(Settings, EachChoiceHasAName)
{
    const auto check = [](const auto& fields) {
        for (const auto& field : fields) {
            std::set<std::string> titles;
            for (const SettingChoice& choice : field.choices) {
                EXPECT_FALSE(choice.title.empty()) << field.key << ' ' << choice.word;
                EXPECT_EQ(choice.title.find_first_of("_,"), std::string::npos) << field.key << ' ' << choice.title;
                EXPECT_TRUE(titles.insert(choice.title).second) << field.key << ' ' << choice.title;
            }
            EXPECT_EQ(field.choices.empty(), field.type != SettingType::Choice) << field.key;
        }
    };
    check(settings());
    check(satelliteSettings());
    const auto& between = findSetting("schedule.between")->choices;
    EXPECT_EQ(choiceName(between, "unwind").toStdString(), "Unwrap the cable");
    EXPECT_EQ(choiceName(between, "elsewhere").toStdString(), "elsewhere");
}

// The names of the keys in a row. They are described like every setting.
// REQ-PROFILE-02
TEST(Settings, RowsAreDescribedToo)
{
    const auto check = [](const auto& fields) {
        std::string keys;
        for (const auto& field : fields) {
            keys += field.key + " ";
            EXPECT_TRUE(field.text.ends_with('.')) << field.key;
            EXPECT_EQ(field.applies, Applies::Now) << field.key;
        }
        return keys;
    };
    EXPECT_EQ(check(horizonSettings()), "azimuth_deg elevation_deg ");
    EXPECT_EQ(check(keepOutSettings()), "name azimuth_from_deg azimuth_to_deg elevation_min_deg elevation_max_deg ");
    EXPECT_EQ(check(presetSettings()), "name azimuth_deg elevation_deg ");
    EXPECT_EQ(check(satelliteSettings()), "norad favourite note antenna ");
    EXPECT_EQ(check(antennaSettings()), "name beam_width_deg offset_across_deg offset_up_deg ");
    EXPECT_EQ(check(watchSettings()), "norad priority min_elevation_deg ");
}

// Settings that the drives, the socket or the journal file use at their start cannot change under a moving mount.
TEST(Settings, SayWhatWaitsForAReconnect)
{
    for (const char* key : {"mount.name", "azimuth.travel_max_deg", "elevation.id", "control.watchdog_s",
                            "rotctld.listen", "rotctld.dump_state", "bus.name"}) {
        EXPECT_EQ(findSetting(key)->applies, Applies::OnReconnect) << key;
    }
    for (const char* key : {"mount.directions", "limits.azimuth_min_deg", "park.azimuth_deg", "site.height_m",
                            "rotctld.lead", "rotctld.allow", "rotctld.locked_to", "jog.fast_deg_s"}) {
        EXPECT_EQ(findSetting(key)->applies, Applies::Now) << key;
    }
}

TEST(Settings, TheSiteIsKnownOnceItIsSet)
{
    Profile profile;
    const Setting* const latitude = findSetting("site.latitude_deg");
    EXPECT_FALSE(latitude->counts(profile));
    EXPECT_FALSE(latitude->set(profile, 90.5));
    EXPECT_FALSE(profile.site.known);
    ASSERT_TRUE(latitude->set(profile, -33.5));
    EXPECT_TRUE(profile.site.known);
    EXPECT_TRUE(latitude->counts(profile));
    EXPECT_EQ(profile.site.latitude, -33.5_deg);
}

// REQ-PROFILE-06: Clients are valid addresses and networks. A mount that is locked to one client names it.
TEST(Settings, ClientsAreAddressesAndNetworks)
{
    Profile profile;
    const Setting* const allow = findSetting("rotctld.allow");
    const TextList good{"127.0.0.1", "10.0.0.0/8", "::1", "fd00::/8", "fe80::1%eth0", "0.0.0.0/0"};
    ASSERT_TRUE(allow->set(profile, good));
    EXPECT_EQ(profile.rotctld.allow, good);
    for (const char* bad :
         {"", "10.1", "10.0.0.0/", "10.0.0.0/33", "::/129", "10.0.0.0/-1", "10.0.0.0/8/8", "/8", "shack.local",
          "10.0.0.1:4533", " 10.0.0.1", "::1 ", "1.2.3.256", "10.0.0/24", "fe80::1%\x1b", "127.0.0.01"}) {
        EXPECT_FALSE(allow->set(profile, TextList{"::1", bad})) << bad;
        EXPECT_EQ(profile.rotctld.allow, good) << bad;
    }
    const Setting* const lockedTo = findSetting("rotctld.locked_to");
    EXPECT_TRUE(lockedTo->set(profile, std::string("192.168.1.7")));
    EXPECT_FALSE(lockedTo->set(profile, std::string("10.0.0.0/8"))) << "one client, not a network";
    EXPECT_EQ(profile.rotctld.lockedTo, "192.168.1.7");
    EXPECT_TRUE(lockedTo->set(profile, std::string()));
}

// Degrees become radians and degrees again. The ends of a range must still be inside it.
// REQ-PROFILE-02
TEST(Settings, TheEndsOfARangeStayInside)
{
    for (const Setting& setting : settings()) {
        for (const double end : {setting.min, setting.max}) {
            Profile profile;
            if (setting.type == SettingType::Number) {
                ASSERT_TRUE(setting.set(profile, end)) << setting.key;
                EXPECT_TRUE(setting.set(profile, setting.get(profile))) << setting.key << " " << end;
            }
        }
    }
}

// REQ-PROFILE-05a: Each term of the pointing model is a setting. All but the azimuth offset are at most 10°. They apply
// at once, and the park position is checked with them.
TEST(Settings, ThePointingModelAppliesAtOnce)
{
    Profile profile;
    int terms = 0;
    for (const Setting& setting : settings()) {
        if (setting.key.starts_with("pointing.")) {
            EXPECT_EQ(setting.applies, Applies::Now) << setting.key;
            const bool anyAngle = setting.key == "pointing.azimuth_offset_deg";
            EXPECT_EQ(setting.set(profile, 37.4).has_value(), anyAngle) << setting.key;
            EXPECT_TRUE(setting.set(profile, -9.5)) << setting.key;
            ++terms;
        }
    }
    EXPECT_EQ(terms, 7);
    const Angle k = Angle::fromDegrees(-9.5);
    EXPECT_EQ(profile.pointing, (pointing::PointingTerms{k, k, k, k, k, k, k}));
}

TEST(Settings, TheBrokerIsAHostAndTopicsAreTopics)
{
    Profile profile;
    const auto takes = [&profile](const char* key, const char* text) {
        return findSetting(key)->set(profile, std::string(text)).has_value();
    };
    for (const char* const host : {"broker.example", "192.168.1.7", "::1", "fe80::1%eth0"}) {
        EXPECT_TRUE(takes("mqtt.host", host)) << host;
    }
    for (const char* const host : {"", "mqtt://broker", "[::1]", "a broker", "two\nlines"}) {
        EXPECT_FALSE(takes("mqtt.host", host)) << host;
    }
    for (const char* const prefix : {"boresight/", "shack", "/a/b/"}) {
        EXPECT_TRUE(takes("mqtt.prefix", prefix)) << prefix;
    }
    for (const char* const prefix : {"", "#", "a/+/b", "$SYS/"}) {
        EXPECT_FALSE(takes("mqtt.prefix", prefix)) << prefix;
    }
    EXPECT_FALSE(takes("mqtt.password", std::string(201, 'x').c_str()));
    EXPECT_FALSE(takes("mqtt.port", "1883"));
}

// REQ-PROFILE-19: A secret is only in the file of the profile, which then nobody but its owner may read. It appears
// neither in the log lines about changes nor in the diagnostics.
TEST(Settings, ThePasswordIsTheOnlySecret)
{
    std::vector<std::string> secrets;
    for (const Setting& setting : settings()) {
        if (setting.secret) {
            secrets.push_back(setting.key);
        }
    }
    EXPECT_EQ(secrets, std::vector<std::string>{"mqtt.password"});
    Profile profile;
    EXPECT_FALSE(hasSecrets(profile));
    EXPECT_EQ(withoutSecrets(profile), profile);
    profile.mqtt.password = "s3cret";
    EXPECT_TRUE(hasSecrets(profile));
    Profile shown = withoutSecrets(profile);
    EXPECT_EQ(shown.mqtt.password, "(hidden)");
    shown.mqtt.password = profile.mqtt.password;
    EXPECT_EQ(shown, profile);
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
