// SPDX-License-Identifier: GPL-3.0-or-later
// boresightctl ephemeris and passes, started as from a shell.
#include "tests/app/ctl_sky_fixture.h"

#include <QDir>

#include <gmock/gmock.h>

#include <string>
#include <vector>

namespace boresight {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

const std::string kLowOne =
    "SURFSAT\n"
    "1 43614U 18070B   23023.23658432  .02464742  16729-6  12889-2 0  9997\n"
    "2 43614  92.9861 193.5020 0006565 284.8196  75.2375 16.20243383245524\n";
const std::string kDamaged =
    "1 33591U 09005A   23023.55811021  .00000311  00000+0  19296-3 0  9992\n"
    "2 33591  99.1220  67.0323 0012994 290.9949  68.9832 14.12673821719520\n";

class CtlSkyTest : public CtlSkyFixture
{
protected:
    // The ephemeris of the ISS over Lisbon.
    Outcome ephemeris(const char* more, const QByteArray& times) const
    {
        const QStringList line{QStringLiteral("ephemeris"), QStringLiteral("--elements"), elements};
        return ctl(line + words("--norad 25544 --site 38.757,-9.117,80 --times -") + words(more), times);
    }

    QString elements = write("sats.tle", kStation + kLowOne);
};

}  // namespace

// REQ-CTL-04: `ephemeris` prints the direction of a satellite, the Sun or the Moon at each of the times, as CSV with
// the columns t_utc, az_deg, el_deg, range_km, range_rate_km_s or dist_km, as JSON or as a table.
TEST_F(CtlSkyTest, EphemerisOfASatellite)
{
    const QByteArray times = "t_utc\n2024-05-10T04:50:02Z\n\n# higher\n1715316902,up\n";
    const Outcome csv = ephemeris("--format csv", times);
    EXPECT_EQ(csv.status, 0) << csv.errors;
    EXPECT_EQ(csv.output,
              "t_utc,az_deg,el_deg,range_km,range_rate_km_s\n"
              "2024-05-10T04:50:02Z,301.839621,0.040811,2339.173033,-6.766431224\n"
              "2024-05-10T04:55:02Z,237.368587,36.578225,659.965367,-1.227312311\n");
    EXPECT_EQ(csv.errors, "");
    EXPECT_EQ(ephemeris("--format json", times).output,
              "[\n"
              "{\"t_utc\": \"2024-05-10T04:50:02Z\", \"az_deg\": 301.839621, \"el_deg\": 0.040811, \"range_km\": "
              "2339.173033, \"range_rate_km_s\": -6.766431224},\n"
              "{\"t_utc\": \"2024-05-10T04:55:02Z\", \"az_deg\": 237.368587, \"el_deg\": 36.578225, \"range_km\": "
              "659.965367, \"range_rate_km_s\": -1.227312311}\n"
              "]\n");
    EXPECT_THAT(ephemeris("--format table", times).output,
                StartsWith("t_utc                     az_deg     el_deg     range_km  range_rate_km_s\n"
                           "2024-05-10T04:50:02Z  301.839621   0.040811  2339.173033     -6.766431224\n"));
}

// -6.766431224 km/s divided by 299792.458 km/s, computed by hand.
// REQ-CTL-995: `ephemeris --doppler on` adds the column doppler_factor: the received frequency divided by the
// transmitted frequency.
TEST_F(CtlSkyTest, EphemerisWithTheDopplerFactor)
{
    const QByteArray times = "2024-05-10T04:50:02Z\n";
    EXPECT_EQ(ephemeris("--doppler on", times).output,
              "t_utc,az_deg,el_deg,range_km,range_rate_km_s,doppler_factor\n"
              "2024-05-10T04:50:02Z,301.839621,0.040811,2339.173033,-6.766431224,1.000022570385\n");
    EXPECT_EQ(ephemeris("--doppler off", times).output, ephemeris("--format csv", times).output);
}

