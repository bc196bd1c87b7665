// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/options.h"

#include "core/profile/profile_file.h"
#include "core/profile/profile_store.h"
#include "core/profile/setting.h"
#include "tests/fakes/text_of.h"

#include <QDir>
#include <QFileInfo>
#include <QTemporaryDir>

#include <gmock/gmock.h>

using namespace boresight;
using namespace boresight::app;

namespace {

// The test has its own home folder.
class OptionsTest : public testing::Test
{
protected:
    OptionsTest() { qputenv("XDG_CONFIG_HOME", m_home.path().toUtf8()); }
    ~OptionsTest() override { qputenv("XDG_CONFIG_HOME", m_before); }
    OptionsTest(const OptionsTest&) = delete;
    OptionsTest& operator=(const OptionsTest&) = delete;

    [[nodiscard]] QString config() const { return m_home.filePath(QStringLiteral("boresight")); }

    [[nodiscard]] Result<Options> read(const QStringList& words = {}) const
    {
        return readOptions(QStringList{QStringLiteral("boresightd"), QStringLiteral("--state-dir"),
                                       m_home.filePath(QStringLiteral("state"))} +
                               words,
                           QStringLiteral("test"))
            .map_error([](const NoStart& problem) { return problem.error; });
    }

    static profile::Profile named(const char* name)
    {
        profile::Profile profile;
        profile.mount.name = name;
        return profile;
    }

private:
    QTemporaryDir m_home;
    QByteArray m_before = qgetenv("XDG_CONFIG_HOME");
};

}  // namespace

// REQ-TRACK-907: --elements names files, folders and addresses in place of those of the profile. It may be repeated.
TEST_F(OptionsTest, ElementsOverrideTheProfile)
{
    const auto options = read({QStringLiteral("--elements"), QStringLiteral("/data/weather.tle"),
                               QStringLiteral("--elements"), QStringLiteral("own.json")});
    ASSERT_TRUE(options) << textOf(options.error());
    ASSERT_EQ(options->profile.orbit.elements.size(), 2U);
    EXPECT_EQ(options->profile.orbit.elements[0], "/data/weather.tle");
    EXPECT_EQ(options->profile.orbit.elements[1], QDir::currentPath().toStdString() + "/own.json");
    EXPECT_EQ(options->overridden, std::vector<std::string>{"orbit.elements"});
}

// REQ-TRACK-907
TEST_F(OptionsTest, ElementsMayBeAddresses)
{
    const auto options = read({QStringLiteral("--elements"), QStringLiteral("celestrak:stations")});
    ASSERT_TRUE(options) << textOf(options.error());
    EXPECT_EQ(options->profile.orbit.elements, std::vector<std::string>{"celestrak:stations"});
    const auto refused = read({QStringLiteral("--elements"), QStringLiteral("http://example.org/a")});
    ASSERT_FALSE(refused);
    EXPECT_TRUE(
        textOf(refused.error()).starts_with("--elements: \"http://example.org/a\" does not begin with https://"));
}

TEST_F(OptionsTest, WithoutAnyProfileItIsTheFirstStart)
{
    const auto options = read();
    ASSERT_TRUE(options) << textOf(options.error());
    EXPECT_TRUE(options->isFirstStart());
    EXPECT_EQ(options->profile, profile::Profile{});
    EXPECT_EQ(options->configDir, config());
    EXPECT_FALSE(QFileInfo::exists(config())) << "looking makes nothing";
}

TEST_F(OptionsTest, TheCurrentMountOfTheStoreIsTaken)
{
    const profile::ProfileStore store(config());
    ASSERT_TRUE(store.add(named("one")));
    const auto two = store.add(named("two"));
    ASSERT_TRUE(two);
    EXPECT_FALSE(read()) << "nobody has said which";
    ASSERT_TRUE(store.setCurrent(*two));
    const auto options = read({QStringLiteral("--bus"), QStringLiteral("socketcan:can7")});
    ASSERT_TRUE(options) << textOf(options.error());
    EXPECT_FALSE(options->isFirstStart());
    EXPECT_EQ(options->profilePath, *two);
    EXPECT_EQ(options->profile.mount.name, "two");
    EXPECT_EQ(options->profile.bus, "socketcan:can7");
}

