// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/profile/profile_file.h"

#include "core/profile/small_file.h"
#include "tests/fakes/full_disk.h"
#include "tests/fakes/text_of.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <gtest/gtest.h>

using namespace boresight;
using namespace boresight::profile;

namespace {

std::string errorsOf(std::string_view toml)
{
    const auto profile = parseProfile(toml, QStringLiteral("m.toml"));
    return profile ? "accepted" : textOf(profile.error());
}

QByteArray contentOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("unreadable");
}

}  // namespace

// Story: on a full disk an empty profile replaced a good one and was reported as stored. QSaveFile keeps a small file
// in its buffer until it renames it.
// REQ-PROFILE-961: On a full disk no file is replaced, whatever its size, and the reason is reported.
TEST(ProfileFile, AFullDiskReplacesNothing)
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("m.toml"));
    ASSERT_TRUE(writeFile(path, "version = 1\n"));
    for (const qsizetype size : {10, 100'000}) {
        const Result<> written = [&] {
            const FullDisk full;
            return writeFile(path, QByteArray(size, '#'));
        }();
        ASSERT_FALSE(written) << size;
        EXPECT_TRUE(textOf(written.error()).ends_with("m.toml: File too large")) << textOf(written.error());
        EXPECT_EQ(contentOf(path), "version = 1\n");
        EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files).size(), 1) << "nothing is left beside it";
    }
    EXPECT_TRUE(writeFile(path, "version = 1\n#\n"));
}

// REQ-PROFILE-01: The defaults describe the reference mount. Azimuth 0…360° is 0…1 turn, travel -90…450°. Elevation is
// inverted, 0° is -0.25 turn, 90° is -0.5 turn, travel 0…90°.
TEST(ProfileFile, NothingButTheVersionIsTheReferenceMount)
{
    const auto profile = parseProfile("version = 1\n", QStringLiteral("m.toml"));
    ASSERT_TRUE(profile) << textOf(profile.error());
    EXPECT_EQ(*profile, Profile{});
    EXPECT_EQ(profile->azimuth.geometry.toMotor(360_deg).turns(), 1.0);
    EXPECT_EQ(profile->azimuth.geometry.travel, (TravelRange{-90_deg, 450_deg}));
    EXPECT_EQ(profile->elevation.geometry.toMotor(0_deg).turns(), -0.25);
    EXPECT_EQ(profile->elevation.geometry.toMotor(90_deg).turns(), -0.5);
    EXPECT_EQ(profile->elevation.geometry.travel, (TravelRange{0_deg, 90_deg}));
    EXPECT_EQ(profile->rotctld.listen, (ListenAddress{"127.0.0.1", 4533}));
}

