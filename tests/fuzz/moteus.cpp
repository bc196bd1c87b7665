// SPDX-License-Identifier: GPL-3.0-or-later
// REQ-MOTEUS-10 (Fuzz.moteus)
// The replies of drives: gives any frames to the codec, the console client and the station's control. The next commands
// of the control must be as valid as with truthful drives.
#include "core/base/hex.h"
#include "core/moteus/codec.h"
#include "core/moteus/diagnostic.h"
#include "tests/core/control/station_rig.h"
#include "tests/core/moteus/exercise.h"
#include "tests/fuzz/harness.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <vector>

namespace boresight::fuzz {
namespace {

using namespace boresight::moteus;

constexpr std::size_t kMoteusMaxInput = 250;     // five replies to a rotator query
constexpr std::size_t kFrameBytes = 4 + 64;      // identifier and payload, see frameFromBytes()
constexpr std::uint32_t kFirstDriveId = 0x100;   // the reply of drive 1 to the host's motion commands
constexpr std::uint32_t kSecondDriveId = 0x200;  // of drive 2
constexpr std::uint32_t kConsoleId = 0x110;      // of drive 1 to the host's console
constexpr unsigned kMovingBits = 0x0f;           // of the first byte: if all are zero the mount may move
constexpr unsigned kConsoleBit = 0x10;           // a console command is in progress

// The first byte selects the scene. Then each frame is preceded by its length.
std::vector<CanFrame> framesOf(std::span<const std::uint8_t> rest)
{
    std::vector<CanFrame> frames;
    while (!rest.empty()) {
        const std::size_t size = std::min<std::size_t>(rest[0] % (kFrameBytes + 1), rest.size() - 1);
        frames.push_back(frameFromBytes(rest.subspan(1, size)));
        rest = rest.subspan(1 + size);
    }
    return frames;
}

std::string frameBytes(std::uint32_t id, std::span<const std::uint8_t> payload)
{
    std::string bytes(1, static_cast<char>(4 + payload.size()));
    for (const unsigned shift : {24U, 16U, 8U, 0U}) {
        bytes += static_cast<char>(id >> shift & 0xffU);
    }
    return bytes.append(payload.begin(), payload.end());
}

// Empty if the frame is no reply or contains nothing.
std::optional<Reply> checkedReply(const CanFrame& frame)
{
    const auto reply = decodeReply(frame);
    if (!reply) {
        return std::nullopt;
    }
    std::size_t bytes = 0;
    for (const RegisterValue& value : reply->values) {
        bytes += sizeInBytes(value.resolution);
        const auto known = reply->value(value.reg);
        require(!known || std::isfinite(*known), "a register's value is finite or unset");
    }
    for (const TunnelText& text : reply->texts) {
        bytes += text.text.size();
    }
    require(bytes + 2 * reply->errors.size() <= frame.size, "a reply has no values beyond its payload");
    const auto mode = reply->mode();
    require(!mode || (*mode >= Mode::Stopped && *mode <= Mode::Brake), "a mode is one of the protocol");
    const auto home = reply->homeState();
    require(!home || (*home >= HomeState::Relative && *home <= HomeState::Output), "so is a home state");
    return *reply;
}

void checkConsoleFrame(const CanFrame& frame)
{
    const Arbitration to = fromCanId(frame.id);
    require(to.destination == 1 && to.source == kDiagnosticHostId && to.prefix == 0, "the console speaks to its drive");
    require(legalCanLength(frame.size) == frame.size && frame.size > 0, "a console frame has a legal length");
}

void talkToConsole(std::span<const Reply> replies, std::string_view command)
{
    DiagnosticClient client({.destination = 1, .maxSilences = 3, .maxEmptyAnswers = 3});
    require(client.start(command).has_value(), "an idle console takes a command");
    std::size_t received = 0;
    for (const Reply& reply : replies) {
        while (const auto frame = client.nextFrame()) {
            checkConsoleFrame(*frame);
        }
        for (const TunnelText& text : reply.texts) {
            received += text.text.size();
        }
        client.handleReply(reply);
    }
    for (int silence = 0; silence < 8 && client.isBusy(); ++silence) {
        while (client.nextFrame()) {
        }
        client.handleSilence();
    }
    require(client.isFinished(), "a console that falls silent ends its command");
    const auto answer = client.takeAnswer();
    std::size_t told = 0;
    for (const std::string& line : answer.value_or(DiagnosticClient::Lines{})) {
        told += line.size();
        require(!line.empty() && line.find_first_of("\r\n") == std::string::npos, "an answer is made of lines");
    }
    require(told <= received, "an answer is made of what the drive said");
}

std::map<Register, double> writesOf(const CanFrame& frame)
{
    std::map<Register, double> fields;
    SubframeReader reader(frame.payload());
    while (const auto subframe = reader.next()) {
        if (const auto* const block = std::get_if<WriteBlock>(&*subframe)) {
            for (std::uint32_t i = 0; i < block->count; ++i) {
                fields[block->value(i).reg] = block->value(i).value;
            }
        }
    }
    require(reader.end() == ParseEnd::Complete, "what is sent to a drive is well formed");
    return fields;
}

void checkMotion(std::map<Register, double>& fields, const profile::AxisSettings& axis, Seconds watchdog)
{
    const auto near = [&](Register reg, double wanted) { return std::abs(fields[reg] - wanted) <= 1e-6 * wanted; };
    require(near(Register::CommandWatchdogTimeout, watchdog.count()), "a motion command has the watchdog time");
    require(near(Register::CommandMaximumTorque, axis.maxTorque), "a motion command has the torque of the profile");
    require(fields.count(Register::CommandPosition) == 1, "a motion command never means \"go to 0.0\"");
    require(!std::isinf(fields[Register::CommandPosition]), "a commanded position is finite, or keeps the drive's own");
    require(std::isfinite(fields[Register::CommandVelocity]), "a commanded velocity is finite");
    const double speed = std::abs(axis.geometry.toMotor(axis.limits.speed).turns());
    const double fastest = 2.0 * speed;
    require(std::abs(fields[Register::CommandVelocity]) <= fastest, "a commanded velocity is one of the profile");
    // No position ends the motion: only the watchdog does, and the drive's own position limits.
    if (std::isnan(fields[Register::CommandPosition]) && fields[Register::CommandVelocity] != 0.0) {
        require(std::abs(fields[Register::CommandVelocity]) <= 1.000001 * speed,
                "a velocity without a position is within the speed of the axis");
        require(fields.count(Register::CommandIgnorePositionBounds) == 0,
                "a velocity without a position leaves the drive's own limits in force");
    }
    require(fields[Register::CommandVelocityLimit] > 0.0 && fields[Register::CommandVelocityLimit] <= fastest,
            "a motion command has a velocity limit");
    require(
        std::isfinite(fields[Register::CommandAccelerationLimit]) && fields[Register::CommandAccelerationLimit] > 0.0,
        "a motion command has an acceleration limit");
}

void checkOrders(StationRig& rig, bool asked)
{
    rig.control.tick();
    for (const CanFrame& frame : rig.mount.frames()) {
        require(legalCanLength(frame.size) == frame.size, "a command frame has a legal length");
        auto fields = writesOf(frame);
        const bool orders = fields.count(Register::Mode) != 0;  // setting the position value of a drive moves no axis
        require(asked || !orders, "nothing is commanded before anybody asked");
        if (const auto mode = fields.find(Register::Mode); mode != fields.end()) {
            const bool moves = static_cast<Mode>(static_cast<int>(mode->second)) == Mode::Position;
            require(moves || mode->second == static_cast<double>(Mode::Stopped), "a drive holds, moves or stops");
            if (moves) {
                const bool first = fromCanId(frame.id).destination == rig.profile.azimuth.id;
                const StationStatus status = rig.control.status();
                const AxisStatus& axis = first ? status.azimuth : status.elevation;
                const bool lost = !axis.turnKnown || !axis.actual || !axis.travel.contains(*axis.actual);
                require(lost || fields.count(Register::CommandIgnorePositionBounds) == 0,
                        "the drive's own limits stay in force");
                checkMotion(fields, first ? rig.profile.azimuth : rig.profile.elevation, rig.profile.control.watchdog);
            }
        }
    }
}

// Gives the replies to a control that has its drives and moves them in some scenes.
void tellStation(std::span<const CanFrame> frames, bool moving)
{
    StationRig rig;
    if (moving) {
        rig.run(Seconds(0.2));
        require(rig.point(40.0, 30.0).has_value(), "the mount points when it is asked");
        rig.run(Seconds(0.3));
    }
    for (CanFrame frame : frames) {
        rig.clock.advance(StationRig::kTick);
        frame.received = rig.clock.now();
        rig.mount.take(frame);
        checkOrders(rig, moving);
    }
    const StationStatus status = rig.control.status();
    for (const AxisStatus* const axis : {&status.azimuth, &status.elevation}) {
        require(!axis->actual || axis->actual->isFinite(), "a shown position is finite");
    }
}

std::string payloadOf(const QJsonValue& exchange, const char* key)
{
    const auto bytes = parseHex(exchange.toObject()[QLatin1String(key)].toString().toStdString());
    require(bytes.has_value(), "a recorded payload is hexadecimal");
    return std::string(asText(*bytes));
}

std::vector<std::string> recordedReplies()
{
    QFile file(QStringLiteral(BORESIGHT_TEST_DATA "/moteus_golden.json"));
    require(file.open(QIODevice::ReadOnly), "the recorded replies can be read");
    const QJsonObject all = QJsonDocument::fromJson(file.readAll()).object();
    std::vector<std::string> frames;
    const QJsonArray replies = all[QStringLiteral("replies")].toArray();
    for (const auto& reply : replies) {
        frames.push_back(frameBytes(kFirstDriveId, asBytes(payloadOf(reply, "payload"))));
        frames.push_back(frameBytes(kSecondDriveId, asBytes(payloadOf(reply, "payload"))));
    }
    const QJsonArray texts = all[QStringLiteral("diagnostic_replies")].toArray();
    for (const auto& text : texts) {
        frames.push_back(frameBytes(kConsoleId, asBytes(payloadOf(text, "payload"))));
    }
    return frames;
}

std::string stateFrame(std::uint32_t id, Mode mode, double position, int fault)
{
    std::vector<RegisterValue> values;
    const std::map<Register, double> state{{Register::Mode, static_cast<double>(mode)},
                                           {Register::Position, position},
                                           {Register::HomeState, 2.0},
                                           {Register::Voltage, 24.0},
                                           {Register::Fault, fault}};
    for (const RegisterRead& read : rotatorQuery()) {
        const auto known = state.find(read.reg);
        values.push_back({read.reg, read.resolution, known == state.end() ? 0.0 : known->second});
    }
    SubframeWriter writer;
    writer.appendReplies(values);
    return frameBytes(id, writer.bytes());
}

std::string packet(std::uint8_t number, std::string_view text)
{
    SubframeWriter writer;
    writer.append(TunnelPacket{kDiagnosticChannel, number, asBytes(text)});
    return frameBytes(kConsoleId, writer.bytes());
}

std::string console(std::string_view text)
{
    return packet(1, "") + packet(2, text) + packet(3, "\r\nOK\r\n") + packet(4, "");
}

std::string littleEndian(std::uint32_t bits)
{
    std::string bytes;
    for (const unsigned shift : {0U, 8U, 16U, 24U}) {
        bytes += static_cast<char>(bits >> shift & 0xffU);
    }
    return bytes;
}

}  // namespace

Grammar grammar()
{
    Grammar grammar;
    for (const std::string& frame : recordedReplies()) {
        grammar.corpus.push_back("\x01" + frame);
    }
    for (const char scene : {'\0', '\x01', '\x02', '\x03', '\x11', '\x12', '\x13', '\x14'}) {
        for (const Mode mode : {Mode::Stopped, Mode::Fault, Mode::Position, Mode::PositionTimeout, Mode::Brake}) {
            std::string frames(1, scene);
            for (const double position : {0.0, 0.1}) {
                frames += stateFrame(kFirstDriveId, mode, position, mode == Mode::Fault ? 35 : 0);
                frames += stateFrame(kSecondDriveId, mode, -0.25 - position, 0);
            }
            grammar.corpus.push_back(frames);
        }
        grammar.corpus.push_back(scene + console("servo.default_timeout_s 0.1\r\nid.id 1"));
        grammar.corpus.push_back(scene + console("0.1"));
        grammar.corpus.push_back(scene + console("ERR unknown"));
    }
    for (const float number : {0.0F, -0.0F, 1.0F, INFINITY, -INFINITY, NAN, 3.4e38F, -3.4e38F, 1e-45F, 16777217.0F}) {
        grammar.tokens.push_back(littleEndian(std::bit_cast<std::uint32_t>(number)));
    }
    for (const char* const bytes : {"20",       "21",
                                    "24",       "28",
                                    "2c",       "2d",
                                    "2f",       "23",
                                    "30",       "31",
                                    "40",       "41",
                                    "42",       "43",
                                    "44",       "50",
                                    "00",       "01",
                                    "0d",       "11",
                                    "7f",       "80",
                                    "ff",       "0080",
                                    "00000080", "ffff",
                                    "ffffff7f", "8080808010",
                                    "2f01",     "210001",
                                    "21000a",   "21000b",
                                    "290080",   "2d01ffffffff0f",
                                    "430102",   "4401",
                                    "0d0a",     "4f4b0d0a",
                                    "4552520a", "00000100",
                                    "00000200", "00000110",
                                    "00008001", "0001011f"}) {
        grammar.tokens.emplace_back(asText(parseHex(bytes).value()));
    }
    grammar.maxLength = kMoteusMaxInput;
    grammar.persistence = 70;
    return grammar;
}

void feed(std::span<const std::uint8_t> input)
{
    if (input.empty()) {
        return;
    }
    const std::vector<CanFrame> frames = framesOf(input.subspan(1));
    std::vector<Reply> replies;
    bool complete = !frames.empty();
    for (const CanFrame& frame : frames) {
        exercise(frame);
        const auto reply = checkedReply(frame);
        complete = complete && reply && reply->end == ParseEnd::Complete &&
                   (!reply->values.empty() || !reply->texts.empty() || !reply->errors.empty());
        if (reply) {
            replies.push_back(*reply);
        }
    }
    talkToConsole(replies, (input[0] & kConsoleBit) != 0 ? "conf get id.id" : "conf list");
    tellStation(frames, (input[0] & kMovingBits) == 0);
    if (complete) {
        accept();
    }
}

}  // namespace boresight::fuzz