// Sæmundsson's formula (Meeus, 16.4) and the refractivity of ITU-R P.453, computed by another program.
// REQ-CTL-10: With --refraction, `ephemeris` raises the elevation by the optical or the radio refraction. Nothing else
// changes. Without the option there is no refraction.
TEST_F(CtlSkyTest, EphemerisThroughTheAir)
{
    const QByteArray times = "2024-05-10T04:50:02Z\n2024-05-10T04:55:02Z\n";
    EXPECT_THAT(ephemeris("--refraction light", times).output,
                StartsWith("t_utc,az_deg,el_deg,range_km,range_rate_km_s\n"
                           "2024-05-10T04:50:02Z,301.839621,0.517958,2339.173033,-6.766431224\n"
                           "2024-05-10T04:55:02Z,237.368587,36.60092"));
    EXPECT_EQ(ephemeris("--refraction radio", times).output,
              "t_utc,az_deg,el_deg,range_km,range_rate_km_s\n"
              "2024-05-10T04:50:02Z,301.839621,0.558171,2339.173033,-6.766431224\n"
              "2024-05-10T04:55:02Z,237.368587,36.602842,659.965367,-1.227312311\n");
    EXPECT_EQ(ephemeris("--refraction none", times).output, ephemeris("--format csv", times).output);
    const char* const moon = "ephemeris --site 38.757,-9.117,80 --times - --refraction light --body moon";
    EXPECT_EQ(ctl(words(moon), "2024-12-07T03:05:08Z\n").output,
              "t_utc,az_deg,el_deg,dist_km\n2024-12-07T03:05:08Z,296.129751,-51.589216,382045.561\n");
}

// REQ-CTL-04
TEST_F(CtlSkyTest, EphemerisOfTheMoonAndTheSun)
{
    const QByteArray times = "2024-12-07T03:05:08Z\n";
    const char* const line = "ephemeris --site 38.757,-9.117,80 --times - --body ";
    const Outcome moon = ctl(words((std::string(line) + "moon").c_str()), times);
    EXPECT_EQ(moon.status, 0) << moon.errors;
    EXPECT_EQ(moon.output, "t_utc,az_deg,el_deg,dist_km\n2024-12-07T03:05:08Z,296.129751,-51.589216,382045.561\n");
    EXPECT_THAT(ctl(words((std::string(line) + "sun").c_str()), times).output,
                StartsWith("t_utc,az_deg,el_deg,dist_km\n2024-12-07T03:05:08Z,75.8987"));
}

// REQ-CTL-05: A time without a result has a row without numbers. A line that is not a time has no row. Both are
// reported with their place, and the exit status is 1.
TEST_F(CtlSkyTest, EphemerisReportsWhatHasNoAnswer)
{
    const Outcome bad = ephemeris("--format csv", "2024-05-10T04:50:02Z\nsoon 2\n2023-99-01\n");
    EXPECT_EQ(bad.status, 1);
    EXPECT_THAT(bad.errors, HasSubstr("-:2: \"soon 2\" is not a time: expected UTC like"));
    EXPECT_THAT(bad.errors, HasSubstr("-:3: \"2023-99-01\" is not a time"));
    EXPECT_THAT(bad.output, HasSubstr("301.839621"));
    const Outcome later = ctl(QStringList{QStringLiteral("ephemeris"), QStringLiteral("--elements"), elements} +
                                  words("--norad 43614 --site 0,0,0 --times -"),
                              "2024-05-10T04:50:02Z\n");
    EXPECT_EQ(later.status, 1);
    EXPECT_THAT(later.output, HasSubstr("\n2024-05-10T04:50:02Z,,,,\n"));
    EXPECT_THAT(later.errors, HasSubstr("SURFSAT (43614) at 2024-05-10T04:50:02Z: The satellite has decayed."));
    const Outcome body = ctl(words("ephemeris --body sun --site 0,0,0 --times /nowhere/times"));
    EXPECT_EQ(body.status, 1);
    EXPECT_THAT(body.errors, StartsWith("/nowhere/times: "));
}

