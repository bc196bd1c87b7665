// SPDX-License-Identifier: GPL-3.0-or-later
// A line that the operator types to a control box.
#include "tests/core/gs232_mount/esp32_bench.h"
#include "tests/core/gs232_mount/gs232_bench.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace boresight::gs232 {
namespace {

// As the connection does it.
template <class SomeBench>
void send(SomeBench& bench, const std::string& line)
{
    bench.mount().leave(profile::OnExit::Hold);
    bench.mount().console().type(line);
}

// As the station does it: the talk, the control, then the connection.
template <class SomeBench>
Result<> type(SomeBench& bench, const std::string& line)
{
    return bench.mount().talk().mayType(line).and_then([&] { return bench.ask(request::TypeLine{line}); }).map([&] {
        send(bench, line);
    });
}

template <class SomeBench>
bool heard(SomeBench& bench, const std::string& line)
{
    return std::ranges::find(bench.box().heard(), line) != bench.box().heard().end();
}

// What the box received after this line.
template <class SomeBench>
std::string next(SomeBench& bench, const std::string& line)
{
    const auto& all = bench.box().heard();
    const auto at = std::ranges::find(all, line);
    return at != all.end() && at + 1 != all.end() ? *(at + 1) : std::string();
}

template <class SomeBench>
class TypedLine : public ::testing::Test
{
protected:
    TypedLine() { bench.run(Seconds(2.0)); }

    // A line that such a box answers without moving. Boresight itself writes CALSTATS in upper case.
    static constexpr bool kIsEsp32 = std::is_same_v<SomeBench, Esp32Bench>;
    static constexpr const char* kLine = kIsEsp32 ? "calstats" : "X3";

