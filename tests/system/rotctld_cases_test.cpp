// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/profile/profile_file.h"
#include "tests/fakes/rotctld_recording.h"
#include "tests/system/simulated_station.h"

#include <gtest/gtest.h>

// Every exchange recorded with Hamlib's rotctld and its dummy rotator is played over TCP against the running station
// with simulated drives. tests/data/dummy-like.toml gives the station the settings of the dummy.
namespace boresight::system_test {
namespace {

const profile::Profile& dummyLike()
{
    static const auto loaded = profile::loadProfile(QStringLiteral(BORESIGHT_TEST_DATA "/dummy-like.toml"));
    return *loaded;
}

// The reference mount with the travel of the dummy, and light enough for its profile: 4 kg m² at 300°/s² are 21 Nm.
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

fakes::RotctldDifferences differences()
{
    fakes::RotctldDifferences all = fakes::rotctldDifferences();
    all.emplace("motion.stop_stops", 12);
    return all;
}

class StationCases : public ::testing::TestWithParam<std::string>
{};

// REQ-ROTCTLD-01
TEST_P(StationCases, MatchHamlib)
{
    fakes::expectGroupAsRecorded(GetParam(), differences(), &play);
}

INSTANTIATE_TEST_SUITE_P(Recorded, StationCases, ::testing::ValuesIn(fakes::recordedGroups()),
                         [](const auto& group) { return group.param; });

TEST(StationDifferences, AreReal)
{
    fakes::expectRealDifferences(differences(), &play);
}

}  // namespace
}  // namespace boresight::system_test