// REQ-CTL-941: `ephemeris --table` prints the directions of the table in a file, also of one that `ephemeris` itself
// has printed. An error in the file is reported with its line. A time outside the rows is reported like any time
// without a result.
TEST_F(CtlSkyTest, EphemerisOfATable)
{
    const Outcome printed = ephemeris("--format csv", "2024-05-10T04:50:02Z\n2024-05-10T04:51:02Z\n");
    ASSERT_EQ(printed.status, 0) << printed.errors;
    const auto led = [this](const std::string& text, const QByteArray& times) {
        return ctl(words("ephemeris --site 38.757,-9.117,80 --times - --table") << write("way.csv", text), times);
    };
    const Outcome same = led(printed.output, "2024-05-10T04:50:02Z\n");
    EXPECT_EQ(same.status, 0) << same.errors;
    EXPECT_EQ(same.output, "t_utc,az_deg,el_deg,range_km\n2024-05-10T04:50:02Z,301.839621,0.040811,\n");
    const Outcome late = led(printed.output, "2024-05-10T04:52:00Z\n");
    EXPECT_EQ(late.status, 1);
    EXPECT_THAT(late.output, HasSubstr("\n2024-05-10T04:52:00Z,,,\n"));
    EXPECT_THAT(late.errors, HasSubstr("The table of way.csv ended at 2024-05-10 04:51Z."));
    const Outcome bad = led("2024-05-10T04:50:02Z,301,95\n", "2024-05-10T04:50:02Z\n");
    EXPECT_EQ(bad.status, 1);
    EXPECT_THAT(bad.errors, HasSubstr("way.csv:1: The elevation is 95°."));
}

// REQ-CTL-06: `passes` lists the passes of satellites in the order of AOS, with the columns name, norad, aos_utc,
// aos_az, tca_utc, tca_az, max_el, los_utc, los_az, flags.
TEST_F(CtlSkyTest, PassesOfADay)
{
    const Outcome csv = passes(elements, "--norad 25544 --from 2024-05-10 --days 0.25");
    EXPECT_EQ(csv.status, 0) << csv.errors;
    EXPECT_EQ(csv.errors, "");
    EXPECT_EQ(csv.output,
              "name,norad,aos_utc,aos_az,tca_utc,tca_az,max_el,los_utc,los_az,flags\n"
              "ISS (ZARYA),25544,2024-05-10T00:00:00.000Z,303.2358,2024-05-10T00:03:00.889Z,347.5741,11.1248,"
              "2024-05-10T00:07:29.822Z,43.7951,A\n"
              "ISS (ZARYA),25544,2024-05-10T01:36:35.472Z,314.5190,2024-05-10T01:40:56.957Z,8.4627,9.9690,"
              "2024-05-10T01:45:17.817Z,62.4243,-\n"
              "ISS (ZARYA),25544,2024-05-10T03:13:23.271Z,315.6235,2024-05-10T03:18:33.175Z,28.1405,25.3523,"
              "2024-05-10T03:23:41.150Z,100.6196,-\n"
              "ISS (ZARYA),25544,2024-05-10T04:50:01.326Z,301.8645,2024-05-10T04:55:17.653Z,224.8033,37.3142,"
              "2024-05-10T05:00:31.670Z,147.4839,-\n");
    const Outcome high = passes(elements, "--norad 25544 --from 2024-05-10 --days 0.25 --min-el 30 --format json");
    EXPECT_THAT(high.output, StartsWith("[\n{\"name\": \"ISS (ZARYA)\", \"norad\": 25544, \"aos_utc\": "
                                        "\"2024-05-10T04:54:"));
    EXPECT_THAT(high.output, Not(HasSubstr("},\n")));
}

// REQ-CTL-06a: With the profile of a mount the flags show which passes are partly hidden from it, and during which the
// cable ends. Without a profile no mount is considered.
TEST_F(CtlSkyTest, PassesAreJudgedForAMount)
{
    const auto flagsWith = [this](const std::string& toml) {
        const QString line = QStringLiteral("--norad 25544 --from 2024-05-10 --days 0.25 --profile ");
        const Outcome found =
            passes(elements, (line + write("mount.toml", "version = 1\n" + toml)).toUtf8().constData());
        EXPECT_EQ(found.status, 0) << found.errors;
        std::vector<std::string> flags;
        for (const QString& row : QString::fromStdString(found.output).split(QLatin1Char('\n'), Qt::SkipEmptyParts)) {
            flags.push_back(row.section(QLatin1Char(','), -1).toStdString());
        }
        return flags;
    };
    using testing::ElementsAre;
    EXPECT_THAT(flagsWith(""), ElementsAre("flags", "A", "-", "-", "-")) << "a turn and a half of cable";
    const std::string azimuths = "[azimuth]\ntravel_min_deg = 0\ntravel_max_deg = 360\n[elevation]\n";
    EXPECT_THAT(flagsWith(azimuths), ElementsAre("flags", "AU", "U", "U", "-")) << "three go through north";
    EXPECT_THAT(flagsWith(azimuths + "travel_max_deg = 180\n"), ElementsAre("flags", "AUF", "UF", "UF", "-"));
    EXPECT_THAT(flagsWith("[limits]\nelevation_min_deg = 20\n[park]\nelevation_deg = 20\n"),
                ElementsAre("flags", "AH", "H", "H", "H"));
    EXPECT_EQ(passes(elements, "--from 2024-05-10 --days 0.1 --profile /nowhere/mount.toml").status, 1);
}