// REQ-MOUNT-05
TEST_F(OptionsTest, TheKindOfTheSimulatedMountIsChosen)
{
    EXPECT_EQ(read({QStringLiteral("--simulate")})->simulation, Simulation::Reference);
    const auto simple = read({QStringLiteral("--simulate=simple")});
    ASSERT_TRUE(simple) << textOf(simple.error());
    EXPECT_EQ(simple->simulation, (Simulation{.on = true, .driver = profile::AxisDriver::Simple}));
    EXPECT_EQ(simple->startingProfile().sensor.source, profile::SensorSource::None) << "there is none on it";
    const auto moteus = read({QStringLiteral("--simulate=moteus")});
    ASSERT_TRUE(moteus) << textOf(moteus.error());
    EXPECT_EQ(moteus->simulation, (Simulation{.on = true, .driver = profile::AxisDriver::Moteus}));
    EXPECT_EQ(moteus->startingProfile().sensor.source, profile::SensorSource::Simulated);
    const auto esp32 = read({QStringLiteral("--simulate=esp32")});
    ASSERT_TRUE(esp32) << textOf(esp32.error());
    EXPECT_EQ(
        esp32->simulation,
        (Simulation{.on = true, .driver = profile::AxisDriver::Gs232, .device = profile::SimulatedDevice::Esp32}));
    for (const char* const wrong : {"--simulate=nonsense", "--simulate=none", "--simulate="}) {
        const auto refused = read({QString::fromLatin1(wrong)});
        ASSERT_FALSE(refused) << wrong;
        EXPECT_THAT(textOf(refused.error()), testing::HasSubstr("moteus (a moteus drive), gs232 (")) << wrong;
    }
    EXPECT_FALSE(read({QStringLiteral("--simulate=simple"), QStringLiteral("--bus"), QStringLiteral("socketcan:can7")}))
        << "no real mount is ever taken for a simulated one";
}

// REQ-MOUNT-06
TEST_F(OptionsTest, ARealBusIsRefusedForAMountThatIsOnlySimulated)
{
    profile::Profile simple = named("simple");
    simple.azimuth.driver = profile::AxisDriver::Simple;
    simple.elevation.driver = profile::AxisDriver::None;
    const profile::ProfileStore store(config());
    ASSERT_TRUE(store.setCurrent(*store.add(simple)));
    EXPECT_TRUE(read());
    const auto real = read({QStringLiteral("--bus"), QStringLiteral("socketcan:can7")});
    ASSERT_FALSE(real);
    EXPECT_NE(textOf(real.error()).find("azimuth.driver: \"simple\" is only simulated"), std::string::npos);
}

// Story: the program was first tried with the simulated mount, with its sensor and its north applied. At the next start
// an adapter was named. The mount pointed 37.4° wrong, and refused every change because a real mount has no simulated
// sensor.
// REQ-PROFILE-17a
TEST_F(OptionsTest, ARealBusLeavesBehindWhatWasFoundOfTheSimulatedMount)
{
    profile::Profile tried = named("tried");
    tried.pointing.azimuthOffset = 37.4_deg;
    tried.sensor.source = profile::SensorSource::Simulated;
    tried.sensor.deviation.a1 = 3_deg;
    tried.jog.slow = 0.7_deg_s;
    const profile::ProfileStore store(config());
    const auto file = store.add(tried);
    ASSERT_TRUE(file && store.setCurrent(*file));
    const auto options = read({QStringLiteral("--bus"), QStringLiteral("socketcan:can7")});
    ASSERT_TRUE(options) << textOf(options.error());
    profile::Profile real = named("tried");
    real.bus = "socketcan:can7";
    real.mount.directions = profile::Directions::Unconfirmed;
    real.jog.slow = 0.7_deg_s;
    EXPECT_EQ(options->profile, real);
    EXPECT_TRUE(profile::problemsOf(options->profile).empty()) << "else every change would be refused";
    EXPECT_EQ(read({QStringLiteral("--simulate")})->profile, tried);
    EXPECT_EQ(profile::loadProfile(*file), tried) << "reading changes nothing";
}