    SomeBench bench;
};

using Benches = ::testing::Types<Gs232Bench, Esp32Bench>;
TYPED_TEST_SUITE(TypedLine, Benches);

// REQ-GS232-90: The operator types a line to the control box and sees its answer. Between the line and the end of its
// answer nothing but a stop is sent.
TYPED_TEST(TypedLine, IsSentAsItIsAndItsAnswerIsShown)
{
    ASSERT_TRUE(type(this->bench, this->kLine));
    this->bench.run(Seconds(1.5));
    EXPECT_EQ(next(this->bench, this->kLine), this->kIsEsp32 ? "SA" : "S");
    const QStringList& lines = this->bench.mount().console().lines();
    ASSERT_GE(lines.size(), 2);
    EXPECT_EQ(lines[0], QStringLiteral("> ") + QLatin1String(this->kLine));
    EXPECT_EQ(lines.contains(QStringLiteral("Accel Rad: 1000")), this->kIsEsp32);
    EXPECT_FALSE(lines.contains(QStringLiteral("C2")));
}

// REQ-GS232-91: A line is refused while the mount moves or tracks a target, and from a client.
TYPED_TEST(TypedLine, IsRefusedWhileTheMountMovesOrTracks)
{
    EXPECT_TRUE(this->bench.control().status().permissions.allows(Action::TypeLine));
    EXPECT_FALSE(this->bench.control().request(request::TypeLine{this->kLine}, kClient));
    ASSERT_TRUE(this->bench.goTo(60.0, 45.0));
    EXPECT_FALSE(type(this->bench, this->kLine));
    for (int i = 0; i < 8; ++i) {
        this->bench.run(Seconds(1.0));
        EXPECT_FALSE(type(this->bench, this->kLine));
    }
    EXPECT_FALSE(this->bench.control().status().permissions.allows(Action::TypeLine));
    this->bench.run(Seconds(20.0));
    ASSERT_EQ(this->bench.control().state(), StationState::Hold);
    EXPECT_FALSE(heard(this->bench, this->kLine));
    EXPECT_TRUE(type(this->bench, this->kLine));
    EXPECT_FALSE(type(this->bench, this->kLine)) << "one line at a time";
}

// REQ-GS232-91
TYPED_TEST(TypedLine, IsRefusedWhileATargetIsTracked)
{
    const SkyPointing here{.azimuth = Angle::fromDegrees(10.4), .elevation = Angle::fromDegrees(20.6)};
    ASSERT_TRUE(this->bench.ask(request::Follow{.direction = here, .what = QStringLiteral("Sun")}));
    this->bench.run(Seconds(1.0));
    EXPECT_FALSE(this->bench.control().status().permissions.allows(Action::TypeLine));
    ASSERT_TRUE(this->bench.ask(request::Hold{}));
    this->bench.run(Seconds(4.0));
    EXPECT_TRUE(this->bench.control().status().permissions.allows(Action::TypeLine));
}

// REQ-GS232-92: After a typed line the position is read again, a stop is sent, and nothing follows a set-point before
// the rotator was seen standing still.
TYPED_TEST(TypedLine, TheRotatorIsTakenOverOnlyAfterItWasSeenStanding)
{
    ASSERT_TRUE(this->bench.goTo(40.0, 30.0));
    this->bench.run(Seconds(25.0));
    ASSERT_TRUE(this->bench.mount().follows());
    ASSERT_TRUE(type(this->bench, this->kLine));
    this->bench.run(Seconds(0.5));
    EXPECT_FALSE(this->bench.mount().follows());
    EXPECT_FALSE(this->bench.mount().measured());
    EXPECT_EQ(this->bench.control().state(), StationState::Standby);
    EXPECT_FALSE(this->bench.goTo(60.0, 45.0)) << "the position is unknown";
    this->bench.run(Seconds(1.0));
    EXPECT_TRUE(this->bench.mount().measured());
    ASSERT_TRUE(this->bench.goTo(60.0, 45.0));
    EXPECT_TRUE(this->bench.stands(Seconds(1.0)));
    this->bench.run(Seconds(20.0));
    this->bench.expectAt({.azimuth = 60_deg, .elevation = 45_deg}, {}, this->bench.resolution());
    EXPECT_EQ(this->bench.control().state(), StationState::Hold);
}

// REQ-GS232-93: A line that moves the rotator is not sent. A motion that a typed line starts nevertheless is stopped
// within a second.
TYPED_TEST(TypedLine, AMotionThatItStartsIsStopped)
{
    const std::string motion = this->kIsEsp32 ? "AZ 200" : "W200 080";
    EXPECT_FALSE(type(this->bench, motion));
    ASSERT_TRUE(this->bench.ask(request::TypeLine{motion}));
    send(this->bench, motion);
    const AxisPosition before = this->bench.truth();
    this->bench.run(Seconds(1.5));
    EXPECT_TRUE(heard(this->bench, motion));
    const AxisPosition stopped = this->bench.truth();
    EXPECT_LE(abs(stopped.azimuth - before.azimuth), 7_deg);
    this->bench.run(Seconds(3.0));
    EXPECT_TRUE(this->bench.stands(Seconds(20.0)));
    EXPECT_LE(abs(this->bench.truth().azimuth - stopped.azimuth), 3_deg);
}

// REQ-GS232-90
TYPED_TEST(TypedLine, AStopDoesNotWaitForTheAnswer)
{
    ASSERT_TRUE(type(this->bench, this->kLine));
    this->bench.run(Seconds(0.3));
    ASSERT_TRUE(heard(this->bench, this->kLine));
    ASSERT_TRUE(this->bench.ask(request::Stop{}));
    this->bench.run(Seconds(0.04));
    EXPECT_EQ(next(this->bench, this->kLine), this->kIsEsp32 ? "SA" : "S");
}

TYPED_TEST(TypedLine, IsLostWithTheLine)
{
    ASSERT_TRUE(type(this->bench, this->kLine));
    this->bench.mount().lineClosed();
    this->bench.mount().lineOpened();
    this->bench.run(Seconds(3.0));
    EXPECT_FALSE(heard(this->bench, this->kLine));
    EXPECT_TRUE(type(this->bench, this->kLine));
}

// The line Z turns the count of such a box by 180°.
TEST(TypedLineToGs232, MayChangeTheCountOfTheBox)
{
    Gs232Bench bench;
    bench.run(Seconds(2.0));
    ASSERT_TRUE(bench.goTo(20.0, 20.0));
    bench.run(Seconds(15.0));
    ASSERT_TRUE(type(bench, "Z"));
    bench.run(Seconds(0.4));
    bench.box().faults().offset = 180_deg;
    bench.run(Seconds(5.0));
    EXPECT_FALSE(bench.standsOnBoard("rotator.jumped"));
    ASSERT_TRUE(bench.mount().measured());
    EXPECT_NEAR(bench.mount().measured()->azimuth.degrees(), 200.0, 1.0);
    EXPECT_TRUE(bench.stands(Seconds(3.0)));
}

// REQ-GS232-94: A line after which the box waits for an answer is not sent, because the box would take the next
// question for this answer. A line is 1 to 64 printable ASCII characters.
TEST(TypedLineToGs232, IsJudgedByWhatTheBoxDoes)
{
    const BoxTalk talk(Question::Both, 9600);
    for (const char* const line : {"C2", "h", "H2", " P36", "Z", "X2", "N", "S", "a", "B"}) {
        EXPECT_TRUE(talk.mayType(line)) << line;
    }
    for (const char* const line :
         {"M100", "m100", " W100 020", "R", "l", "U", "d", "T", "W001 100 020", "O", "o2", "F2"}) {
        EXPECT_FALSE(talk.mayType(line)) << line;
    }
    for (const std::string& line : {std::string(), std::string("  "), std::string("C\rM100"), std::string("C\x1b"),
                                    std::string("C\xc3\xa9"), std::string(65, 'C')}) {
        EXPECT_FALSE(talk.mayType(line)) << line;
    }
}

TEST(TypedLineToEsp32, IsJudgedByWhatTheBoxDoes)
{
    const Esp32Talk talk(180_deg);
    for (const char* const line : {"P", "AZ", "EL ", "AZ-10", "help", "CALSTATS", "Calibrate", "VE", "SA", "az 10"}) {
        EXPECT_TRUE(talk.mayType(line)) << line;
    }
    for (const char* const line : {"AZ 10", "EL10", " AZ 10", "AZ EL", "HOME", "home ", "Dance"}) {
        EXPECT_FALSE(talk.mayType(line)) << line;
    }
}

// REQ-GS232-95: A calibration that the operator types silences an ESP32 relay controller until all digits are 3. The
// alarm shows the digits. Afterwards its target is its new position.
TEST(TypedLineToEsp32, MayCalibrateTheSensor)
{
    Esp32Bench bench;
    bench.run(Seconds(2.0));
    bench.box().faults().digits = {1, 3, 3, 2};
    ASSERT_TRUE(type(bench, "CALIBRATE"));
    bench.run(Seconds(6.0));
    EXPECT_TRUE(bench.warns("rotator.no-answer"));
    EXPECT_TRUE(bench.mount().console().lines().contains(QStringLiteral("CALIB: SYS=1 GYR=3 ACC=3 MAG=2")));
    bench.box().faults().digits = {3, 3, 3, 3};
    bench.run(Seconds(5.0));
    ASSERT_TRUE(bench.mount().measured());
    EXPECT_TRUE(bench.stands(Seconds(5.0)));
    EXPECT_TRUE(bench.goTo(40.0, 30.0));
}

TEST(BoxConsole, ShowsWhatTheBoxAnswersWithinItsTime)
{
    BoxConsole console;
    SteadyTime now{};
    console.take("AZ=100\r\n");
    BoxTalk talk(Question::Azimuth, 9600);
    talk.take("+0100\r\n", now);
    console.type("H");
    EXPECT_TRUE(console.isBusy());
    EXPECT_EQ(console.send(talk, now), "H\r");
    console.take("first\r\n\r\nsec");
    console.take("ond\x07\r");
    EXPECT_FALSE(console.ends(now + BoxConsole::kListens - std::chrono::milliseconds(1)));
    EXPECT_TRUE(console.ends(now + BoxConsole::kListens));
    EXPECT_FALSE(console.ends(now + BoxConsole::kListens));
    console.take("AZ=100\r\n");
    EXPECT_EQ(console.lines(),
              QStringList({QStringLiteral("> H"), QStringLiteral("first"), QStringLiteral("second?")}));
    EXPECT_EQ(console.takeAnswer(), QStringLiteral("first | second?"));
    EXPECT_FALSE(console.takeAnswer());
    console.type("Q");
    EXPECT_EQ(console.send(talk, now += std::chrono::seconds(2)), "Q\r");
    EXPECT_TRUE(console.ends(now + BoxConsole::kListens));
    EXPECT_EQ(console.lines().back(), QStringLiteral("(no answer)"));
    console.type("Q");
    EXPECT_EQ(console.send(talk, now += std::chrono::seconds(2)), "Q\r");
    console.take(std::string(5000, 'x'));
    EXPECT_TRUE(console.ends(now + BoxConsole::kListens));
    EXPECT_EQ(console.lines().back().size(), static_cast<qsizetype>(BoxConsole::kLongestAnswer));
}

}  // namespace
}  // namespace boresight::gs232