// REQ-CTL-07: What the list cannot show is reported: a satellite that decays, one that does not rise, bad element sets
// with file and line. Element sets without a name for their satellite are no failure. No usable set, or an unreadable
// site, is a failure.
TEST_F(CtlSkyTest, PassesReportWhatTheListCannotShow)
{
    const Outcome decayed = passes(elements, "--from 2023-01-30 --days 30 --norad 43614");
    EXPECT_EQ(decayed.status, 0);
    EXPECT_THAT(decayed.errors, HasSubstr("SURFSAT (43614): no passes after 2023-02-0"));
    const Outcome down = passes(elements, "--from 2024-05-10 --days 1 --min-el 89 --norad 25544");
    EXPECT_EQ(down.status, 0);
    EXPECT_EQ(down.output, "name,norad,aos_utc,aos_az,tca_utc,tca_az,max_el,los_utc,los_az,flags\n");
    EXPECT_THAT(down.errors, HasSubstr("ISS (ZARYA) (25544) does not rise above 89.0° in this time"));

    const QString damaged = write("damaged.tle", kStation + kDamaged);
    const Outcome some = passes(damaged, "--from 2024-05-10 --days 0.1");
    EXPECT_EQ(some.status, 0);
    EXPECT_THAT(some.errors, StartsWith(damaged.toStdString() + ":5: The checksum in column 69 is \"0\", expected 9."));
    EXPECT_THAT(some.output, HasSubstr("ISS (ZARYA)"));
    const Outcome none = passes(damaged, "--from 2024-05-10 --days 0.1 --norad 33591");
    EXPECT_EQ(none.status, 1);
    EXPECT_EQ(none.output, "");
    EXPECT_THAT(none.errors,
                HasSubstr("there is no usable element set of number 33591. With --elements name a file that has one"));
    EXPECT_EQ(passes(elements, "--from 2024-05-10 --days 0.1 --site /nowhere/home.qth").status, 1);
}

// REQ-CTL-08: The files of Gpredict can be used for elements and for the site.
TEST_F(CtlSkyTest, TheFilesOfGpredictAreUsed)
{
    ASSERT_TRUE(QDir(folder.path()).mkdir(QStringLiteral("satdata")));
    const std::string keys =
        "[Satellite]\nNAME=Station\nTLE1=" + kStation.substr(12, 70) + "TLE2=" + kStation.substr(82);
    write("satdata/25544.sat", keys);
    const QString module = write("mine.mod", "[GLOBAL]\nSATELLITES=25544;\nQTHFILE=home.qth\n");
    const QString site = write("home.qth", "[QTH]\nLAT=38.757\nLON=-9.117\nALT=80\n");
    const QStringList line = words("passes --from 2024-05-10T04:00:00Z --days 0.1");
    const Outcome found = ctl(line + QStringList{QStringLiteral("--elements"), module, QStringLiteral("--site"), site});
    EXPECT_EQ(found.status, 0) << found.errors;
    EXPECT_THAT(found.output, HasSubstr("\nStation,25544,2024-05-10T04:50:01.326Z,301.8645,"));
    const Outcome wrong = ctl(line + QStringList{QStringLiteral("--elements"), module, QStringLiteral("--site"),
                                                 write("bad.qth", "[QTH]\nLAT=38.757\n")});
    EXPECT_EQ(wrong.status, 1);
    EXPECT_THAT(wrong.errors, HasSubstr("bad.qth: LON is missing"));
}

}  // namespace boresight
