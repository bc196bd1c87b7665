// SPDX-License-Identifier: GPL-3.0-or-later
// boresightctl started as from a shell: its standard output, its errors and its exit status.
#include "tests/app/ctl_outcome.h"

#include <QTemporaryDir>

#include <gmock/gmock.h>

#include <fstream>

namespace boresight {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(Boresightctl, ExplainsItselfAndEverySubcommandWithAnExample)
{
    const Outcome all = ctl({QStringLiteral("help")});
    EXPECT_EQ(all.status, 0);
    for (const char* name : {"simulate", "scan", "decode", "check", "profile", "confirm-directions", "ephemeris",
                             "passes", "export", "replay", "goto", "stop", "park", "status", "schedule"}) {
        EXPECT_THAT(all.output, HasSubstr(name));
        const Outcome help = ctl({QStringLiteral("help"), QString::fromUtf8(name)});
        EXPECT_EQ(help.status, 0);
        EXPECT_THAT(help.output, HasSubstr("Example"));
        EXPECT_THAT(help.output, HasSubstr(std::string("\n  boresightctl ") + name));
        EXPECT_EQ(ctl({QString::fromUtf8(name), QStringLiteral("--help")}).output, help.output);
    }
}

TEST(Boresightctl, RefusesWhatMakesNoSense)
{
    EXPECT_EQ(ctl({}).status, 2);
    const Outcome unknown = ctl(words("dance"));
    EXPECT_EQ(unknown.status, 2);
    EXPECT_THAT(unknown.errors, HasSubstr("there is no subcommand \"dance\""));
    for (const char* line : {"scan", "scan canbus:7", "check", "profile", "profile --other", "decode", "simulate",
                             "confirm-directions", "simulate --pty /tmp/x --wind az:x", "ephemeris", "passes", "export",
                             "replay", "schedule", "schedule dance"}) {
        const Outcome refused = ctl(words(line));
        EXPECT_EQ(refused.status, 2) << line;
        EXPECT_THAT(refused.errors, HasSubstr("usage: boresightctl ")) << line;
        EXPECT_EQ(refused.output, "") << line;
    }
}

// From golden vectors such as c001: a stop with the client's default query, and a position command.
TEST(Decode, SaysAFrameInWords)
{
    const std::string stop =
        "request from 0 to drive 1, wants a reply\n"
        "write 0x000 mode 0 stopped (i8)\n"
        "read 0x000 mode as i8\n"
        "read 0x001 position as f32\n"
        "read 0x002 velocity as f32\n"
        "read 0x003 torque as f32\n"
        "read 0x00d voltage as i8\n"
        "read 0x00e temperature as i8\n"
        "read 0x00f fault as i8\n"
        "padding 3\n";
    EXPECT_EQ(ctl(words("decode 0x8001 01000011001f01130d505050")).output, stop);
    EXPECT_EQ(ctl(words("decode 8001 01 00 00 11 00 1f 01 13 0d 50 50 50")).output, stop);
    EXPECT_EQ(
        ctl({QStringLiteral("decode"), QStringLiteral("8001"), QStringLiteral("010000 11001F01130D 505050")}).output,
        stop);
    EXPECT_THAT(ctl(words("decode 100 21000A")).output, HasSubstr("reply of drive 1 to 0\n"));
}

TEST(Decode, SaysWhatIsWrong)
{
    const auto refusal = [](const char* line) {
        const Outcome outcome = ctl(words(line));
        EXPECT_EQ(outcome.status, 2) << line;
        return outcome.errors;
    };
    EXPECT_THAT(refusal("decode drive 00"), HasSubstr("\"drive\" is not a CAN identifier"));
    EXPECT_THAT(refusal("decode 20000000 00"), HasSubstr("29 bits"));
    EXPECT_THAT(refusal("decode 8001 0100x0"), HasSubstr("'x' at place 5"));
    EXPECT_THAT(refusal("decode 8001 010"), HasSubstr("an odd number"));
    const QString long65(130, QLatin1Char('0'));
    EXPECT_THAT(ctl({QStringLiteral("decode"), QStringLiteral("8001"), long65}).errors, HasSubstr("65 bytes"));
}

class ProfileFile : public testing::Test
{
protected:
    QString write(const std::string& text) const
    {
        const QString path = folder.filePath(QStringLiteral("mount.toml"));
        std::ofstream(path.toStdString()) << text;
        return path;
    }
    std::string read() const
    {
        std::ifstream file(folder.filePath(QStringLiteral("mount.toml")).toStdString());
        return {std::istreambuf_iterator<char>(file), {}};
    }
    Outcome confirm(const char* answer) const
    {
        fakes::Program program(QStringLiteral(BORESIGHTCTL),
                               {QStringLiteral("confirm-directions"), folder.filePath(QStringLiteral("mount.toml"))});
        program.type(answer);
        const int status = program.waitForEnd();
        return {status, program.output().toStdString(), program.errors().toStdString()};
    }

