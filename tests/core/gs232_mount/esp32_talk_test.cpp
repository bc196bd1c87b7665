// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gs232_mount/esp32_talk.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace boresight::gs232 {
namespace {

using std::chrono::milliseconds;

// Records what is sent. `answer` finds the reply to each piece that was sent, which arrives one tick later.
class WordTalk
{
public:
    Esp32Talk& operator*() { return m_talk; }
    Esp32Talk* operator->() { return &m_talk; }
    void run(milliseconds time)
    {
        for (const SteadyTime end = now + time; now < end; now += milliseconds(20)) {
            m_talk.take(std::exchange(m_due, {}), now);
            if (const std::string bytes = m_talk.send(now); !bytes.empty()) {
                sent.push_back(bytes);
                m_due = answers ? answerTo(bytes) : std::string();
            }
        }
    }
    // Runs until the position is known.
    void connect()
    {
        run(milliseconds(1000));
        sent.clear();
    }
    [[nodiscard]] int count(const std::string& command) const
    {
        return static_cast<int>(std::ranges::count(sent, command));
    }

    SteadyTime now = SteadyTime{} + std::chrono::hours(1);
    std::string version = "VEAdamESP32v1.0\r";
    std::string place = "123.4 45.6\r";
    bool answers = true;
    std::vector<std::string> sent;

private:
    [[nodiscard]] std::string answerTo(const std::string& bytes) const
    {
        if (bytes == "VE\r") {
            return version;
        }
        if (bytes == "P\r") {
            return place;
        }
        std::string replies;
        for (auto left = std::ranges::count(bytes, '\r'); left > 0; --left) {
            replies += bytes == "DEBUG\r" ? "DEBUG ON\r" : "RPRT 0\r";
        }
        return replies;
    }

    Esp32Talk m_talk{180_deg};
    std::string m_due;
};

// REQ-GS232-82: Before an ESP32 relay controller has answered with its version, only that question is sent, once a
// second. A device that answers it three times with other text is foreign.
TEST(Esp32Talk, OnlyItsVersionProvesTheBox)
{
    WordTalk talk;
    talk.version = "RPRT -1\r";
    talk->go(Axis::Azimuth, 10_deg);
    talk->stop();
    talk.run(milliseconds(4000));
    EXPECT_EQ(talk.sent, (std::vector<std::string>{"VE\r", "VE\r", "VE\r"}));
    EXPECT_EQ(talk->proof(), RotatorTalk::Proof::Foreign);
    EXPECT_EQ(talk->strange(), "RPRT -1");
}

// REQ-GS232-83: A stop overwrites the targets of an ESP32 relay controller with the reported position, in one piece
// with the commands that switch the relays off. After five more readings the position becomes the target again, because
// the box reports the mean of five.
TEST(Esp32Talk, AStopOverwritesTheTarget)
{
    WordTalk talk;
    talk.connect();
    talk->go(Axis::Azimuth, 150_deg);
    talk->stop();
    talk.place = "125.0 44.0\r";
    talk.run(milliseconds(20));
    ASSERT_EQ(talk.sent, (std::vector<std::string>{"SA\rSE\rAZ 123.4\rEL 45.6\r"}));
    talk.run(milliseconds(400));
    EXPECT_EQ(talk.count("AZ 150.0\r"), 0) << "the target before the stop is gone";
    EXPECT_EQ(talk.count("AZ 125.0\r"), 1);
    EXPECT_EQ(talk.count("EL 44.0\r"), 1);
    talk.run(milliseconds(2000));
    EXPECT_EQ(talk.count("AZ 125.0\r"), 1) << "once";
}

TEST(Esp32Talk, AMotionAfterAStopKeepsItsTarget)
{
    WordTalk talk;
    talk.connect();
    talk->stop();
    talk.run(milliseconds(20));
    talk->go(Axis::Azimuth, 150_deg);
    talk.run(milliseconds(2000));
    EXPECT_EQ(talk.count("AZ 150.0\r"), 1);
    EXPECT_EQ(talk.count("AZ 123.4\r"), 0);
}

// REQ-GS232-84: An ESP32 relay controller receives at most two targets a second for each axis, and four questions. The
// next command waits for the answer to the last one, 400 ms at most.
TEST(Esp32Talk, ItsCommandsArePaced)
{
    WordTalk talk;
    talk.connect();
    for (int i = 0; i < 50; ++i) {
        talk->go(Axis::Azimuth, Angle::fromDegrees(100.0 + i));
        talk.run(milliseconds(20));
    }
    EXPECT_LE(std::ranges::count_if(talk.sent, [](const std::string& one) { return one.starts_with("AZ "); }), 2);
    EXPECT_LE(talk.count("P\r"), 5);
    talk.answers = false;
    talk.run(milliseconds(400));
    talk.sent.clear();
    talk.run(milliseconds(1000));
    EXPECT_LE(talk.sent.size(), 3U);
    talk->stop();
    talk.run(milliseconds(20));
    EXPECT_TRUE(talk.sent.back().starts_with("SA\r")) << "a stop does not wait";
}

// REQ-GS232-85: The first four positions of an ESP32 relay controller that started are ignored, because the box fills
// its readings with zeros.
TEST(Esp32Talk, TheFirstPositionsAreNotBelieved)
{
    WordTalk talk;
    talk.place = "123.4 9.1\r";
    talk.run(milliseconds(120));
    EXPECT_FALSE(talk->takePlaces());
    talk.place = "123.4 45.6\r";
    talk.run(milliseconds(500));
    EXPECT_EQ(talk->takePlaces()->elevation, Angle::fromDegrees(45.6));
    talk->take("Ready! Type HELP for list of commands.\r\n123.4 9.1\r", talk.now);
    EXPECT_FALSE(talk->takePlaces());
}

TEST(Esp32Talk, AHeadingIsCountedInsideTheTravel)
{
    Esp32Talk talk(-20_deg);
    talk.take("VEAdamESP32v1.0\r", {});
    for (int i = 0; i < Esp32Talk::kReadings; ++i) {
        talk.take("350.0 45.6\r", {});
    }
    EXPECT_NEAR(talk.takePlaces()->azimuth->degrees(), -10.0, 1e-9);
}

// REQ-GS232-86: The calibration digits of the sensor of an ESP32 relay controller are read from its reports. Boresight
// switches the reports on, and again if the box had them on before. Old digits are not shown.
TEST(Esp32Talk, ItsCalibrationDigitsAreRead)
{
    WordTalk talk;
    talk.run(milliseconds(2500));
    EXPECT_EQ(talk.count("DEBUG\r"), 1);
    EXPECT_FALSE(talk->digits(talk.now));
    talk->take("DEBUG | RawX:33.4 | CalcAZ:123.4 | Calib[S:3 G:2 A:1 M:0]\r\n", talk.now);
    EXPECT_EQ(talk->digits(talk.now),
              (esp32::Digits{.system = 3, .gyroscope = 2, .accelerometer = 1, .magnetometer = 0}));
    talk.run(milliseconds(2500));
    EXPECT_EQ(talk.count("DEBUG\r"), 1) << "they are on";
    talk.run(milliseconds(3500));
    EXPECT_EQ(talk.count("DEBUG\r"), 2);
    EXPECT_FALSE(talk->digits(talk.now));
}

}  // namespace
}  // namespace boresight::gs232
