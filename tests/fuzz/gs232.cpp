// SPDX-License-Identifier: GPL-3.0-or-later
// The output of a control box on a serial port: gives any bytes to the conversations with a GS-232 box and with the
// ESP32 relay controller, and to the reading of their lines.
#include "core/base/control_characters.h"
#include "core/gs232/box_reply.h"
#include "core/gs232/esp32_reply.h"
#include "core/gs232_mount/box_talk.h"
#include "core/gs232_mount/esp32_talk.h"
#include "core/serial/line_splitter.h"
#include "tests/fuzz/harness.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <variant>

namespace boresight::fuzz {
namespace {

using namespace boresight::gs232;

constexpr std::chrono::milliseconds kTick{20};

bool isPossible(const std::optional<Angle>& angle)
{
    return !angle || (std::isfinite(angle->degrees()) && angle->degrees() >= -180.0 && angle->degrees() <= 540.0);
}

void checkEsp32Line(std::string_view line)
{
    const esp32::Reply reply = esp32::parseLine(line);
    if (const auto* const place = std::get_if<esp32::Place>(&reply)) {
        require(place->azimuth.degrees() >= 0.0 && place->azimuth.degrees() <= 360.0, "a heading is folded");
        require(std::isfinite(place->elevation.degrees()), "an elevation is a number");
        require(esp32::parseLine(line.substr(0, line.size() - 1)) != reply, "a cut line is not the same position");
    }
    const bool isOfGs232 = std::holds_alternative<Position>(parseReply(line));
    require(!(isOfGs232 && esp32::isLineOfEsp32(line)), "no line proves both kinds of box");
}

// Returns false if the line was not understood.
bool checkLine(std::string_view line)
{
    checkEsp32Line(line);
    const Reply reply = parseReply(line);
    const auto* const position = std::get_if<Position>(&reply);
    if (position == nullptr) {
        return !std::holds_alternative<Unknown>(reply);
    }
    require(position->azimuth || position->elevation, "a position has an axis");
    require(isPossible(position->azimuth) && isPossible(position->elevation), "an angle is one of a rotator");
    require(parseReply(std::string("  ") + std::string(line) + " ") == reply, "blanks around a line change nothing");
    return true;
}

// Checks all lines.
bool checkLines(std::string_view bytes)
{
    bool understood = true;
    LineSplitter splitter;
    splitter.add(bytes, [&](std::string_view line) { understood = checkLine(line) && understood; });
    splitter.add("\n", [&](std::string_view line) { understood = checkLine(line) && understood; });
    return understood && splitter.overlongLines() == 0;
}

void checkSent(const BoxTalk& talk, Proof before, const std::string& sent)
{
    if (before == Proof::Foreign) {
        require(sent.empty(), "a foreign device gets nothing more");
    } else if (before == Proof::Unknown) {
        require(sent.empty() || sent == "C2\r", "before an answer nothing but the question is sent");
    } else {
        require(sent.empty() || sent == "C2\r" || sent == "S\r" || sent == "W123 045\r", "only our commands are sent");
    }
    require(!hasControlCharacters(talk.strange()) && talk.strange().size() <= 24,
            "what is shown is printable and short");
}

// In pieces of this size, one in each tick.
Proof talked(std::string_view bytes, std::size_t piece)
{
    BoxTalk talk(Question::Both, 9600);
    SteadyTime now = SteadyTime{} + std::chrono::hours(1);
    for (; !bytes.empty(); bytes.remove_prefix(std::min(piece, bytes.size()))) {
        talk.take(bytes.substr(0, piece), now);
        if (const auto position = talk.takePlaces()) {
            require(position->azimuth && position->elevation, "an answer has what was asked for");
            require(talk.proof() == Proof::Box, "who answers is a box");
        }
        talk.go("W123 045\r");
        const Proof before = talk.proof();
        checkSent(talk, before == Proof::Box ? before : Proof::Unknown, talk.send(now));
        now += kTick;
    }
    for (const SteadyTime end = now + std::chrono::seconds(5); now < end; now += kTick) {
        talk.stop();
        const Proof before = talk.proof();
        checkSent(talk, before, talk.send(now));
    }
    return talk.proof();
}

void checkSentToEsp32(Proof before, const Esp32Talk& talk, const std::string& sent)
{
    if (before == Proof::Foreign) {
        require(sent.empty(), "a foreign device gets nothing more");
    } else if (before == Proof::Unknown) {
        require(sent.empty() || sent == "VE\r", "before its version nothing but this question is sent");
    } else {
        const bool isStop = sent.starts_with("SA\rSE\r");
        const bool isQuestion = sent == "P\r" || sent == "DEBUG\r" || sent == "CALSTATS\r";
        const bool isKnown = isQuestion || sent.starts_with("AZ ") || sent.starts_with("EL ");
        require(sent.empty() || isStop || isKnown, "only our commands are sent");
    }
    require(!hasControlCharacters(talk.strange()) && talk.strange().size() <= 24,
            "what is shown is printable and short");
}

// In pieces of this size, one in each tick, with a target in each tick and stops at the end.
void talkedToEsp32(std::string_view bytes, std::size_t piece)
{
    Esp32Talk talk(Angle::fromDegrees(180.0));
    SteadyTime now = SteadyTime{} + std::chrono::hours(1);
    const auto sendsOnce = [&] {
        const Proof before = talk.proof();
        checkSentToEsp32(before, talk, talk.send(now));
        now += kTick;
    };
    for (; !bytes.empty(); bytes.remove_prefix(std::min(piece, bytes.size()))) {
        talk.take(bytes.substr(0, piece), now);
        if (const auto place = talk.takePlaces()) {
            require(talk.proof() == Proof::Box, "who answers is a box");
            require(place->azimuth->degrees() >= 0.0 && place->azimuth->degrees() <= 360.0, "inside the travel");
        }
        if (const auto& offsets = talk.offsets()) {
            require(esp32::parseOffsets(esp32::offsetsText(*offsets)) == offsets, "offsets are read as they are saved");
        }
        if (const auto digits = talk.digits(now)) {
            require(digits->system <= 3 && digits->magnetometer <= 3, "digits are 0 to 3");
        }
        talk.go(Axis::Azimuth, Angle::fromDegrees(123.4));
        sendsOnce();
    }
    for (int i = 0; i < 250; ++i) {
        talk.stop();
        sendsOnce();
    }
}

}  // namespace

Grammar grammar()
{
    Grammar grammar;
    grammar.corpus = {
        "+0180+0090\r\n",
        "AZ=180  EL=090\r\n",
        "AZ=450EL=000\r\n",
        "+0100\r\n",
        "\r\n>AZ=359 EL=012\r\n",
        "?>\r\n",
        "C2\rAZ=100  EL=010\r\n",
        "W123 046\r\r+0123.4+0046.0\r\n",
        "-0010+0003\r\n\r\r+0011+0004\r\n",
        "RPRT -1\rVEAdamESP32v1.0\r123.4 45.6\r123.4 45.6\r123.4 45.6\r123.4 45.6\r123.4 45.6\r",
        "DEBUG ON\rDEBUG | RawX:33.4 | CalcAZ:123.4 | Calib[S:3 G:2 A:1 M:0]\r\n",
        "CALIB: SYS=0 GYR=3 ACC=1 MAG=2\r\nReady! Type HELP for list of commands.\r\n",
        "--- Calibration Offsets ---\r\nAccel Off: 1,-2,3\r\nMag   Off: 4,5,6\r\nGyro  Off: 7,8,9\r\nAccel "
        "Rad: 1000\r\nMag   Rad: 700\r\nDEBUG | RawX:1.0 | CalcAZ:91.0 | Calib[S:3 G:3 A:3 M:3]\r\n"};
    grammar.tokens = {"AZ=",
                      "EL=",
                      "+0",
                      "-0",
                      "+",
                      "-",
                      "?>",
                      ">",
                      "\r",
                      "\n",
                      "\r\n",
                      "C2",
                      "S",
                      "M123",
                      "W123 046",
                      "000",
                      "450",
                      "999",
                      "180",
                      "0090",
                      ".5",
                      ".",
                      "  ",
                      "nan",
                      "inf",
                      "1e3",
                      "RPRT 0",
                      "RPRT -1",
                      "VEAdamESP32",
                      "123.4 45.6",
                      "360.1 ",
                      "DEBUG | ",
                      "Accel Off: ",
                      "Mag   Rad: ",
                      "Calib[S:",
                      "CALIB: ",
                      "Ready! ",
                      "\xfe\xfe\xe0",
                      "\xfd",
                      "IF000142",
                      ";",
                      std::string(1, '\0'),
                      "\x1b[2J",
                      std::string(64, '1'),
                      std::string(LineSplitter::kLongestLine, 'x')};
    grammar.separators = " \r\n=+";
    grammar.maxLength = 400;
    grammar.persistence = 40;
    return grammar;
}

void feed(std::span<const std::uint8_t> input)
{
    const std::string_view bytes = asText(input);
    const bool understood = checkLines(bytes);
    (void)talked(bytes, bytes.size() + 1);
    (void)talked(bytes, 1);
    (void)talked(bytes, 7);
    for (const std::size_t piece : {bytes.size() + 1, std::size_t(1), std::size_t(7)}) {
        talkedToEsp32(bytes, piece);
        talkedToEsp32(std::string("VEAdamESP32v1.0\r") + std::string(bytes), piece);
    }
    if (understood && bytes.find_first_not_of("\r\n") != std::string_view::npos) {
        accept();
    }
}

}  // namespace boresight::fuzz
