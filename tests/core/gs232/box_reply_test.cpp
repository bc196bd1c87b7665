// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gs232/box_reply.h"

#include <gtest/gtest.h>

#include <string>

namespace boresight::gs232 {
namespace {

Reply at(Dialect dialect, std::optional<double> azimuth, std::optional<double> elevation)
{
    Position position{.dialect = dialect, .azimuth = {}, .elevation = {}};
    if (azimuth) {
        position.azimuth = Angle::fromDegrees(*azimuth);
    }
    if (elevation) {
        position.elevation = Angle::fromDegrees(*elevation);
    }
    return position;
}

// REQ-GS232-03: Both dialects are read, as real control boxes and their imitations write them.
TEST(BoxReply, BothDialectsAreRead)
{
    const auto none = std::nullopt;
    EXPECT_EQ(parseReply("+0180+0090"), at(Dialect::A, 180.0, 90.0));
    EXPECT_EQ(parseReply("+0100"), at(Dialect::A, 100.0, none));
    EXPECT_EQ(parseReply("+180+090"), at(Dialect::A, 180.0, 90.0));
    EXPECT_EQ(parseReply("+0370+0005"), at(Dialect::A, 370.0, 5.0)) << "370 is not 10";
    EXPECT_EQ(parseReply("-0010+0003"), at(Dialect::A, -10.0, 3.0));
    EXPECT_EQ(parseReply("+0180.5+0090.0"), at(Dialect::A, 180.5, 90.0));
    EXPECT_EQ(parseReply("AZ=180  EL=090"), at(Dialect::B, 180.0, 90.0));
    EXPECT_EQ(parseReply("AZ=180 EL=090"), at(Dialect::B, 180.0, 90.0));
    EXPECT_EQ(parseReply("AZ=180EL=090"), at(Dialect::B, 180.0, 90.0));
    EXPECT_EQ(parseReply("AZ=450"), at(Dialect::B, 450.0, none));
    EXPECT_EQ(parseReply("EL=045"), at(Dialect::B, none, 45.0));
    EXPECT_EQ(parseReply(">AZ=100  EL=010"), at(Dialect::B, 100.0, 10.0)) << "behind a prompt";
}

// REQ-GS232-04: An incomplete line is never read as a number.
TEST(BoxReply, AHalfLineIsUnknown)
{
    const std::string a = "+0180+0095";
    for (std::size_t size = 6; size < a.size(); ++size) {
        EXPECT_EQ(parseReply(a.substr(0, size)), Reply(Unknown{})) << a.substr(0, size);
    }
    const std::string b = "AZ=180  EL=095";
    for (std::size_t size = 1; size < b.size(); ++size) {
        const std::string half = b.substr(0, size);
        // The azimuth is complete. A query of both angles does not accept this reply.
        const bool azimuthOnly = half == "AZ=180" || half == "AZ=180 " || half == "AZ=180  ";
        EXPECT_EQ(parseReply(half), azimuthOnly ? at(Dialect::B, 180.0, std::nullopt) : Reply(Unknown{})) << half;
    }
}

TEST(BoxReply, OthersAreTold)
{
    EXPECT_EQ(parseReply("?>"), Reply(Refused{}));
    EXPECT_EQ(parseReply(""), Reply(Nothing{}));
    EXPECT_EQ(parseReply(">"), Reply(Nothing{}));
    EXPECT_EQ(parseReply("C2"), Reply(Echo{}));
    EXPECT_EQ(parseReply("W123 046"), Reply(Echo{}));
    for (const char* const unknown : {"\xfe\xfe\xe0\x94\x03\xfd", "IF00014250000     +00000000002000000 ;", "AZ 123.4",
                                      "RPRT 0", "AZ=1e3 EL=000", "AZ=999  EL=000", "AZ=inf EL=nan", "AZ=180  EL=0.5.5",
                                      "AZ=180. EL=090", "+ 180+ 090", "++180", "+0180+0900+1", "AZ=+180 EL=-", "?"}) {
        const Reply reply = parseReply(unknown);
        EXPECT_FALSE(std::holds_alternative<Position>(reply)) << unknown;
    }
}

}  // namespace
}  // namespace boresight::gs232
