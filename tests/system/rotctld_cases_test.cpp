// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/profile/profile_file.h"
#include "tests/system/simulated_station.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

// Every exchange recorded with Hamlib's rotctld and its dummy rotator, played over TCP against the running station with
// the simulated drives behind it, set up like the dummy by tests/data/dummy-like.toml. Cases that differ on purpose
// are listed here, and with their reasons in core/rotctld/README.md.
namespace boresight::system_test {
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

const profile::Profile& dummyLike()
{
    static const auto loaded = profile::loadProfile(QStringLiteral(BORESIGHT_TEST_DATA "/dummy-like.toml"));
    return *loaded;
}

// The reference mount with the travel of the dummy, and light enough for its profile: 4 kg m² at 300 °/s² are 21 Nm.
sim::PairSettings lightPair()
{
    sim::PairSettings pair = sim::commissionedPair();
    pair.elevation.position = -0.25;  // the dummy starts at 0 / 0
    for (sim::MoteusSettings* const axis : {&pair.azimuth, &pair.elevation}) {
        axis->plant.inertia = 4.0;
        axis->config.servo.maxVelocity = 1.0;
        axis->config.servo.maxCurrent = 100.0;
    }
    pair.azimuth.config.positionMin = -0.51;
    pair.azimuth.plant.stopMin = -0.53;
    return pair;
}

std::string play(const QJsonObject& exchange)
{
    SimulatedStation rig(dummyLike(), lightPair());
    return fakes::RotctldCaseRunner(rig.caseTarget()).run(exchange);
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
        {"motion.stop_stops", 12},
    };
    return table;
}

std::set<std::string> groups()
{
    std::set<std::string> names;
    for (const QJsonObject& exchange : cases()) {
        names.insert(textOf(exchange, "group"));
    }
    return names;
}

class StationCases : public ::testing::TestWithParam<std::string>
{};

TEST_P(StationCases, MatchHamlib)
{
    for (const QJsonObject& exchange : cases()) {
        const std::string name = textOf(exchange, "name");
        if (textOf(exchange, "group") == GetParam() && !differences().contains(name)) {
            EXPECT_EQ(play(exchange), "") << name;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Recorded, StationCases, ::testing::ValuesIn(groups()),
                         [](const auto& group) { return group.param; });

// A difference that is none any more must leave the tables.
TEST(StationDifferences, AreReal)
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
}  // namespace boresight::system_test
