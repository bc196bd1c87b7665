// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/system/fault_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <set>
#include <string>

// Faults of every kind at every moment, with clients that keep asking for motion, judged by the true position of the
// antenna. Prints the rows of FAULTS.md. With BORESIGHT_FAULT_TABLE set, writes them into that file.
namespace boresight::system_test {
namespace {

const char* const kHeader =
    "| fault | moment | alarm (s) | az stands (s) | el stands (s) | moved away (°) | beyond travel (°) | state | "
    "moved before Re-arm (°) | drives | recovery | alarm |\n"
    "|---|---|---:|---:|---:|---:|---:|---|---:|---|---|---|\n";

std::string number(double value, int decimals)
{
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
    return text.data();
}

std::string keyOf(const FaultCase& faultCase)
{
    return "| " + faultCase.fault.name + " | " + word(faultCase.moment) + " |";
}

std::string line(const FaultCase& faultCase, const FaultOutcome& outcome)
{
    const auto drive = [&](std::size_t i) { return std::string(outcome.off[i] ? "off" : "on"); };
    const std::string alarm = outcome.alarm ? number(outcome.alarm->count(), 2) : "-";
    const bool latches = faultCase.fault.outcome == Outcome::Latches;
    const bool stood = faultCase.moment == Moment::AtRest;
    return keyOf(faultCase) + " " + alarm + " | " + (latches ? number(outcome.still[0].count(), 2) : "-") + " | " +
           (latches ? number(outcome.still[1].count(), 2) : "-") + " | " +
           (stood ? number(std::max(outcome.strayed[0], outcome.strayed[1]).degrees(), 3) : "-") + " | " +
           number(std::max(outcome.beyond[0], outcome.beyond[1]).degrees(), 3) + " | " + outcome.state + " | " +
           (latches ? number(std::max(outcome.moved[0], outcome.moved[1]).degrees(), 3) : "-") + " | " +
           (latches ? "az " + drive(0) + ", el " + drive(1) : "-") + " | " + outcome.again + " | " + outcome.text +
           " |\n";
}

std::map<std::string, std::string>& rows()
{
    static std::map<std::string, std::string> rows;
    return rows;
}

struct Page
{
    std::string introduction{};
    std::string rest{};  // from the first heading after the table
};

Page read(const char* path)
{
    std::ifstream file(path);
    Page page;
    std::string line;
    while (std::getline(file, line) && !line.starts_with('|')) {
        page.introduction += line + "\n";
    }
    while (std::getline(file, line)) {
        if (!page.rest.empty() || line.starts_with("## ")) {
            page.rest += (page.rest.empty() ? "\n" : "") + line + "\n";
        }
    }
    return page;
}

class FaultTable : public ::testing::TestWithParam<FaultCase>
{
public:
    static void TearDownTestSuite()
    {
        const char* const path = std::getenv("BORESIGHT_FAULT_TABLE");
        if (path == nullptr) {
            return;
        }
        const Page page = read(path);
        std::ofstream file(path);
        file << page.introduction << kHeader;
        for (const FaultCase& faultCase : faultCases()) {
            file << rows()[keyOf(faultCase)];
        }
        file << page.rest;
    }
};

TEST_P(FaultTable, StopsTellsAndWaits)
{
    const Fault& fault = GetParam().fault;
    const FaultOutcome outcome = FaultRun(GetParam()).run();
    const std::string row = line(GetParam(), outcome);
    rows()[keyOf(GetParam())] = row;
    std::cout << row;
    RecordProperty("row", row);
    if (!fault.alarm.empty()) {
        ASSERT_TRUE(outcome.alarm);
        EXPECT_LE(*outcome.alarm, fault.alarmWithin + Seconds(1e-6));
    }
    EXPECT_LE(std::max(outcome.beyond[0], outcome.beyond[1]), fault.beyond);
    if (GetParam().moment == Moment::AtRest) {
        EXPECT_LE(std::max(outcome.strayed[0], outcome.strayed[1]), fault.strays);
    }
    if (fault.pushesOn) {
        EXPECT_LE(outcome.torque[fault.hurt == Hurt::Azimuth ? 0 : 1], *fault.pushesOn) << "Nm";
    }
    if (fault.outcome == Outcome::GoesOn) {
        EXPECT_NE(outcome.state, "FAULT");
        return;
    }
    EXPECT_EQ(outcome.state, "FAULT");
    for (std::size_t i = 0; i < 2; ++i) {
        const bool hurt = fault.hurt == Hurt::Both || fault.hurt == (i == 0 ? Hurt::Azimuth : Hurt::Elevation);
        EXPECT_LE(outcome.still[i], fault.stall + (hurt ? fault.stillWithin : fault.othersStillWithin)) << i;
        EXPECT_LE(outcome.moved[i], fault.springsBack) << i;
    }
    EXPECT_LE(outcome.movedByRearming, 0.1_deg);
}

std::string testName(const ::testing::TestParamInfo<FaultCase>& info)
{
    std::string text;
    bool begins = true;
    for (const char letter : info.param.fault.name + " " + word(info.param.moment)) {
        const auto c = static_cast<unsigned char>(letter);
        if (std::isalnum(c) != 0) {
            text += static_cast<char>(begins ? std::toupper(c) : c);
        }
        begins = std::isalnum(c) == 0;
    }
    return text;
}

// The figures in the committed copy may be older. Its rows must be the rows of this test.
TEST(FaultTableFile, HasTheRowsOfThisTest)
{
    std::multiset<std::string> written;
    std::ifstream file(FAULTS_MD);
    for (std::string row; std::getline(file, row) && !row.starts_with("## ");) {
        if (row.starts_with("| ") && !row.starts_with("| fault |")) {
            written.insert(row.substr(0, row.find('|', row.find('|', 1) + 1) + 1));
        }
    }
    std::multiset<std::string> expected;
    for (const FaultCase& faultCase : faultCases()) {
        expected.insert(keyOf(faultCase));
    }
    EXPECT_EQ(written, expected);
}

INSTANTIATE_TEST_SUITE_P(Row, FaultTable, ::testing::ValuesIn(faultCases()), testName);

}  // namespace
}  // namespace boresight::system_test