// REQ-PROFILE-08: A written profile reads back with the same values. A profile that could not be read again is not
// written.
TEST(ProfileFile, TheDefaultFileReadsBackAsTheDefault)
{
    const std::string text = toToml(Profile{});
    const auto profile = parseProfile(text, QStringLiteral("m.toml"));
    ASSERT_TRUE(profile) << textOf(profile.error());
    EXPECT_EQ(*profile, Profile{});
    EXPECT_NE(text.find("# Upper end of the permitted travel, as an axis angle: 370° is not 10°.\n"
                        "# -3600.0…3600.0 °; default 450.0; applies on reconnect\n"
                        "travel_max_deg = 450.0\n"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("# one of \"hold\" \"brake\" \"off\"; default \"hold\"; applies at once\n"), std::string::npos);
}

// Story: "profile --default" printed confirmed directions. With the name of a real bus in this file, an untested mount
// went to its first target at 10°/s.
// REQ-PROFILE-06a: The directions of a real mount are unconfirmed until its file says that they are confirmed. The file
// that the program prints for the simulated mount does not mention them, so that another bus in it does not confirm
// them.
TEST(ProfileFile, TheDirectionsOfARealMountAreUnconfirmedUntilItsFileSaysSo)
{
    const auto directionsOf = [](const std::string& toml) {
        return parseProfile(toml, QStringLiteral("m.toml"))->mount.directions;
    };
    const std::string real = "version = 1\n[bus]\nname = \"socketcan:can0\"\n";
    EXPECT_EQ(directionsOf("version = 1\n"), Directions::Confirmed) << "the simulated mount";
    EXPECT_EQ(directionsOf(real), Directions::Unconfirmed);
    EXPECT_EQ(directionsOf(real + "[mount]\ndirections = \"confirmed\"\n"), Directions::Confirmed);
    std::string edited = toToml(Profile{});
    edited.replace(edited.find("\"simulated\"\n"), 11, "\"socketcan:can0\"");
    EXPECT_EQ(directionsOf(edited), Directions::Unconfirmed) << edited;
    Profile seen;
    seen.bus = "socketcan:can0";
    EXPECT_EQ(directionsOf(toToml(seen)), Directions::Confirmed);
    seen.bus = "simulated";
    seen.mount.directions = Directions::Unconfirmed;
    EXPECT_EQ(directionsOf(toToml(seen)), Directions::Unconfirmed);
}

// REQ-PROFILE-08
TEST(ProfileFile, EveryValueSurvivesTheRoundTrip)
{
    Profile changed;
    changed.mount.name = "8\" mast, C:\\shed, Ω";
    changed.bus = "fdcanusb:/dev/serial/by-id/usb-mjbots_fdcanusb";
    changed.azimuth.id = 126;
    changed.azimuth.geometry = {.sign = -1,
                                .offset = Angle::fromDegrees(-12.345678912),
                                .gearRatio = 60.25,
                                .gearIn = pointing::GearIn::Host,
                                .travel = {-180.1_deg, 179.9_deg}};
    changed.azimuth.limits = {AngularRate::fromDegrees(0.1), AngularAcceleration::fromDegrees(0.3),
                              AngularJerk::fromDegrees(0.7)};
    changed.azimuth.timeoutMode = TimeoutMode::Brake;
    changed.park = {.azimuth = -33.3_deg, .elevation = 89.99_deg};
    changed.control = {.tickHz = 200, .watchdog = Seconds(0.123), .onExit = OnExit::Brake, .driveLimitMargin = 7.5_deg};
    changed.mount.directions = Directions::Unconfirmed;
    changed.limits = {.azimuth = {-100.5_deg, 200.25_deg},
                      .elevation = {-5_deg, 89.995_deg},
                      .horizon = {{0_deg, 5_deg}, {123.456789012_deg, -90_deg}, {359.999999_deg, 5.5_deg}},
                      .keepOuts = {{"mast \"2\"", 350_deg, 10_deg, 40_deg, 90_deg},
                                   {"Sun's shed", 0_deg, 0.001_deg, -90_deg, -89_deg}}};
    changed.antennas = {{.name = "70 cm \"X\"", .beamWidth = 20.5_deg, .across = -2.25_deg, .up = 3.5_deg},
                        {.name = "Ω", .beamWidth = 0.01_deg}};
    changed.orbit.refraction = ephemeris::RefractionRule::Radio;
    changed.satellites = {{.number = 25544, .favourite = orbit::Favourite::On, .note = "145.800 MHz \"FM\", RHCP"},
                          {.number = 33591, .note = "", .antenna = "70 cm \"X\""}};
    changed.schedule.watch = {{.number = 25544, .priority = 2, .leastElevation = 5.5_deg}, {.number = 33591}};
    changed.presets = {{"north", {0_deg, 0_deg}}, {"over the top \\", {359.5_deg, 180_deg}}};
    changed.site = {.known = true, .latitude = 38.7223_deg, .longitude = -9.1393_deg, .heightMetres = 102.25};
    changed.sun = {.keepAway = KeepAway::On, .clock = SunClock::Trusted, .radius = 7.25_deg};
    changed.rotctld = {.listen = {"::", 0},
                       .allow = {"10.0.0.0/8", "fe80::1%a\"b"},
                       .control = ControlRule::Locked,
                       .lockedTo = "192.168.1.7",
                       .outsideLimits = OutsideLimits::Refuse,
                       .azimuth = AzimuthConvention::Continuous,
                       .maxClients = 7};
    changed.mqtt = {.host = "fe80::1%eth0",
                    .port = 8883,
                    .user = "mount \"2\"",
                    .password = "a\\b \"c\" Ω#",
                    .tls = Tls::On,
                    .caFile = "/etc/ca file.pem",
                    .clientId = "b1",
                    .publish = Publish::On,
                    .prefix = "shack/mount",
                    .commands = BrokerCommands::Drive,
                    .homeAssistant = HomeAssistant::On,
                    .discoveryPrefix = "ha/found"};
    const auto again = parseProfile(toToml(changed), QStringLiteral("m.toml"));
    ASSERT_TRUE(again) << textOf(again.error());
    EXPECT_EQ(*again, changed);
}

// REQ-PROFILE-03: An unknown key or table, a wrong type, a value out of range or not finite, an incomplete row or site
// is refused with file, line, key and reason. All errors are reported at once, in the order of their lines.
TEST(ProfileFile, TellsAllErrorsAtOnceInTheOrderOfTheirLines)
{
    EXPECT_EQ(errorsOf("version = 1\n"                          // 1
                       "colour = \"red\"\n"                     // 2
                       "[azimuth]\n"                            // 3
                       "id = 127\n"                             // 4
                       "travel_min_deg = \"none\"\n"            // 5
                       "max_sped_deg_s = 3\n"                   // 6
                       "travel_max_deg = -100\n"                // 7
                       "[elevation]\n"                          // 8
                       "id = 1\n"                               // 9
                       "sign = 1.0\n"                           // 10
                       "gear_in = \"motor\"\n"                  // 11
                       "[weather]\n"                            // 12
                       "rain = true\n"                          // 13
                       "[control]\n"                            // 14
                       "watchdog_s = nan\n"                     // 15
                       "tick_hz = true\n"                       // 16
                       "[park]\n"                               // 17
                       "elevation_deg = -5\n"                   // 18
                       "[rotctld]\n"                            // 19
                       "listen = \"4533\"\n"                    // 20
                       "max_clients = 9223372036854775807\n"),  // 21
              "m.toml:2: colour: unknown key\n"
              "m.toml:4: azimuth.id: 127 is outside 1…126\n"
              "m.toml:5: azimuth.travel_min_deg: a number is expected\n"
              "m.toml:5: azimuth.travel_min_deg: -90.00° is not below azimuth.travel_max_deg (-100.00°)\n"
              "m.toml:6: azimuth.max_sped_deg_s: unknown key\n"
              "m.toml:9: elevation.id: is the same as azimuth.id. Each controller needs its own id.\n"
              "m.toml:10: elevation.sign: a whole number is expected\n"
              "m.toml:11: elevation.gear_in: \"motor\" is not one of \"drive\", \"host\"\n"
              "m.toml:12: weather: unknown table\n"
              "m.toml:15: control.watchdog_s: a finite number is expected\n"
              "m.toml:16: control.tick_hz: a number or a text in quotes is expected\n"
              "m.toml:18: park.elevation_deg: -5.00° is outside the travel 0.00°…90.00°\n"
              "m.toml:20: rotctld.listen: HOST:PORT with a port of 0…65535 is expected\n"
              "m.toml:21: rotctld.max_clients: 9223372036854775808 is outside 1…5000");
}

// REQ-PROFILE-03
TEST(ProfileFile, TellsWhichRowsCannotBeRead)
{
    EXPECT_EQ(errorsOf("version = 1\n"                                   // 1
                       "preset = 3\n"                                    // 2
                       "[limits]\n"                                      // 3
                       "horizon = [\n"                                   // 4
                       "  [0, -5], [10], [20, \"low\"], [30.5, -91],\n"  // 5
                       "  [360, -2], 7\n"                                // 6
                       "]\n"                                             // 7
                       "[[keep_out]]\n"                                  // 8
                       "name = \"mast\"\n"                               // 9
                       "azimuth_from_deg = 350\n"                        // 10
                       "colour = \"red\"\n"                              // 11
                       "[[keep_out]]\n"                                  // 12
                       "name = \"two\\nlines\"\n"                        // 13
                       "azimuth_from_deg = -10\n"                        // 14
                       "azimuth_to_deg = 20\n"                           // 15
                       "elevation_min_deg = 40\n"                        // 16
                       "elevation_max_deg = true\n"                      // 17
                       "[site]\n"                                        // 18
                       "longitude_deg = -9.1\n"                          // 19
                       "[rotctld]\n"                                     // 20
                       "allow = [\"10.0.0.0/8\", 10]\n"                  // 21
                       "locked_to = [\"::1\"]\n"),                       // 22
              "m.toml:2: preset: \"[[preset]]\" is expected\n"
              "m.toml:5: limits.horizon[2]: a point is [azimuth, elevation]\n"
              "m.toml:5: limits.horizon[3]: a number is expected\n"
              "m.toml:5: limits.horizon[4]: -91 is outside -90…90\n"
              "m.toml:6: limits.horizon[5]: 360 is outside 0…359.999999\n"
              "m.toml:6: limits.horizon[6]: a point is [azimuth, elevation]\n"
              "m.toml:8: keep_out[1]: missing: azimuth_to_deg, elevation_min_deg, elevation_max_deg. The keys of "
              "this table are only valid together.\n"
              "m.toml:11: keep_out[1].colour: unknown key\n"
              "m.toml:13: keep_out[2].name: one line of 1 to 60 bytes is expected\n"
              "m.toml:14: keep_out[2].azimuth_from_deg: -10 is outside 0…359.999999\n"
              "m.toml:17: keep_out[2].elevation_max_deg: a number or a text in quotes is expected\n"
              "m.toml:18: site: missing: latitude_deg, height_m. The keys of this table are only valid "
              "together.\n"
              "m.toml:21: rotctld.allow: a number or a text in quotes is expected\n"
              "m.toml:22: rotctld.locked_to: a text in quotes is expected");
}

// REQ-SCHEDULE-945: A satellite of the watch list, or with a star, needs only its number in the file. Each other key
// has a default, which the comment names.
TEST(ProfileFile, ASatelliteNeedsOnlyItsNumber)
{
    const auto read =
        parseProfile("version = 1\n[[watch]]\nnorad = 25544\n[[satellite]]\nnorad = 7\nfavourite = \"on\"\n",
                     QStringLiteral("m.toml"));
    ASSERT_TRUE(read) << textOf(read.error());
    EXPECT_EQ(read->schedule.watch,
              (std::vector<schedule::WatchEntry>{{.number = 25544, .priority = 1, .leastElevation = 10_deg}}));
    EXPECT_EQ(read->satellites, (orbit::SatelliteMarks{{.number = 7, .favourite = orbit::Favourite::On, .note = {}}}));
    const std::string written = toToml(*read);
    EXPECT_NE(written.find("1 is the most important. 1…99; default 1\n"), std::string::npos);
    EXPECT_NE(written.find("above this elevation counts. 0.0…89.0 °; default 10.0\n"), std::string::npos);
    EXPECT_EQ(textOf(parseProfile("version = 1\n[[watch]]\npriority = 2\n", QStringLiteral("m.toml")).error()),
              "m.toml:2: watch[1]: missing: norad. The keys of this table are only valid together.");
}

// REQ-ANTENNA-921: Antennas are rows of the profile: name, beam width, offsets across and up. The antenna of a
// satellite may be left out, as in older files with one antenna. Invalid values are refused with line and key.
TEST(ProfileFile, AntennasAreRows)
{
    const auto read = parseProfile(
        "version = 1\n[[antenna]]\nname = \"70 cm\"\nbeam_width_deg = 20\n"
        "offset_across_deg = -1.5\noffset_up_deg = 2\n"
        "[[satellite]]\nnorad = 25544\nfavourite = \"on\"\nnote = \"\"\n"
        "[[satellite]]\nnorad = 7\nfavourite = \"off\"\nnote = \"\"\nantenna = \"70 cm\"\n",
        QStringLiteral("m.toml"));
    ASSERT_TRUE(read) << textOf(read.error());
    EXPECT_EQ(
        read->antennas,
        (std::vector<pointing::Antenna>{{.name = "70 cm", .beamWidth = 20_deg, .across = -1.5_deg, .up = 2_deg}}));
    EXPECT_EQ(read->satellites[0].antenna, "");
    EXPECT_EQ(read->satellites[1].antenna, "70 cm");
    EXPECT_EQ(errorsOf("version = 1\n"            // 1
                       "[[antenna]]\n"            // 2
                       "name = \"main\"\n"        // 3
                       "beam_width_deg = 20\n"    // 4
                       "offset_across_deg = 0\n"  // 5
                       "offset_up_deg = 0\n"      // 6
                       "[[satellite]]\n"          // 7
                       "norad = 25544\n"          // 8
                       "favourite = \"on\"\n"     // 9
                       "note = \"\"\n"            // 10
                       "antenna = \"2 m\"\n"),    // 11
              "m.toml:3: antenna[1].name: \"main\" is the name of the antenna that the table mount describes. Choose "
              "another name.\n"
              "m.toml:11: satellite[1].antenna: There is no antenna \"2 m\". Name one of \"main\", or add "
              "[[antenna]] with this name.");
    EXPECT_EQ(errorsOf("version = 1\n[[antenna]]\nname = \"x\"\nbeam_width_deg = 0\noffset_across_deg = 11\n"
                       "offset_up_deg = -31\n"),
              "m.toml:4: antenna[1].beam_width_deg: 0 is outside 0.01…180\n"
              "m.toml:5: antenna[1].offset_across_deg: 11 is outside -10…10\n"
              "m.toml:6: antenna[1].offset_up_deg: -31 is outside -30…30");
}

// REQ-PROFILE-03
TEST(ProfileFile, TellsWhichRowsMakeNoSense)
{
    EXPECT_EQ(errorsOf("version = 1\n"                                       // 1
                       "[limits]\n"                                          // 2
                       "azimuth_min_deg = 460\n"                             // 3
                       "horizon = [ [0, -5], [30.5, -6],\n"                  // 4
                       "            [30.5, -2] ]\n"                          // 5
                       "[[keep_out]]\n"                                      // 6
                       "name = \"mast\"\n"                                   // 7
                       "azimuth_from_deg = 350\n"                            // 8
                       "azimuth_to_deg = 10\n"                               // 9
                       "elevation_min_deg = 40\n"                            // 10
                       "elevation_max_deg = 30\n"                            // 11
                       "[[preset]]\n"                                        // 12
                       "name = \"n\"\nazimuth_deg = 0\nelevation_deg = 0\n"  // 13
                       "[[preset]]\n"                                        // 16
                       "name = \"n\"\nazimuth_deg = 9\nelevation_deg = 0\n"  // 17
                       "[rotctld]\n"                                         // 20
                       "lead = \"locked\"\n"),                               // 21
              "m.toml:3: limits.azimuth_min_deg: The limits 460.00°…3600.00° do not overlap the travel "
              "-90.00°…450.00°.\n"
              "m.toml:5: limits.horizon[3]: Azimuth 30.50° does not follow 30.50°. The azimuths must ascend, "
              "each once.\n"
              "m.toml:10: keep_out[1].elevation_min_deg: 40.00° is not below elevation_max_deg (30.00°)\n"
              "m.toml:17: preset[2].name: The name \"n\" is used twice.\n"
              "m.toml:20: rotctld.locked_to: is needed while rotctld.lead is \"locked\"");
    EXPECT_EQ(errorsOf("version = 1\nrotctld.allow = [\"10.0.0.0/8\", \"10.1\"]\n"),
              "m.toml:2: rotctld.allow: \"10.1\" is not an address like 192.168.1.7 or ::1");
    EXPECT_EQ(errorsOf("version = 1\n[preset]\nname = \"n\"\n"), "m.toml:2: preset: \"[[preset]]\" is expected");
    EXPECT_EQ(errorsOf("version = 1\nkeep_out = [1]\n"), "m.toml:2: keep_out[1]: a table is expected");
}

// REQ-PROFILE-07: The file has a version. Another version is refused, not guessed at.
TEST(ProfileFile, IsVersioned)
{
    EXPECT_EQ(errorsOf(""), "m.toml:1: version: \"version = 1\" is expected");
    EXPECT_EQ(errorsOf("\nversion = \"1\"\n"), "m.toml:2: version: \"version = 1\" is expected");
    EXPECT_EQ(errorsOf("version = 2\n"), "m.toml:1: version: 2 is not known to this program, which reads version 1");
}

// REQ-PROFILE-03
TEST(ProfileFile, ASettingInTheWrongPlaceIsUnknown)
{
    EXPECT_EQ(errorsOf("version = 1\nid = 1\n"), "m.toml:2: id: unknown key");
    EXPECT_EQ(errorsOf("version = 1\nazimuth = 3\n"), "m.toml:2: azimuth: unknown key");
    EXPECT_EQ(errorsOf("version = 1\n[azimuth.id]\nx = 1\n"),
              "m.toml:2: azimuth.id: a number or a text in quotes is expected");
    EXPECT_EQ(errorsOf("version = 1\n\"azimuth.id\" = 3\n"), "m.toml:2: azimuth.id: unknown key");
    EXPECT_EQ(errorsOf("version = 1\n\"limits.horizon\" = []\n"), "m.toml:2: limits.horizon: unknown key");
    EXPECT_EQ(errorsOf("version = 1\nazimuth.id = 3\n"), "accepted");
    EXPECT_EQ(errorsOf("version = 1\n[[bus]]\nname = \"simulated\"\n"), "m.toml:2: bus: unknown key");
}

// Found by the fuzzer: text from a file must not break the line of the error, or the terminal that shows it.
TEST(ProfileFile, ErrorsShowNoControlCharacters)
{
    EXPECT_EQ(errorsOf("version = 1\n\"a\\nb\" = 1\n"), "m.toml:2: a?b: unknown key");
    EXPECT_EQ(
        errorsOf("version = 1\n[bus]\nname = \"\\u001b[2J\\u0000\"\n"),
        "m.toml:3: bus.name: unknown bus '?[2J?'. Write simulated, socketcan:INTERFACE, fdcanusb:PATH, serial:PATH, "
        "tcp:HOST:PORT, rotctld:HOST:PORT or hamlib:MODEL:PORT");
    EXPECT_EQ(errorsOf("version = 1\n\x1b = 1\n").find('\x1b'), std::string::npos);
}

// Found by the fuzzer: TOML does not allow raw control characters, so a profile with one in a name was written but
// could not be read again.
// REQ-BASE-07: Names and texts of a profile contain no control characters, so that a written profile can be read.
TEST(ProfileFile, RefusesControlCharacters)
{
    EXPECT_EQ(errorsOf("version = 1\nmount.name = \"mast\\u007f\"\n"),
              "m.toml:2: mount.name: one line of 1 to 60 bytes is expected");
    for (const char* const bad : {"bus.name = \"socketcan:can0\\n\"", "bus.name = \"fdcanusb:/dev/a\\u007f\"",
                                  "rotctld.listen = \"a\\u007f:4533\""}) {
        EXPECT_NE(errorsOf(std::string("version = 1\n") + bad + "\n"), "accepted") << bad;
    }
}

// Found by the fuzzer: a travel of 1e-320° was accepted, written as 0°, and then refused.
TEST(ProfileFile, ANumberHasNoMoreDecimalsThanTheFile)
{
    EXPECT_EQ(errorsOf("version = 1\nelevation.travel_max_deg = 1e-320\n"),
              "m.toml:2: elevation.travel_min_deg: 0.00° is not below elevation.travel_max_deg (0.00°)");
    const auto profile = parseProfile("version = 1\npark.azimuth_deg = 12.3456789012345\n", QStringLiteral("m.toml"));
    ASSERT_TRUE(profile) << textOf(profile.error());
    EXPECT_EQ(profile->park.azimuth, Angle::fromDegrees(12.345678901));
    EXPECT_EQ(parseProfile(toToml(*profile), QStringLiteral("m.toml")), profile);
}

TEST(ProfileFile, BrokenSyntaxNamesItsLine)
{
    const std::string text = errorsOf("version = 1\n[azimuth\nid = 1\n");
    EXPECT_TRUE(text.starts_with("m.toml:2: ")) << text;
    EXPECT_TRUE(errorsOf("version = 1\nversion = 1\n").starts_with("m.toml:2: "));
    EXPECT_TRUE(errorsOf("version = 1\n[mount]\nname = \"\xff\"\n").starts_with("m.toml:3: "));
}

TEST(ProfileFile, TheDummyLikeProfileOfTheTestsIsValid)
{
    const auto profile = loadProfile(QStringLiteral(BORESIGHT_TEST_DATA "/dummy-like.toml"));
    ASSERT_TRUE(profile) << textOf(profile.error());
    EXPECT_EQ(profile->azimuth.geometry.travel, (TravelRange{-180_deg, 450_deg}));
    EXPECT_EQ(profile->rotctld.outsideLimits, OutsideLimits::Refuse);
    EXPECT_EQ(profile->park, AxisPosition{});
}

// REQ-PROFILE-09: Saving is all or nothing. The last change can be undone, and this undo too.
TEST(ProfileFile, SavesAllOrNothing)
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("mount.toml"));
    Profile profile;
    profile.mount.name = "first";
    ASSERT_TRUE(saveProfile(profile, path));
    const QByteArray first = contentOf(path);
    const auto loaded = loadProfile(path);
    ASSERT_TRUE(loaded);
    EXPECT_EQ(loaded->mount.name, "first");

    const auto refused = saveProfile(profile, folder.filePath(QStringLiteral("absent/mount.toml")));
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::Io);
    EXPECT_NE(textOf(refused.error()).find("absent/mount.toml: "), std::string::npos);
    EXPECT_EQ(contentOf(path), first);
    EXPECT_EQ(QDir(folder.path()).entryList(QDir::Files).size(), 1);  // no temporary file is left behind
}

// REQ-ELEMENTWEB-01
TEST(ProfileFile, AddressesOfElementsAreCheckedWithTheirKey)
{
    EXPECT_EQ(errorsOf("version = 1\n[orbit]\nelements = [\"/srv/a.tle\", \"celestrak:stations\", "
                       "\"https://example.org/a\"]\n"),
              "accepted");
    for (const auto& [entry, reason] :
         {std::pair("http://example.org/a", "does not begin with https://"),
          std::pair("celestrak:a b", "is not the name of a CelesTrak group"), std::pair("a.tle", "a path from / on")}) {
        const std::string errors = errorsOf(std::string("version = 1\n[orbit]\nelements = [\"") + entry + "\"]\n");
        EXPECT_NE(errors.find("orbit.elements"), std::string::npos) << errors;
        EXPECT_NE(errors.find(reason), std::string::npos) << errors;
    }
}

TEST(ProfileFile, AnAbsentFileIsNoDevice)
{
    const auto profile = loadProfile(QStringLiteral("/nowhere/mount.toml"));
    ASSERT_FALSE(profile);
    EXPECT_EQ(profile.error().code, ErrorCode::NoDevice);
}
