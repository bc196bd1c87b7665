// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/terms_text.h"

#include "tests/fakes/text_of.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>

namespace boresight::calibration {
namespace {

using ::testing::HasSubstr;

TermSheet fullTerms()
{
    TermSheet sheet{
        .mountName = "Roof, \"north\" é: 2",
        .when = UtcTime(std::chrono::sys_days{std::chrono::year{2026} / 11 / 22} + std::chrono::hours(1)),
        .mount = {.azimuthDrive = "18c0a7a5-2d94-4d3c-9d5e-0d1f0b7e1a01",
                  .elevationDrive = "18c0a7a5-2d94-4d3c-9d5e-0d1f0b7e1a02",
                  .site = RecordSite{Angle::fromDegrees(-38.7223), Angle::fromDegrees(-9.139312345), 120.5}},
        .terms = {},
        .sigmas = {}};
    for (const Term term : kAllTerms) {
        valueOf(sheet.terms, term) = Angle::fromDegrees(0.123456789 - 0.25 * static_cast<double>(indexOf(term)));
    }
    sheet.terms.azimuthOffset = Angle::fromDegrees(-337.4);
    sheet.sigmas[indexOf(Term::AzimuthOffset)] = 0.05_deg;
    sheet.sigmas[indexOf(Term::ElevationSag)] = Angle::fromDegrees(0.000000001);
    return sheet;
}

const std::string kSmall = R"(azimuth_offset 37.4 deg 0.05
elevation_offset 0 deg
tilt_north 0.48 deg -
tilt_east -21.6 arcmin 0.6
collimation 1080 arcsec 36
non_perpendicularity 0 deg
elevation_sag 0 deg
)";

std::string termsReason(const std::string& text)
{
    const auto sheet = parseTerms(text, QStringLiteral("roof.terms"));
    return sheet ? "accepted" : textOf(sheet.error());
}

std::string with(const std::string& what, const std::string& instead)
{
    std::string text = kSmall;
    const std::size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return at == std::string::npos ? text : text.replace(at, what.size(), instead);
}

// REQ-CALIBRATION-20 (TermsText.*): Terms can be exchanged as a small text with their mount, date, site and drives.
// Errors in a text are reported with their line.
TEST(TermsText, EverythingSurvives)
{
    const TermSheet sheet = fullTerms();
    const std::string text = toText(sheet);
    const auto read = parseTerms(text, QStringLiteral("roof.terms"));
    ASSERT_TRUE(read) << textOf(read.error());
    EXPECT_EQ(sheet.mountName, read->mountName);
    EXPECT_EQ(sheet.when, read->when);
    EXPECT_EQ(sheet.mount.azimuthDrive, read->mount.azimuthDrive);
    EXPECT_EQ(sheet.mount.elevationDrive, read->mount.elevationDrive);
    ASSERT_TRUE(read->mount.site);
    EXPECT_NEAR(-9.139312345, read->mount.site->longitude.degrees(), 1e-9);
    EXPECT_NEAR(120.5, read->mount.site->heightMetres, 1e-3);
    for (const Term term : kAllTerms) {
        EXPECT_NEAR(valueOf(sheet.terms, term).degrees(), valueOf(read->terms, term).degrees(), 1e-9);
        ASSERT_EQ(sheet.sigmas[indexOf(term)].has_value(), read->sigmas[indexOf(term)].has_value());
        if (const auto& sigma = sheet.sigmas[indexOf(term)]) {
            EXPECT_NEAR(sigma->degrees(), read->sigmas[indexOf(term)]->degrees(), 1e-9);
        }
    }
    EXPECT_EQ(text, toText(*read));
}

TEST(TermsText, NothingThatIsNotKnownIsInvented)
{
    const std::string text = toText(TermSheet{});
    EXPECT_EQ(std::string::npos, text.find("site:"));
    EXPECT_EQ(std::string::npos, text.find("drive:"));
    const auto read = parseTerms(text, QStringLiteral("bare.terms"));
    ASSERT_TRUE(read) << textOf(read.error());
    EXPECT_EQ(TermSheet{}, *read);
}

TEST(TermsText, ASigmaThatRoundsToNothingIsNotWritten)
{
    TermSheet sheet;
    sheet.sigmas[indexOf(Term::TiltNorth)] = Angle::fromDegrees(1e-12);
    EXPECT_EQ(toText(TermSheet{}), toText(sheet));
}

TEST(TermsText, IsReadableToPeople)
{
    EXPECT_THAT(toText(fullTerms()), HasSubstr("# mount: Roof, \"north\" é: 2\n# date: 2026-11-22T01:00:00Z\n"));
    EXPECT_THAT(toText(fullTerms()), HasSubstr("\nazimuth_offset        -337.400000000 deg  0.050000000\n"));
    EXPECT_THAT(toText(fullTerms()), HasSubstr("\nelevation_offset      -0.126543211   deg  -\n"));
}

TEST(TermsText, ReadsWhatPeopleType)
{
    const auto read = parseTerms("\xef\xbb\xbf# by hand: last summer\r\n\r\n  " + kSmall + "\t# the end",
                                 QStringLiteral("roof.terms"));
    ASSERT_TRUE(read) << textOf(read.error());
    EXPECT_NEAR(37.4, read->terms.azimuthOffset.degrees(), 1e-12);
    EXPECT_NEAR(-0.36, read->terms.tiltEast.degrees(), 1e-12);
    EXPECT_NEAR(0.01, read->sigmas[indexOf(Term::TiltEast)]->degrees(), 1e-12);
    EXPECT_NEAR(0.3, read->terms.collimation.degrees(), 1e-12);
    EXPECT_NEAR(0.01, read->sigmas[indexOf(Term::Collimation)]->degrees(), 1e-12);
    EXPECT_FALSE(read->sigmas[indexOf(Term::TiltNorth)]);
    EXPECT_FALSE(read->sigmas[indexOf(Term::ElevationOffset)]);
}

TEST(TermsText, SaysWhatIsWrongInWhichLine)
{
    EXPECT_EQ(
        "roof.terms:3: \"tilt_south\" is not a known term.\nroof.terms:7: tilt_north is missing. Write every term, "
        "also a term "
        "that is 0.",
        termsReason(with("tilt_north", "tilt_south")));
    EXPECT_EQ("roof.terms:1: \"37,4\" is not a number.", termsReason(with("37.4", "37,4")));
    EXPECT_EQ("roof.terms:1: \"nan\" is not a number.", termsReason(with("37.4", "nan")));
    EXPECT_EQ("roof.terms:8: \"tilt_east\" is already in line 4.", termsReason(kSmall + "tilt_east 1 deg\n"));
    EXPECT_EQ("roof.terms:7: The unit of \"elevation_sag\" is missing. Write deg, arcmin or arcsec.",
              termsReason(with("elevation_sag 0 deg", "elevation_sag 0")));
    EXPECT_EQ("roof.terms:5: \"rad\" is not a known unit. Write deg, arcmin or arcsec.",
              termsReason(with("1080 arcsec", "1080 rad")));
    EXPECT_EQ("roof.terms:2: The value of \"elevation_offset\" is missing.",
              termsReason(with("elevation_offset 0 deg", "elevation_offset")));
    EXPECT_EQ("roof.terms:1: \"0\" is not a sigma. Write a number above 0, or - for an unknown one.",
              termsReason(with("0.05", "0")));
    EXPECT_EQ("roof.terms:4: \"more\" is one value too many. A line has name, value, unit and sigma.",
              termsReason(with("arcmin 0.6", "arcmin 0.6 more")));
}

TEST(TermsText, SaysWhatIsWrongInTheHeader)
{
    EXPECT_EQ("accepted", termsReason("# site: 48.2 16.37 200\n# date: 2026-11-22T01:00:00Z\n" + kSmall));
    EXPECT_THAT(termsReason("# site: Vienna\n" + kSmall), HasSubstr("roof.terms:1: \"Vienna\" is not a site."));
    EXPECT_THAT(termsReason("# site: 98.2 16.37 200\n" + kSmall), HasSubstr("roof.terms:1: "));
    EXPECT_THAT(termsReason("\n# date: yesterday\n" + kSmall),
                HasSubstr("roof.terms:2: \"yesterday\" is not a date like"));
    // the time zone is missing
    EXPECT_THAT(termsReason("# date: 2026-11-22 01:00\n" + kSmall), HasSubstr("is not a date"));
    EXPECT_THAT(termsReason("# date: 9999-11-22T01:00:00Z\n" + kSmall), HasSubstr("is not a date"));
}

TEST(TermsText, AllIsToldAtOnceButNoFlood)
{
    EXPECT_EQ("e.terms:0: azimuth_offset", textOf(parseTerms("", QStringLiteral("e.terms")).error()).substr(0, 25));
    std::string rubbish;
    for (int i = 0; i < 1000; ++i) {
        rubbish += "x\x1b[2J 1 deg\n";
    }
    const std::string told = termsReason(rubbish);
    EXPECT_EQ(19, std::count(told.begin(), told.end(), '\n'));
    EXPECT_EQ(std::string::npos, told.find('\x1b'));
    EXPECT_EQ("roof.terms is too long to be the terms of a pointing model.", termsReason(std::string(200000, '#')));
}

}  // namespace
}  // namespace boresight::calibration
