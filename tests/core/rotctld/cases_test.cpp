// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/rotctld/server_fixture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

// Every exchange recorded with Hamlib's rotctld, played through the real server on TCP. Those that differ on purpose
// are listed here with what we answer, and in core/rotctld/README.md with the reason.
namespace boresight::rotctld {
namespace {

const std::vector<QJsonObject>& cases()
{
    static const auto all = fakes::loadRotctldCases(BORESIGHT_TEST_DATA "/rotctld_cases.json");
    return all;
}

std::string textOf(const QJsonObject& exchange, const char* key)
{
    return exchange[QLatin1String(key)].toString().toStdString();
}

// README.md, "Where we differ": case name -> number of the difference.
const std::map<std::string, int>& differences()
{
    static const std::map<std::string, int> table{
        {"unknown.rest_of_line_runs_stop", 1},
        {"client.easycomm_by_mistake", 2},
        {"client.gs232_by_mistake", 2},
        {"client.http_by_mistake", 2},
        {"set_pos_nan.az", 3},
        {"convert.a_nan", 3},
        {"unknown.bare_name_get_pos", 4},
        {"convert.E_west_wrong", 5},
        {"convert.E_west_wrong2", 5},
        {"level.query_set", 6},
        {"level.query_get_ext", 6},
        {"level.query_set_then_cmd", 6},
        {"level.ext_level_MGL", 6},
        {"level.ext_level_MGF", 6},
        {"func.set_get", 6},
        {"func.set_word", 6},
        {"parm.set_get", 6},
        {"conf.set_known", 7},
    };
    return table;
}

std::string play(const QJsonObject& exchange)
{
    ServerFixture fixture({.dumpState = DumpStateForm::AsHamlib});
    return fakes::RotctldCaseRunner(fixture.target()).run(exchange);
}

std::set<std::string> groups()
{
    std::set<std::string> names;
    for (const QJsonObject& exchange : cases()) {
        names.insert(textOf(exchange, "group"));
    }
    return names;
}

class RotctldCases : public ::testing::TestWithParam<std::string>
{};

TEST_P(RotctldCases, MatchHamlib)
{
    for (const QJsonObject& exchange : cases()) {
        const std::string name = textOf(exchange, "name");
        if (textOf(exchange, "group") == GetParam() && !differences().contains(name)) {
            EXPECT_EQ(play(exchange), "") << name;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Recorded, RotctldCases, ::testing::ValuesIn(groups()),
                         [](const auto& group) { return group.param; });

TEST(RotctldCaseFile, IsComplete)
{
    EXPECT_EQ(cases().size(), 277U);
}

// A difference that is none any more must leave the tables.
TEST(RotctldDifferences, AreReal)
{
    std::size_t found = 0;
    for (const QJsonObject& exchange : cases()) {
        if (differences().contains(textOf(exchange, "name"))) {
            ++found;
            EXPECT_NE(play(exchange), "") << textOf(exchange, "name");
        }
    }
    EXPECT_EQ(found, differences().size());
}

}  // namespace
}  // namespace boresight::rotctld
