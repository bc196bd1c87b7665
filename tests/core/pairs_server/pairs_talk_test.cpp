// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pairs_server/pairs_talk.h"

#include "tests/fakes/dummy_rotator.h"
#include "tests/fakes/manual_clock.h"

#include <gtest/gtest.h>

#include <chrono>
#include <string>

namespace boresight::pairs {
namespace {

using namespace std::chrono_literals;

constexpr Site kLisbon{.latitude = Angle::fromDegrees(38.72), .longitude = Angle::fromDegrees(-9.14)};

struct PairsTest : ::testing::Test
{
    // Everything that is answered to these bytes.
    std::string say(std::string_view bytes)
    {
        talk->receive(bytes);
        std::string replies;
        while (talk->step(replies)) {
        }
        return replies;
    }

    fakes::ManualClock clock;
    fakes::DummyRotator rotator{clock};
    std::optional<Site> site = kLisbon;
    std::unique_ptr<rotctld::Conversation> talk = talkPairs(
        rotator, clock, [this] { return site; })({.id = 7, .address = "/tmp/pairs:4711", .protocol = "Pairs"});
};

using PairsOnALine = PairsTest;

// REQ-PAIRSSERVER-03 (PairsOnALine.*): A client points, moves by an angle, stops, parks and reads the mount by the same
// requests as a rotctld client. Each line is answered with `OK`, with the position or with the reason.
TEST_F(PairsOnALine, PointsAndReads)
{
    EXPECT_EQ(say("120.5 30\n"), "OK\n");
    clock.advance(30s);
    EXPECT_EQ(say("?\n"), "120.5 30.0\n");
    EXPECT_EQ(say("60\n"), "OK\n");
    EXPECT_NEAR(rotator.lastRequest->azimuth.degrees(), 120.5, 1e-9);
    clock.advance(30s);
    EXPECT_EQ(say("?\r\n"), "120.5 60.0\n");
    EXPECT_EQ(say("park\n"), "OK\n");
    clock.advance(30s);
    EXPECT_EQ(say("?\n"), "0.0 0.0\n");
}

TEST_F(PairsOnALine, MovesAddUp)
{
    EXPECT_EQ(say("100 30\n+5 0\n+5 -3\n+2\n"), "OK\nOK\nOK\nOK\n");
    clock.advance(60s);
    EXPECT_EQ(say("?\n"), "110.0 29.0\n");
    static_cast<void>(rotator.pointTo({.id = 3, .address = {}}, {.azimuth = 0_deg, .elevation = 50_deg}));
    clock.advance(60s);
    EXPECT_EQ(say("-10 +0\n"), "OK\n");
    EXPECT_EQ(rotator.lastRequest->azimuth, -10_deg) << "from where it was moved to";
    EXPECT_EQ(rotator.lastRequest->elevation, 50_deg);
}

TEST_F(PairsOnALine, SaysWhatBecameOfATarget)
{
    rotator.became = QStringLiteral("90.0° 90.0°, at the elevation limit");
    EXPECT_EQ(say("90 90\n"), "OK: 90.0° 90.0°, at the elevation limit\n");
}

TEST_F(PairsOnALine, StopsOnItsWay)
{
    static_cast<void>(say("400 90\n"));
    clock.advance(1s);
    EXPECT_EQ(say("stop\n"), "OK\n");
    clock.advance(10s);
    EXPECT_EQ(say("?\n"), "6.0 6.0\n");
    static_cast<void>(say("400 90\n"));
    clock.advance(1s);
    EXPECT_TRUE(say("10 stop\n").starts_with("error: ")) << "what was meant is not clear, but that it stops";
    clock.advance(10s);
    EXPECT_EQ(say("?\n"), "12.0 12.0\n");
    EXPECT_EQ(say("+0 +4\n"), "OK\n");
    EXPECT_NEAR(rotator.lastRequest->elevation.degrees(), 16.0, 1e-9) << "from where it was stopped";
}

// REQ-PAIRSSERVER-04: `bearing LOCATOR` points to a locator at the horizon along the short path, `bearing LOCATOR long`
// along the long path. The starting point is the site of the profile.
TEST_F(PairsOnALine, PointsToALocator)
{
    EXPECT_EQ(say("bearing JN58td\n"), "OK\n");
    EXPECT_NEAR(rotator.lastRequest->azimuth.degrees(), 51.1, 0.2) << "Lisbon to Munich, on a sphere";
    EXPECT_EQ(rotator.lastRequest->elevation, 0_deg);
    EXPECT_EQ(say("bearing JN58td long\n"), "OK\n");
    EXPECT_NEAR(rotator.lastRequest->azimuth.degrees(), 231.1, 0.2);
    EXPECT_EQ(say("+1 0\n"), "OK\n");
    EXPECT_NEAR(rotator.lastRequest->azimuth.degrees(), 232.1, 0.2);
    const int before = rotator.actions;
    site.reset();
    EXPECT_EQ(say("bearing JN58td\n"), "error: The site of the mount is unknown. Enter it on the page Profile.\n");
    EXPECT_EQ(rotator.actions, before);
}

class PairsThat : public PairsTest
{};

TEST_F(PairsThat, RefusesSaysWhyAndMovesNothing)
{
    EXPECT_TRUE(say("AZ10 EL20\n").starts_with("error: \"AZ10 EL20\" is not a command. The commands are "));
    EXPECT_EQ(say("10 181\n"), "error: elevation 181.0° is outside -90°…180°\n");
    EXPECT_TRUE(say("bearing XX00\n").starts_with("error: "));
    EXPECT_EQ(rotator.actions, 0);
    EXPECT_EQ(say("10 95\n"), "error: outside the limits\n") << "by the station";
    rotator.fault = Error{.code = ErrorCode::Refused, .text = QStringLiteral("STOP is latched. Reset STOP first.")};
    for (const char* const line : {"10 20\n", "60\n", "+1 0\n", "park\n", "bearing JN58\n", "?\n"}) {
        EXPECT_EQ(say(line), "error: STOP is latched. Reset STOP first.\n") << line;
    }
    EXPECT_TRUE(talk->ending().isEmpty());
    EXPECT_TRUE(talk->habits().lastInWords().contains(QStringLiteral("STOP is latched")));
}

TEST_F(PairsThat, HearsNonsenseHangsUp)
{
    std::string eight;
    for (int i = 0; i < 8; ++i) {
        eight += "nonsense\n";
    }
    static_cast<void>(say(eight + "10 10\n"));
    EXPECT_TRUE(talk->dropped());
    EXPECT_EQ(rotator.actions, 0);
}

TEST_F(PairsThat, IsLeftForgetsHalfACommand)
{
    EXPECT_EQ(say("?\n10 1"), "0.0 0.0\n");
    talk->endOfInput();
    EXPECT_EQ(say(""), "");
    EXPECT_FALSE(talk->ending().isEmpty());
    EXPECT_EQ(rotator.actions, 0) << "10 15 was perhaps meant";
}

}  // namespace
}  // namespace boresight::pairs
