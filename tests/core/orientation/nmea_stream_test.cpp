// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/orientation/sentence.h"
#include "core/orientation/sentence_stream.h"

#include <gtest/gtest.h>

#include <cctype>
#include <random>
#include <vector>

namespace boresight::orientation {
namespace {

const std::string kBody = "PATRK,1771493857399,ms,47.33,dd,19.13,dd,0,revs,29,c,0,3,1,0";
const std::string kSentence = "$" + kBody + "*34";

std::vector<Orientation> add(SentenceStream& stream, std::string_view bytes)
{
    std::vector<Orientation> values;
    stream.add(bytes, SteadyTime{std::chrono::seconds(7)}, [&](const Orientation& value) { values.push_back(value); });
    return values;
}

Parsed<Orientation> parsed(const std::string& body)
{
    return parseSentence(withChecksum(body), SteadyTime{});
}

std::string reasonOf(const std::string& body)
{
    const auto value = parsed(body);
    return value ? "accepted" : toText(value.error());
}

// REQ-ORIENTATION-02 (NmeaSentence.*)
TEST(NmeaSentence, SaysWhenAndHowItCame)
{
    SentenceStream stream;
    const auto values = add(stream, kSentence + "\r\n");
    ASSERT_EQ(values.size(), 1U);
    EXPECT_EQ(values[0].arrival, SteadyTime{std::chrono::seconds(7)});
    EXPECT_EQ(values[0].transport, Transport::Serial);
    EXPECT_EQ(values[0].unknown, "");
}

// REQ-ORIENTATION-01
TEST(NmeaSentence, WhatAnotherFirmwareAddsIsKeptAndTheRestUsed)
{
    const auto more = parsed(kBody + ",12.5,hPa");
    ASSERT_TRUE(more);
    EXPECT_EQ(more->unknown, "12.5,hPa");
    EXPECT_EQ(more->calibration, (Calibration{.system = 0, .gyro = 3, .accelerometer = 1, .magnetometer = 0}));
    const auto oldest = parsed("PANT,TRK,1771493857399,ms,47.33,dd,19.13,dd,0,revs,0,3,1,0,x\x01y");
    ASSERT_TRUE(oldest);
    EXPECT_EQ(oldest->unknown, "x?y");
    EXPECT_FALSE(oldest->temperature);
}

TEST(NmeaSentence, NumbersAreThoseThatPrintfWrites)
{
    const auto withAzimuth = [](const std::string& azimuth) {
        return reasonOf("PATRK,1,ms," + azimuth + ",dd,19.13,dd,0,revs,29,c,0,3,1,0");
    };
    for (const char* const bad : {"", "-", "+1.00", "1e3", "0x10", " 1.00", "1,00", "--1.00", "1.0.0", "1-0"}) {
        EXPECT_NE(withAzimuth(bad), "accepted") << bad;
    }
    for (const char* const bad : {"nan", "-nan", "inf", "-inf"}) {
        EXPECT_EQ(withAzimuth(bad), "azimuth is not finite") << bad;
    }
    EXPECT_EQ(withAzimuth("-359.99"), "accepted");
    EXPECT_EQ(withAzimuth("100000000000000000.00"), "azimuth out of range");
    EXPECT_EQ(withAzimuth("359640.00"), "accepted") << "any revolutions";
}

TEST(NmeaSentence, WhatNoSensorSendsIsRefused)
{
    const auto with = [](const char* time, const char* elevation, const char* revolutions, const char* temperature,
                         const char* calibration) {
        return reasonOf("PATRK," + std::string(time) + ",ms,47.33,dd," + elevation + ",dd," + revolutions + ",revs," +
                        temperature + ",c," + calibration);
    };
    EXPECT_EQ(with("1", "180.00", "-3", "-128", "3,3,3,3"), "accepted");
    EXPECT_EQ(with("1", "180.01", "0", "20", "3,3,3,3"), "elevation out of range");
    EXPECT_EQ(with("1", "-0.01", "0", "20", "3,3,3,3"), "elevation out of range");
    EXPECT_EQ(with("1", "inf", "0", "20", "3,3,3,3"), "elevation is not finite");
    EXPECT_EQ(with("1", "0.00", "0.5", "20", "3,3,3,3"), "revolutions is not a number");
    EXPECT_EQ(with("1", "0.00", "0", "128", "3,3,3,3"), "temperature out of range");
    EXPECT_EQ(with("1", "0.00", "0", "20.5", "3,3,3,3"), "temperature is not a number");
    EXPECT_EQ(with("1", "0.00", "0", "20", "3,-1,3,3"), "calibration out of range");
    EXPECT_EQ(with("1", "0.00", "0", "20", "3,,3,3"), "calibration is not a number");
    EXPECT_EQ(with("-1", "0.00", "0", "20", "3,3,3,3"), "time out of range");
    EXPECT_EQ(with("9223372036855", "0.00", "0", "20", "3,3,3,3"), "time out of range");
    EXPECT_EQ(with("99999999999999999999", "0.00", "0", "20", "3,3,3,3"), "time is not a number");
}

TEST(NmeaSentence, LowerCaseHexMeansTheSameAndIsCounted)
{
    SentenceStream stream;
    EXPECT_EQ(add(stream, "$PANT,TRK,1771493857399,ms,47.33,dd,19.13,dd,0,revs,0,3,1,0*6a\r\n").size(), 1U);
    EXPECT_EQ(add(stream, "$PANT,TRK,1771493857399,ms,47.33,dd,19.13,dd,0,revs,0,3,1,0*6A\r\n").size(), 1U);
    EXPECT_EQ(stream.counts().accepted, 2U);
    EXPECT_EQ(stream.counts().lowerCaseChecksum, 1U);
}

// REQ-ORIENTATION-02
// REQ-ORIENTATION-03 (NmeaStream.*)
TEST(NmeaStream, CountsEveryKind)
{
    SentenceStream stream;
    add(stream, "BNO055 initialised...\r\n\r\n" + kSentence + "\r\n$GPGGA,x*00\r\n$PATRK,1*00\r\n\xff\x80\x00\r");
    add(stream, "$" + kBody + "*35\n$" + kBody + "*3\n$" + kBody + "\n" + "$PATRK,1" + kSentence + "\n");
    EXPECT_EQ(stream.counts().accepted, 2U);
    EXPECT_EQ(stream.counts().foreign, 1U);
    EXPECT_EQ(stream.counts().chatter, 2U);
    EXPECT_EQ(stream.counts().of(Refusal::WrongChecksum), 2U);
    EXPECT_EQ(stream.counts().of(Refusal::BadChecksum), 1U);
    EXPECT_EQ(stream.counts().of(Refusal::NoChecksum), 1U);
    EXPECT_EQ(stream.counts().of(Refusal::Truncated), 1U);
    EXPECT_EQ(stream.counts().allRefused(), 5U);
}

TEST(NmeaStream, AWholeSentenceThatLostOnlyItsLineEndCounts)
{
    SentenceStream stream;
    EXPECT_EQ(add(stream, kSentence + kSentence + "\r\n").size(), 2U);
}

TEST(NmeaStream, TooLongASentenceIsRefusedOnceAndTheNextIsWhole)
{
    SentenceStream stream;
    const std::string longest = kBody + "," + std::string(kLongestSentence - kBody.size() - 5, '7');
    ASSERT_EQ(withChecksum(longest).size(), kLongestSentence);
    EXPECT_EQ(add(stream, withChecksum(longest) + "\n").size(), 1U);
    EXPECT_EQ(add(stream, withChecksum(longest + "7") + "\n").size(), 0U);
    EXPECT_EQ(add(stream, "$PATRK," + std::string(1000000, 'z')).size(), 0U);
    EXPECT_EQ(add(stream, kSentence + "\n").size(), 1U);
    EXPECT_EQ(stream.counts().of(Refusal::TooLong), 2U);
    EXPECT_EQ(add(stream, std::string(1000000, 'z') + "\n" + kSentence + "\n").size(), 1U);
    EXPECT_EQ(stream.counts().chatter, 1U);
}

TEST(NmeaStream, ClearForgetsTheHalf)
{
    SentenceStream stream;
    add(stream, "$PATRK,17714");
    stream.clear();
    EXPECT_EQ(add(stream, "93857399,ms,\r\n" + kSentence + "\r\n").size(), 1U);
    EXPECT_EQ(stream.counts().allRefused(), 0U);
}

TEST(NmeaStream, AReceiverMayClearIt)
{
    SentenceStream stream;
    int values = 0;
    stream.add(kSentence + "\r\n" + kSentence + "\r\n", SteadyTime{}, [&](const Orientation&) {
        ++values;
        stream.clear();
    });
    EXPECT_EQ(values, 2);
}

// Computed independently by the definition: the XOR of all bytes between '$' and '*'.
bool hasRightSum(std::string_view sentence)
{
    unsigned sum = 0;
    const std::size_t star = sentence.find('*');
    for (const char character : sentence.substr(1, star - 1)) {
        sum ^= static_cast<unsigned char>(character);
    }
    const std::string digits(sentence.substr(star + 1));
    return digits.size() == 2 && std::isxdigit(static_cast<unsigned char>(digits[0])) != 0 &&
           std::stoul(digits, nullptr, 16) == sum;
}

// REQ-ORIENTATION-04 (NmeaFuzz.*): However the bytes are damaged, no sentence with a wrong checksum is used, and the
// next good sentence is used.
TEST(NmeaFuzz, NothingDamagedIsUsedAndTheNextSentenceIs)
{
    std::mt19937 random(20260219);
    const auto below = [&random](std::size_t end) { return random() % end; };
    for (int round = 0; round < 20000; ++round) {
        std::string damaged = kSentence;
        for (std::size_t changes = 1 + below(4); changes > 0; --changes) {
            const std::size_t at = below(damaged.size());
            switch (below(3)) {
                case 0:
                    damaged[at] = static_cast<char>(below(256));
                    break;
                case 1:
                    damaged.erase(at, 1 + below(5));
                    break;
                default:
                    damaged.insert(at, 1 + below(3), static_cast<char>(below(256)));
            }
            damaged += damaged.empty() ? "x" : "";
        }
        const auto alone = parseSentence(damaged, SteadyTime{});
        ASSERT_TRUE(!alone || hasRightSum(damaged)) << round << ": " << damaged;
        SentenceStream stream;
        add(stream, damaged);
        const std::uint64_t before = stream.counts().accepted;
        ASSERT_GE(add(stream, kSentence + "\r\n").size(), 1U) << round << ": " << damaged;
        ASSERT_LE(stream.counts().accepted - before, 2U) << round << ": " << damaged;
    }
}

TEST(NmeaFuzz, GarbageOfAnyLengthIsSurvived)
{
    std::mt19937 random(5);
    SentenceStream stream;
    std::uint64_t accepted = 0;
    for (int round = 0; round < 2000; ++round) {
        std::string garbage(random() % 300, '\0');
        for (char& byte : garbage) {
            byte = static_cast<char>(random() % 4 == 0 ? "$*,\r\n0P"[random() % 7] : random() % 256);
        }
        accepted += add(stream, garbage + kSentence + "\n").size();
    }
    EXPECT_EQ(accepted, 2000U);
    EXPECT_EQ(stream.counts().accepted, 2000U);
}

}  // namespace
}  // namespace boresight::orientation
