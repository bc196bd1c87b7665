// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fakes/rotctld_recording.h"

#include "tests/fakes/rotctld_case_runner.h"

#include <gtest/gtest.h>

namespace boresight::fakes {
namespace {

std::string textOf(const QJsonObject& exchange, const char* key)
{
    return exchange[QLatin1String(key)].toString().toStdString();
}

}  // namespace

const std::vector<QJsonObject>& recordedExchanges()
{
    static const auto all = loadRotctldCases(BORESIGHT_TEST_DATA "/rotctld_cases.json");
    return all;
}

std::set<std::string> recordedGroups()
{
    std::set<std::string> names;
    for (const QJsonObject& exchange : recordedExchanges()) {
        names.insert(textOf(exchange, "group"));
    }
    return names;
}

RotctldDifferences rotctldDifferences()
{
    return {
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
}

void expectGroupAsRecorded(const std::string& group, const RotctldDifferences& differences, const PlayExchange& play)
{
    for (const QJsonObject& exchange : recordedExchanges()) {
        const std::string name = textOf(exchange, "name");
        if (textOf(exchange, "group") == group && !differences.contains(name)) {
            EXPECT_EQ(play(exchange), "") << name;
        }
    }
}

void expectRealDifferences(const RotctldDifferences& differences, const PlayExchange& play)
{
    std::size_t found = 0;
    for (const QJsonObject& exchange : recordedExchanges()) {
        const std::string name = textOf(exchange, "name");
        if (differences.contains(name)) {
            ++found;
            EXPECT_NE(play(exchange), "") << name;
        }
    }
    EXPECT_EQ(found, differences.size());
}

}  // namespace boresight::fakes
