// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/rotctld/server_fixture.h"
#include "tests/fakes/rotctld_recording.h"

#include <gtest/gtest.h>

#include <string>

// Every exchange recorded with Hamlib's rotctld is played through the real server over TCP.
namespace boresight::rotctld {
namespace {

std::string play(const QJsonObject& exchange)
{
    ServerFixture fixture({}, DumpStateForm::AsHamlib);
    return fakes::RotctldCaseRunner(fixture.target()).run(exchange);
}

class RotctldCases : public ::testing::TestWithParam<std::string>
{};

// REQ-ROTCTLD-01: Replies are those of Hamlib 4.5.4, byte for byte, except for the differences listed in
// core/rotctld/HAMLIB.md.
TEST_P(RotctldCases, MatchHamlib)
{
    fakes::expectGroupAsRecorded(GetParam(), fakes::rotctldDifferences(), &play);
}

INSTANTIATE_TEST_SUITE_P(Recorded, RotctldCases, ::testing::ValuesIn(fakes::recordedGroups()),
                         [](const auto& group) { return group.param; });

TEST(RotctldCaseFile, IsComplete)
{
    EXPECT_EQ(fakes::recordedExchanges().size(), 277U);
}

TEST(RotctldDifferences, AreReal)
{
    fakes::expectRealDifferences(fakes::rotctldDifferences(), &play);
}

}  // namespace
}  // namespace boresight::rotctld