TEST_F(OptionsTest, AnotherAdapterKeepsWhatWasFoundOfARealMount)
{
    profile::Profile real = named("real");
    real.bus = "socketcan:can0";
    real.pointing.azimuthOffset = 12_deg;
    const profile::ProfileStore store(config());
    ASSERT_TRUE(store.setCurrent(*store.add(real)));
    real.bus = "socketcan:can7";
    EXPECT_EQ(read({QStringLiteral("--bus"), QStringLiteral("socketcan:can7")})->profile, real);
    real.bus = "socketcan:can0";
    EXPECT_EQ(read({QStringLiteral("--simulate")})->profile, real) << "its bus is not used, and it stays";
}

TEST_F(OptionsTest, ABusWithoutAnyProfileIsTheReferenceMountThere)
{
    profile::Profile reference;
    reference.bus = "socketcan:can7";
    reference.mount.directions = profile::Directions::Unconfirmed;
    EXPECT_EQ(read({QStringLiteral("--bus"), QStringLiteral("socketcan:can7")})->profile, reference);
    EXPECT_EQ(read({QStringLiteral("--bus"), QStringLiteral("simulated")})->profile, profile::Profile{});
}

// REQ-AXES-15a
TEST_F(OptionsTest, WhereTheMountStandsIsToldWithTheTimeAtWhichSomebodyLooked)
{
    const auto standing = [this](const char* text) {
        return read({QStringLiteral("--standing-at"), QString::fromUtf8(text)});
    };
    const auto options = standing("405,-1.5@2026-11-22T18:05Z");
    ASSERT_TRUE(options) << textOf(options.error());
    EXPECT_NEAR(options->standingAt->place.azimuth.degrees(), 405.0, 1e-9);
    EXPECT_NEAR(options->standingAt->place.elevation.degrees(), -1.5, 1e-9);
    EXPECT_EQ(options->standingAt->looked, std::chrono::sys_days{std::chrono::year{2026} / 11 / 22} +
                                               std::chrono::hours(18) + std::chrono::minutes(5));
    EXPECT_TRUE(standing("405,50@2026-11-22T18:05:30Z"));
    for (const char* untimed :
         {"405,50", "405,50@", "405,50@18:05", "405,50@2026-11-22T18:05", "405,50@2026-11-22T18:05Z@"}) {
        const auto refused = standing(untimed);
        ASSERT_FALSE(refused) << untimed;
        EXPECT_NE(textOf(refused.error()).find("write --standing-at 405,50@20"), std::string::npos)
            << textOf(refused.error());
    }
    for (const char* wrong :
         {"", "405", "405,x@2026-11-22T18:05Z", "405,1,2@2026-11-22T18:05Z", "nan,1@2026-11-22T18:05Z"}) {
        EXPECT_FALSE(standing(wrong)) << wrong;
    }
}

TEST_F(OptionsTest, ARealMountHasNoSimulatedSensor)
{
    profile::Profile real = named("real");
    real.bus = "socketcan:can0";
    real.sensor.source = profile::SensorSource::Simulated;
    const QString file = config() + QStringLiteral("/real.toml");
    ASSERT_TRUE(QDir().mkpath(config()));
    ASSERT_TRUE(profile::saveProfile(real, file));
    const auto refused = read({QStringLiteral("--profile"), file});
    ASSERT_FALSE(refused);
    EXPECT_NE(textOf(refused.error()).find("real.toml: sensor.source: \"simulated\" needs"), std::string::npos)
        << textOf(refused.error());
    EXPECT_EQ(read({QStringLiteral("--profile"), file, QStringLiteral("--simulate")})->profile, real);
}

