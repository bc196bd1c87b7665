// SPDX-License-Identifier: GPL-3.0-or-later
// boresightctl plan, started as from a shell.
#include "tests/app/ctl_sky_fixture.h"

#include <gmock/gmock.h>

namespace boresight {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

const std::string kSite =
    "version = 1\n"
    "[site]\n"
    "latitude_deg = 38.757\n"
    "longitude_deg = -9.117\n"
    "height_m = 80\n";

class CtlPlanTest : public CtlSkyFixture
{
protected:
    Outcome plan(const std::string& profile, const char* more) const
    {
        const QStringList line{QStringLiteral("plan"), QStringLiteral("--elements"), elements,
                               QStringLiteral("--profile"), write("mount.toml", profile)};
        return ctl(line + words("--norad 25544 --from 2024-05-10T04:00:00Z") + words(more));
    }

    QString elements = write("sats.tle", kStation);
};

}  // namespace

// REQ-CTL-997: `plan` prints how the mount of a profile can track the next pass of a satellite: the chosen plan first,
// the others beside it, each with start, forecast error, ramp and unwrap, as CSV, JSON or a table.
TEST_F(CtlPlanTest, PrintsTheChosenPlanAndTheOthers)
{
    const Outcome csv = plan(kSite, "--format csv");
    EXPECT_EQ(csv.status, 0) << csv.errors;
    EXPECT_EQ(csv.errors, "");
    EXPECT_THAT(csv.output,
                AllOf(StartsWith("plan,chosen,start_az,start_el,end_az,peak_deg,rms_deg,peak_db,beyond_s,hidden_s,"
                                 "to_start_s,margin_deg,ramp_utc,unwrap_utc,pass_utc\n"
                                 "direct,yes,301.8"),
                      HasSubstr("2024-05-10T04:50:01.32")));
    EXPECT_THAT(plan(kSite, "--format json").output, StartsWith("[\n{\"plan\": \"direct\", \"chosen\": \"yes\", "));
    EXPECT_THAT(plan(kSite, "--format table").output, HasSubstr("\ndirect  yes "));
}

// REQ-CTL-998: A cable that ends during the pass is known before: the plan has the time of the unwrap and the time
// that is lost.
TEST_F(CtlPlanTest, ReportsThatTheCableEnds)
{
    const Outcome csv = plan(kSite + "[azimuth]\ntravel_min_deg = -120\ntravel_max_deg = 240\n", "--bound 1");
    EXPECT_EQ(csv.status, 0) << csv.errors;
    EXPECT_THAT(csv.output, testing::ContainsRegex("\n(unwraps|waits),yes,"));
}

// REQ-CTL-997
TEST_F(CtlPlanTest, PrintsTheMotionOfTheChosenPlan)
{
    const Outcome csv = plan(kSite, "--motion on");
    EXPECT_THAT(csv.output, StartsWith("t_utc,az_deg,el_deg,target_az_deg,target_el_deg,error_deg,hidden\n"
                                       "2024-05-10T04:50:01.32"));
}

TEST_F(CtlPlanTest, NamesWhatIsMissing)
{
    const Outcome noSite = plan("version = 1\n", "--format csv");
    EXPECT_EQ(noSite.status, 1);
    EXPECT_THAT(noSite.errors, HasSubstr("The site of the mount is not set. Enter it in the profile."));
    const Outcome oneAxis = plan(kSite + "[azimuth]\ndriver = \"none\"\n", "--format csv");
    EXPECT_EQ(oneAxis.status, 1);
    EXPECT_THAT(oneAxis.errors, HasSubstr("This mount has one axis."));
    const Outcome never =
        plan("version = 1\n[site]\nlatitude_deg = 89\nlongitude_deg = 0\nheight_m = 0\n", "--format csv");
    EXPECT_EQ(never.status, 1);
    EXPECT_THAT(never.errors, HasSubstr("ISS (ZARYA) (25544) does not rise in the 3 days after this time."));
    EXPECT_EQ(ctl({QStringLiteral("plan")}).status, 2);
}

}  // namespace boresight