    QTemporaryDir folder;
};

TEST_F(ProfileFile, CheckTellsAllErrorsAtOnce)
{
    const QString path =
        write("version = 1\n[azimuth]\ncolour = 3\nmax_speed_deg_s = \"fast\"\n[control]\ntick_hz = 100000\n");
    const Outcome bad = ctl({QStringLiteral("check"), path});
    EXPECT_EQ(bad.status, 1);
    EXPECT_EQ(bad.output, "");
    EXPECT_THAT(bad.errors, HasSubstr("mount.toml:3: azimuth.colour"));
    EXPECT_THAT(bad.errors, HasSubstr("mount.toml:4: azimuth.max_speed_deg_s"));
    EXPECT_THAT(bad.errors, HasSubstr("mount.toml:6: control.tick_hz"));
}

TEST_F(ProfileFile, CheckKnowsRegionPresetsAndSite)
{
    const std::string region =
        "version = 1\n[limits]\nhorizon = [[0, -2], [180, -1]]\n"
        "[[keep_out]]\nname = \"mast\"\nazimuth_from_deg = 350\nazimuth_to_deg = 10\n"
        "elevation_min_deg = 40\nelevation_max_deg = 90\n"
        "[[preset]]\nname = \"west\"\nazimuth_deg = 270\nelevation_deg = 5\n"
        "[site]\nlatitude_deg = 38.7\nlongitude_deg = -9.1\nheight_m = 102\n";
    const Outcome good = ctl({QStringLiteral("check"), write(region)});
    EXPECT_EQ(good.status, 0) << good.errors;
    const Outcome bad = ctl({QStringLiteral("check"), write(region + "[park]\nazimuth_deg = 5\nelevation_deg = 50\n")});
    EXPECT_EQ(bad.status, 1);
    EXPECT_THAT(bad.errors, HasSubstr("mount.toml:20: park.elevation_deg: "));
    EXPECT_THAT(bad.errors, HasSubstr("lies in keep-out \"mast\". Permitted: azimuth axis 10.00°, elevation 50.00°."));
}

// REQ-PROFILE-04a
TEST_F(ProfileFile, CheckTellsWhatIsHardlyMeantWithItsNumbers)
{
    const Outcome told =
        ctl({QStringLiteral("check"), write("version = 1\n[azimuth]\nmax_acceleration_deg_s2 = 0.5\n"
                                            "max_jerk_deg_s3 = 5\n[elevation]\n"
                                            "max_acceleration_deg_s2 = 300\nmax_jerk_deg_s3 = 3000\n")});
    EXPECT_EQ(told.status, 0) << "the mount alone knows";
    EXPECT_THAT(told.output, HasSubstr("azimuth.max_acceleration_deg_s2: the azimuth needs 20.2 s and 101° to stop"));
    EXPECT_THAT(told.output, HasSubstr("elevation.max_acceleration_deg_s2: the elevation must reach"));
}

TEST_F(ProfileFile, CheckTellsOfAFileThatIsNotThere)
{
    const Outcome absent = ctl({QStringLiteral("check"), folder.filePath(QStringLiteral("absent.toml"))});
    EXPECT_EQ(absent.status, 1);
    EXPECT_THAT(absent.errors, HasSubstr("absent.toml"));
}

// REQ-PROFILE-06b
TEST_F(ProfileFile, DirectionsAreConfirmedByTypingYes)
{
    const std::string before = "# mine\nversion = 1\n[bus]\nname = \"socketcan:can0\"\n";
    write(before);
    for (const char* answer : {"", "y\n", "no\n"}) {
        const Outcome refused = confirm(answer);
        EXPECT_EQ(refused.status, 1) << answer;
        EXPECT_THAT(refused.errors, HasSubstr("The file is unchanged."));
        EXPECT_EQ(read(), before);
    }
    const Outcome confirmed = confirm("yes\n");
    EXPECT_EQ(confirmed.status, 0) << confirmed.errors;
    EXPECT_THAT(confirmed.output, HasSubstr("socketcan:can0"));
    EXPECT_THAT(confirmed.output, HasSubstr("M 16"));
    EXPECT_EQ(read(), before + "\n[mount]\ndirections = \"confirmed\"\n");
    EXPECT_THAT(confirm("").output, HasSubstr("confirmed already"));
}

// Story: for a mount with one axis it asked about the direction of the other axis, too.
TEST_F(ProfileFile, OnlyTheDirectionsOfItsAxesAreConfirmed)
{
    write("version = 1\n[bus]\nname = \"socketcan:can0\"\n[azimuth]\ndriver = \"none\"\n");
    const Outcome refused = confirm("no\n");
    EXPECT_THAT(refused.output, HasSubstr("at up to 8.0 °/s in elevation.\n"));
    EXPECT_THAT(refused.output, Not(HasSubstr("M 16")));
}

TEST_F(ProfileFile, TheDefaultProfileIsCommentedAndInOrder)
{
    const Outcome standard = ctl(words("profile --default"));
    EXPECT_EQ(standard.status, 0);
    EXPECT_THAT(standard.output, HasSubstr("\n# "));
    const Outcome checked = ctl({QStringLiteral("check"), write(standard.output)});
    EXPECT_EQ(checked.status, 0) << checked.errors;
    EXPECT_THAT(checked.output,
                HasSubstr("in order: \"Boresight mount\", bus simulated, azimuth moteus id 1, elevation moteus id 2"));
}

// Story: check named the id of a controller that the mount does not have.
TEST_F(ProfileFile, CheckNamesTheDriverOfEachAxis)
{
    const Outcome checked =
        ctl({QStringLiteral("check"), write("version = 1\n[bus]\nname = \"socketcan:can0\"\n[elevation]\ndriver = "
                                            "\"none\"\n")});
    EXPECT_EQ(checked.status, 0) << checked.errors;
    EXPECT_THAT(checked.output, HasSubstr("bus socketcan:can0, azimuth moteus id 1, no elevation\n"));
}

// Story: the table of a simulated mount looked like that of a real one.
// REQ-CTL-307: scan reports above its table that the boards of a bus are simulated.
TEST(Scan, ListsTheSimulatedPair)
{
    const Outcome scan = ctl(words("scan simulated"));
    EXPECT_EQ(scan.status, 0) << scan.errors;
    EXPECT_EQ(scan.errors, "");
    EXPECT_TRUE(scan.output.starts_with("The boards are simulated. No real drive answers.\nid  UUID")) << scan.output;
    EXPECT_THAT(scan.output, HasSubstr("\n1   626f7265-7369-6768-7420-73696d203031  1.1.0"));
    EXPECT_THAT(scan.output, HasSubstr("\n2   626f7265-7369-6768-7420-73696d203032  1.1.0"));
}

TEST(Scan, NamesTheBusThatIsNotThere)
{
    const Outcome scan = ctl(words("scan fdcanusb:/nowhere/adapter"));
    EXPECT_EQ(scan.status, 1);
    EXPECT_THAT(scan.errors, HasSubstr("/nowhere/adapter"));
    EXPECT_THAT(scan.errors, Not(HasSubstr("usage:")));
}

}  // namespace
}  // namespace boresight