TEST_F(OptionsTest, WhoAsksForTheSimulatedMountGetsNoOther)
{
    profile::Profile real = named("real");
    real.bus = "socketcan:can0";
    for (const QStringList& words : {QStringList{QStringLiteral("--simulate")},
                                     QStringList{QStringLiteral("--bus"), QStringLiteral("simulated")}}) {
        const auto options = read(words);
        ASSERT_TRUE(options) << textOf(options.error());
        EXPECT_EQ(options->simulation, Simulation::Reference);
        EXPECT_EQ(options->simulationFor(real), Simulation::Reference);
    }
    const auto open = read();
    EXPECT_EQ(open->simulationFor(open->profile), Simulation::Reference) << "there is no other mount yet";
    EXPECT_EQ(open->simulationFor(real), Simulation::Off) << "a bus that is named later is used";
    const auto connected = read({QStringLiteral("--bus"), QStringLiteral("socketcan:can7")});
    EXPECT_EQ(connected->simulation, Simulation::Off);
    EXPECT_EQ(connected->simulationFor(connected->profile), Simulation::Off);
}

TEST_F(OptionsTest, TheAddressOfTheCommandLineIsNamedAsItsOwn)
{
    EXPECT_TRUE(read()->overridden.empty());
    EXPECT_EQ(read({QStringLiteral("--listen"), QStringLiteral("127.0.0.1:0")})->overridden,
              std::vector<std::string>{"rotctld.listen"});
}

// The simulated mount is usually tried first, and finding its north needs its sensor.
TEST_F(OptionsTest, TheSimulatedMountOfAFirstStartHasItsSensorOnIt)
{
    const profile::Profile tried = read({QStringLiteral("--simulate")})->startingProfile();
    EXPECT_EQ(tried.sensor.source, profile::SensorSource::Simulated);
    EXPECT_EQ(tried.mount.directions, profile::Directions::Confirmed);
    EXPECT_TRUE(profile::problemsOf(tried).empty());
    const profile::Profile commissioned = read()->startingProfile();
    EXPECT_EQ(commissioned.sensor.source, profile::SensorSource::None);
    EXPECT_EQ(commissioned.mount.directions, profile::Directions::Unconfirmed);
    const profile::ProfileStore store(config());
    ASSERT_TRUE(store.setCurrent(*store.add(named("one"))));
    const auto known = read({QStringLiteral("--simulate")});
    EXPECT_EQ(known->startingProfile(), known->profile);
}

// REQ-PROFILE-13
TEST_F(OptionsTest, TheSingleProfileOfOldGoesOnWorking)
{
    ASSERT_TRUE(QDir().mkpath(config()));
    ASSERT_TRUE(profile::saveProfile(named("old"), config() + QStringLiteral("/profile.toml")));
    for (int start = 0; start < 2; ++start) {
        const auto options = read();
        ASSERT_TRUE(options) << textOf(options.error());
        EXPECT_EQ(options->profile.mount.name, "old");
        EXPECT_EQ(options->profilePath, config() + QStringLiteral("/profiles/old.toml"));
        EXPECT_FALSE(options->isFirstStart());
    }
}

TEST_F(OptionsTest, ANamedProfileLeavesTheStoreAlone)
{
    ASSERT_TRUE(QDir().mkpath(config()));
    const QString single = config() + QStringLiteral("/profile.toml");
    ASSERT_TRUE(profile::saveProfile(named("old"), single));
    const QString other = config() + QStringLiteral("/other.toml");
    ASSERT_TRUE(profile::saveProfile(named("other"), other));
    const auto options = read({QStringLiteral("--profile"), other});
    ASSERT_TRUE(options) << textOf(options.error());
    EXPECT_EQ(options->profilePath, other);
    EXPECT_EQ(options->profile.mount.name, "other");
    EXPECT_TRUE(QFileInfo::exists(single));
    EXPECT_FALSE(read({QStringLiteral("--profile"), config() + QStringLiteral("/absent.toml")}));
}
