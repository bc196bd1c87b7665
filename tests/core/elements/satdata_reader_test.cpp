// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/elements/satdata_reader.h"

#include "core/elements/element_reader.h"

#include <gmock/gmock.h>

#include <string>

using namespace boresight;
using namespace boresight::orbit;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

namespace {

const std::string kTle1 = "TLE1=1 25544U 98067A   24130.36689744  .00016024  00000+0  27777-3 0  9992\n";
const std::string kTle2 = "TLE2=2 25544  51.6381 147.8590 0003466 150.4670 338.5502 15.51043222452521\n";
const std::string kHead = "VERSION=1.1\nNAME=ISS (ZARYA)\nNICKNAME=Station\n";

std::vector<std::string> problemsOf(const ElementList& list)
{
    std::vector<std::string> lines;
    for (const ElementProblem& problem : list.problems) {
        lines.push_back(std::to_string(problem.line) + ": " + problem.reason.toStdString());
    }
    return lines;
}

}  // namespace

// REQ-ORBIT-07a: The satellite data of Gpredict are read: NUMBER.sat with one set, satellites.dat with many. The form
// is detected from the text. A bad set is reported with its line and the reason, and the others are used.
TEST(SatdataReader, ReadsTheFileOfASatellite)
{
    const ElementList list = readElements("[Satellite]\n" + kHead + kTle1 + kTle2 + "STATUS=1\n");
    EXPECT_THAT(problemsOf(list), IsEmpty());
    ASSERT_THAT(list.sets, SizeIs(1));
    EXPECT_EQ(list.sets[0].name, "ISS (ZARYA)");
    EXPECT_EQ(list.sets[0].number, 25544);
    EXPECT_NEAR(list.sets[0].inclination.degrees(), 51.6381, 1e-12);
}

// REQ-ORBIT-07a
TEST(SatdataReader, ReadsManyGroupsAndReportsTheBadOnes)
{
    std::string bad = kTle2;
    bad.replace(bad.find("51.6381"), 7, "51.6382");
    const ElementList list = readElements("\r\n[25544]\r\n" + kHead + kTle1 + bad + "\n[1]\n" + kTle1 +
                                          "[2]\nNAME=x\n[3]\n TLE2 = " + kTle2.substr(5) + kTle1);
    EXPECT_THAT(problemsOf(list), ElementsAre("7: The checksum in column 69 is \"1\", expected 2.",
                                              "9: TLE2 is missing.", "11: TLE1 is missing."));
    ASSERT_THAT(list.sets, SizeIs(1));
    EXPECT_EQ(list.sets[0].name, "") << "the name of another group";
}

TEST(SatdataReader, LeavesJsonToItsReader)
{
    for (const char* const text : {"[]", "[{\"OBJECT_NAME\":\"A\"}]", "[\n{}]", "[\"a\"]"}) {
        EXPECT_EQ(elementForm(text), ElementForm::Json) << text;
    }
    EXPECT_EQ(elementForm("[25544]\n"), ElementForm::Satdata);
}
