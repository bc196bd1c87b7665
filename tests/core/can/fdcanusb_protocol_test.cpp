// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/can/fdcanusb_protocol.h"

#include "core/base/hex.h"
#include "core/can/line_checksum.h"
#include "tests/fakes/text_of.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <gmock/gmock.h>

#include <random>

namespace boresight::fdcanusb {
namespace {

using testing::HasSubstr;

CanFrame frameOf(std::uint32_t id, std::string_view hex)
{
    CanFrame frame;
    frame.id = id;
    frame.extended = id > kMaxStandardId;
    frame.setPayload(parseHex(hex).value());
    return frame;
}

TEST(FdcanusbProtocol, WritesFlagsAsOneWordAndForcesOnlyAShortExtendedId)
{
    CanFrame frame = frameOf(0x8001, "11000f");
    EXPECT_EQ(sendLine(frame), "can send 8001 11000f BF");
    frame.bitRateSwitch = false;
    EXPECT_EQ(sendLine(frame), "can send 8001 11000f bF");
    frame.bitRateSwitch = true;
    frame.flexibleData = false;  // a classic frame has no fast phase
    EXPECT_EQ(sendLine(frame), "can send 8001 11000f bf");
    frame.id = 0x101;
    EXPECT_EQ(sendLine(frame), "can ext 0101 11000f bf");
    frame.extended = false;
    EXPECT_EQ(sendLine(frame), "can send 0101 11000f bf");
    EXPECT_EQ(sendLine(frameOf(0x12807f, "50")), "can send 12807f 50 BF");
}

TEST(FdcanusbProtocol, PadsWithNopAndNeverSendsNoData)
{
    EXPECT_EQ(sendLine(frameOf(0x8001, "")), "can send 8001 50 BF");
    EXPECT_EQ(sendLine(frameOf(0x8001, "0102030405060708")), "can send 8001 0102030405060708 BF");
    EXPECT_EQ(sendLine(frameOf(0x8001, "010203040506070809")), "can send 8001 010203040506070809505050 BF");
}

TEST(FdcanusbProtocol, RefusesWhatNoBusCanCarry)
{
    EXPECT_THAT(textOf(sendLine(frameOf(0x20000000, "50")).error()), HasSubstr("29 bits"));
    CanFrame classic = frameOf(0x8001, "010203040506070809");
    classic.flexibleData = false;
    EXPECT_THAT(textOf(sendLine(classic).error()), HasSubstr("too many bytes"));
}

TEST(FdcanusbProtocol, ReadsFramesOfOldAndNewFirmware)
{
    const CanFrame expected = frameOf(0x100, "210000");
    EXPECT_EQ(std::get<CanFrame>(parseAnswer("rcv 0100 210000 e B F r x-1")), expected);
    EXPECT_EQ(std::get<CanFrame>(parseAnswer("rcv 100 210000 E B F r t123456 f00")).extended, true);
    EXPECT_EQ(std::get<CanFrame>(parseAnswer("rcv 0100 210000 e B F r t123456 f00")), expected);
    EXPECT_EQ(std::get<CanFrame>(parseAnswer("rcv 0100 210000")), expected);
    EXPECT_EQ(std::get<CanFrame>(parseAnswer("rcv 0100  e B F r x-1")), frameOf(0x100, ""));
    EXPECT_EQ(std::get<CanFrame>(parseAnswer("rcv 1E00 50 E B F r x05")), frameOf(0x1e00, "50"));
    const auto classic = std::get<CanFrame>(parseAnswer("rcv 0100 210000 e b f r x-1"));
    EXPECT_FALSE(classic.flexibleData);
    EXPECT_FALSE(classic.bitRateSwitch);
}

TEST(FdcanusbProtocol, ReadsOkErrAndStatus)
{
    EXPECT_TRUE(std::holds_alternative<Accepted>(parseAnswer("OK")));
    const auto refusal = std::get<Refusal>(parseAnswer("ERR not in BusOn state"));
    EXPECT_EQ(refusal.text, "not in BusOn state");
    EXPECT_TRUE(refusal.notOnBus());
    EXPECT_EQ(std::get<Refusal>(parseAnswer("ERR")).text, "");
    EXPECT_FALSE(std::get<Refusal>(parseAnswer("ERR unknown flag")).notOnBus());
    const auto ill = std::get<BusStatus>(parseAnswer("lec=3 dlec=7 err=1 warn=1 busoff=1 pexc=0 tdc=0"));
    EXPECT_TRUE(ill.busOff);
    EXPECT_TRUE(ill.errorPassive);
    const auto well = std::get<BusStatus>(parseAnswer("lec=0 dlec=0 err=0 warn=0 busoff=0"));
    EXPECT_FALSE(well.busOff);
    EXPECT_FALSE(well.errorPassive);
    EXPECT_TRUE(std::holds_alternative<RemoteFrame>(parseAnswer("rcv 0100 00 e b f R x-1")));
}

TEST(FdcanusbProtocol, DamagedLinesAreUnreadable)
{
    for (const char* const bad : {"",
                                  " ",
                                  "ok",
                                  "OK ",
                                  " OK",
                                  "OKAY",
                                  "rcv",
                                  "rcv 0100",
                                  "rcv 0100 2",
                                  "rcv 0100 2g e B F r x-1",
                                  "rcv  210000 e B F r",
                                  "rcv 0x10 2100",
                                  "rcv -100 2100",
                                  "rcv 000000100 2100",
                                  "rcv 20000000 2100 E B F r",
                                  "rcv 0800 2100 e B F r x-1",                  // too large for a standard identifier
                                  "rcv 0100 010203040506070809 e B F r x-1",    // no frame has 9 bytes
                                  "rcv 0100 0102030405060708090a0b0c e b f r",  // and no classic frame has 12
                                  "rcv 0100 21rcv 0100 210000 e B F r x-1",
                                  "lec=",
                                  "lec=0 busoff=2",
                                  "lec=0 busoff=0 busoff=1",
                                  "xrcv 1 00"}) {
        EXPECT_TRUE(std::holds_alternative<Unreadable>(parseAnswer(bad))) << bad;
    }
    const std::string tooLong = "rcv 0100 " + std::string(130, '5') + " e B F r x-1";
    EXPECT_TRUE(std::holds_alternative<Unreadable>(parseAnswer(tooLong)));
}

TEST(FdcanusbProtocol, ChecksumIsVerifiedWhenPresentAndDemandedInChecksumMode)
{
    EXPECT_TRUE(std::holds_alternative<Accepted>(parseAnswer("OK *BD")));
    EXPECT_TRUE(std::holds_alternative<Unreadable>(parseAnswer("OK *BE")));
    EXPECT_TRUE(std::holds_alternative<Accepted>(parseAnswer("OK *BD", ChecksumRule::Require)));
    EXPECT_TRUE(std::holds_alternative<Unreadable>(parseAnswer("OK", ChecksumRule::Require)));
    EXPECT_EQ(std::get<CanFrame>(parseAnswer(withChecksum("rcv 0100 "))), frameOf(0x100, ""));
}

// CRC-8 finds every error within 8 bits, so it finds every single wrong character.
// REQ-CAN-08
TEST(FdcanusbProtocol, NoSingleDamagedCharacterPassesTheChecksum)
{
    const std::string good = withChecksum("rcv 0100 429F64 e B F r x-1");
    for (std::size_t at = 0; at <= good.rfind('*'); ++at) {
        for (int value = 0; value < 256; ++value) {
            std::string line = good;
            line[at] = static_cast<char>(value);
            const Answer answer = parseAnswer(line, ChecksumRule::Require);
            EXPECT_EQ(std::holds_alternative<CanFrame>(answer), line == good) << line;
        }
    }
}

// With every mutation the parser survives, and what it accepts is a frame that a bus can carry.
// REQ-CAN-03: A damaged, incomplete, over-long or unknown line is counted and never used.
TEST(FdcanusbProtocol, MutatedLinesNeverYieldAnImpossibleFrame)
{
    const std::vector<std::string> seeds{"rcv 0100 CEBDE68D7DB39AD27643196A0173BCEB32294EAB e B F r x-1",
                                         "OK",
                                         "ERR not in BusOn state",
                                         "rcv 0100  e B F r x-1",
                                         "rcv 1E00 D8DE0CA303606A95393B5917 *6D",
                                         "lec=3 dlec=7 err=1 warn=1 busoff=1"};
    std::mt19937 random(20261121);
    const auto below = [&random](std::size_t limit) { return static_cast<std::size_t>(random() % limit); };
    int frames = 0;
    for (int round = 0; round < 200000; ++round) {
        std::string line = seeds[below(seeds.size())];
        for (std::size_t edits = 1 + below(4); edits > 0 && !line.empty(); --edits) {
            const std::size_t at = below(line.size());
            switch (below(4)) {
                case 0:
                    line[at] = static_cast<char>(below(256));
                    break;
                case 1:
                    line.erase(at, 1 + below(8));
                    break;
                case 2:
                    line.insert(at, line.substr(below(line.size()), 1 + below(12)));
                    break;
                default:
                    line[at] = "0123456789ABCDEFef *x"[below(21)];
                    break;
            }
        }
        const Answer answer = parseAnswer(line);
        if (const auto* const frame = std::get_if<CanFrame>(&answer)) {
            ++frames;
            ASSERT_LE(frame->id, frame->extended ? 0x1fffffffU : 0x7ffU) << line;
            ASSERT_EQ(legalCanLength(frame->size), frame->size) << line;
            ASSERT_TRUE(sendLine(*frame).has_value()) << line;
        }
    }
    EXPECT_GT(frames, 1000);  // enough mutated lines were still frames
}

// The lines of the maker: tests/data/moteus_golden.json, or another file with the same schema.
QJsonArray goldenLines()
{
    QFile file(qEnvironmentVariable("MOTEUS_GOLDEN", QStringLiteral(BORESIGHT_TEST_DATA "/moteus_golden.json")));
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << file.fileName().toStdString();
    return QJsonDocument::fromJson(file.readAll()).object()[QLatin1String("serial_lines")].toArray();
}

std::string textOf(const QJsonObject& object, const char* key)
{
    return object[QLatin1String(key)].toString().toStdString();
}

std::uint32_t idOf(const QJsonObject& object, const char* key)
{
    return static_cast<std::uint32_t>(std::stoul(textOf(object, key), nullptr, 16));
}

// The golden lines leave out a flag that the adapter may choose, and separate the flags by a space. Boresight always
// writes both flags in one word. So command, identifier and data must be identical, and every golden flag must be
// present.
void expectSameCommand(const std::string& ours, const std::string& golden)
{
    const std::size_t flagsAt = ours.rfind(' ');
    ASSERT_EQ(ours.substr(0, flagsAt), golden.substr(0, flagsAt));
    for (const char flag : golden.substr(flagsAt)) {
        EXPECT_NE(ours.find(flag, flagsAt), std::string::npos) << ours << " lacks " << flag;
    }
}

// REQ-CAN-01
TEST(FdcanusbGolden, LinesToTheAdapter)
{
    const QJsonArray lines = goldenLines();
    ASSERT_FALSE(lines.isEmpty());
    for (const auto& value : lines) {
        const QJsonObject line = value.toObject();
        SCOPED_TRACE(textOf(line, "name"));
        CanFrame frame = frameOf(idOf(line, "arbitration_id"), textOf(line, "data"));
        frame.bitRateSwitch = line[QLatin1String("brs")].toBool(true);
        frame.flexibleData = line[QLatin1String("fdf")].toBool(true);
        const std::string golden = textOf(line, "tx_line");
        const bool checked = line[QLatin1String("checksum")].toBool();
        EXPECT_EQ(splitChecksum(golden).checksum, checked ? Checksum::Right : Checksum::Absent);
        if (checked) {
            EXPECT_EQ(withChecksum(splitChecksum(golden).text), golden);
        }
        expectSameCommand(sendLine(frame).value(), std::string(splitChecksum(golden).text));
    }
}

// REQ-CAN-02
TEST(FdcanusbGolden, LinesFromTheAdapter)
{
    const QJsonArray lines = goldenLines();
    ASSERT_FALSE(lines.isEmpty());
    for (const auto& value : lines) {
        const QJsonObject line = value.toObject();
        SCOPED_TRACE(textOf(line, "name"));
        const auto rule =
            line[QLatin1String("checksum")].toBool() ? ChecksumRule::Require : ChecksumRule::VerifyIfPresent;
        EXPECT_TRUE(std::holds_alternative<Accepted>(parseAnswer(textOf(line, "ok_line"), rule)));
        if (line.contains(QLatin1String("rx_line"))) {
            const Answer answer = parseAnswer(textOf(line, "rx_line"), rule);
            ASSERT_TRUE(std::holds_alternative<CanFrame>(answer));
            const auto& frame = std::get<CanFrame>(answer);
            EXPECT_EQ(frame.id, idOf(line, "rx_arbitration_id"));
            EXPECT_EQ(frame.extended, frame.id > kMaxStandardId);
            EXPECT_EQ(toHex(frame.payload()), textOf(line, "rx_data"));
        }
    }
}

}  // namespace
}  // namespace boresight::fdcanusb
