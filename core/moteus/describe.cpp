// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus/describe.h"

#include "core/base/hex.h"
#include "core/base/overloaded.h"
#include "core/moteus/arbitration.h"
#include "core/moteus/faults.h"

#include <cmath>
#include <iomanip>
#include <locale>
#include <sstream>

namespace boresight::moteus {
namespace {

std::ostringstream plainStream()
{
    std::ostringstream stream;
    stream.imbue(std::locale::classic());
    return stream;
}

std::string number(double value)
{
    auto stream = plainStream();
    stream << std::setprecision(9) << value;
    return stream.str();
}

std::string hexNumber(std::uint32_t value, int digits = 1)
{
    auto stream = plainStream();
    stream << "0x" << std::hex << std::setw(digits) << std::setfill('0') << value;
    return stream.str();
}

std::string numbered(Register reg)
{
    return hexNumber(static_cast<std::uint32_t>(reg), 3) + ' ' + registerName(reg);
}

// The text in the form of a C string literal, because tunnels also carry binary data.
std::string quoted(std::span<const std::uint8_t> bytes)
{
    std::string text = "\"";
    for (const std::uint8_t byte : bytes) {
        if (byte == '\r') {
            text += "\\r";
        } else if (byte == '\n') {
            text += "\\n";
        } else if (byte == '"' || byte == '\\') {
            text += {'\\', static_cast<char>(byte)};
        } else if (byte >= 0x20 && byte < 0x7f) {
            text += static_cast<char>(byte);
        } else {
            text += "\\x" + hexNumber(byte, 2).substr(2);
        }
    }
    return text + '"';
}

// The meaning of a number as a text. Empty for plain quantities.
std::string meaning(const RegisterValue& item)
{
    const int code = std::abs(item.value) < 256 ? static_cast<int>(item.value) : -1;
    switch (item.reg) {
        case Register::Mode:
            return std::string(code >= 0 ? modeText(static_cast<Mode>(code)) : "undefined mode");
        case Register::HomeState:
            return std::string(code >= 0 ? homeStateText(static_cast<HomeState>(code)) : "undefined home state");
        case Register::Fault:
            return std::string(faultText(code).name);
        case Register::TrajectoryComplete:
            return code != 0 ? "yes" : "no";
        default:
            return {};
    }
}

std::string valueText(const RegisterValue& item)
{
    const auto kind = registerKind(item.reg);
    if (std::isnan(item.value)) {
        return "unset";
    }
    if (kind == Kind::Identity && item.resolution == Resolution::Int32) {
        return hexNumber(toWire(item.value, Kind::Identity, Resolution::Int32), 8);
    }
    const std::string note = meaning(item);
    const std::string_view unit = kind ? unitText(*kind) : std::string_view();
    return number(item.value) + (note.empty() ? "" : ' ' + note) + (unit.empty() ? "" : ' ' + std::string(unit));
}

std::string errorText(std::uint32_t code, std::string_view second)
{
    switch (code) {
        case kUnknownRegister:
            return "1 (unknown, not accessible or not in that format)";
        case kNotWritable:
            return "2 (" + std::string(second) + ')';
        default:
            return std::to_string(code);
    }
}

class Lines
{
public:
    void add(const Subframe& subframe)
    {
        if (std::holds_alternative<Nop>(subframe)) {
            ++m_nops;
            return;
        }
        flushNops();
        std::visit([this](const auto& part) { addPart(part); }, subframe);
    }

    void addEnd(ParseEnd end)
    {
        flushNops();
        if (end == ParseEnd::Truncated) {
            line("the last subframe is cut off");
        } else if (end == ParseEnd::Unknown) {
            line("unknown subframe: the rest cannot be read");
        }
    }

    void line(const std::string& text) { m_text += text + '\n'; }
    [[nodiscard]] const std::string& text() const { return m_text; }

private:
    void flushNops()
    {
        if (m_nops > 0) {
            line("padding " + std::to_string(m_nops));
        }
        m_nops = 0;
    }

    void addPart(const Nop&) {}
    void addPart(const ReadBlock& block)
    {
        const std::string format = " as " + std::string(resolutionText(block.resolution));
        if (replySize(block) > kMaxCanPayload) {  // also keeps a malicious count from filling the screen
            line("read " + std::to_string(block.count) + " registers from " + numbered(block.first) + format +
                 ": more than a reply can hold");
            return;
        }
        for (std::uint32_t i = 0; i < block.count; ++i) {
            line("read " + numbered(block.first + i) + format);
        }
    }
    void addPart(const WriteBlock& block) { addValues("write ", block); }
    void addPart(const ReplyBlock& block) { addValues("reply ", block); }
    void addPart(const WriteError& error)
    {
        line("write error " + numbered(error.reg) + ": code " + errorText(error.code, "not writable"));
    }
    void addPart(const ReadError& error)
    {
        line("read error " + numbered(error.reg) + ": code " + errorText(error.code, "does not fit into the reply"));
    }
    void addPart(const TunnelToDevice& text)
    {
        line("tunnel " + std::to_string(text.channel) + " to drive: " + quoted(text.bytes));
    }
    void addPart(const TunnelFromDevice& text)
    {
        line("tunnel " + std::to_string(text.channel) + " to host: " + quoted(text.bytes));
    }
    void addPart(const TunnelPoll& poll)
    {
        line("poll tunnel " + std::to_string(poll.channel) + ", at most " + std::to_string(poll.maximum) + " bytes");
    }
    void addPart(const TunnelPacket& packet)
    {
        line("tunnel " + std::to_string(packet.channel) + " to host, packet " + std::to_string(packet.number) + ": " +
             quoted(packet.bytes));
    }
    void addPart(const TunnelPollFlow& poll)
    {
        line("poll tunnel " + std::to_string(poll.channel) + ", packet " + std::to_string(poll.lastNumber) +
             " seen, at most " + std::to_string(poll.maximum) + " bytes");
    }

    void addValues(const std::string& verb, const ValueBlock& block)
    {
        for (std::uint32_t i = 0; i < block.count; ++i) {
            const RegisterValue item = block.value(i);
            line(verb + hexNumber(static_cast<std::uint32_t>(item.reg), 3) + ' ' + describe(item));
        }
    }

    std::string m_text;
    int m_nops = 0;
};

bool onlyDrivesSend(const Subframe& subframe)
{
    return std::holds_alternative<ReplyBlock>(subframe) || std::holds_alternative<WriteError>(subframe) ||
           std::holds_alternative<ReadError>(subframe) || std::holds_alternative<TunnelFromDevice>(subframe) ||
           std::holds_alternative<TunnelPacket>(subframe);
}

// Without the reply bit the identifier does not show the direction of a frame, but the first subframe does. An empty
// frame counts as an empty reply, unless our own host sent it.
bool isReply(const CanFrame& frame)
{
    const Arbitration id = fromCanId(frame.id);
    if (id.replyWanted) {
        return false;
    }
    SubframeReader reader(frame.payload());
    while (const auto subframe = reader.next()) {
        if (!std::holds_alternative<Nop>(*subframe)) {
            return onlyDrivesSend(*subframe);
        }
    }
    return id.source != kHostId;
}

std::string heading(const CanFrame& frame)
{
    const Arbitration id = fromCanId(frame.id);
    const std::string prefix = id.prefix == 0 ? "" : ", prefix " + hexNumber(id.prefix);
    if (isReply(frame)) {
        return "reply of drive " + std::to_string(id.source) + " to " + std::to_string(id.destination) + prefix;
    }
    const std::string target =
        id.destination == kBroadcastId ? "every drive" : "drive " + std::to_string(id.destination);
    return "request from " + std::to_string(id.source) + " to " + target +
           (id.replyWanted ? ", wants a reply" : ", no reply wanted") + prefix;
}

}  // namespace

std::string describe(const RegisterValue& item)
{
    return registerName(item.reg) + ' ' + valueText(item) + " (" + std::string(resolutionText(item.resolution)) + ')';
}

std::string describe(const CanFrame& frame)
{
    Lines lines;
    lines.line(heading(frame));
    SubframeReader reader(frame.payload());
    while (const auto subframe = reader.next()) {
        lines.add(*subframe);
    }
    lines.addEnd(reader.end());
    return lines.text();
}

std::string uuidText(const Uuid& uuid)
{
    std::vector<std::uint8_t> bytes;
    for (const std::uint32_t word : uuid) {
        for (const unsigned shift : {0u, 8u, 16u, 24u}) {
            bytes.push_back(static_cast<std::uint8_t>(word >> shift));
        }
    }
    std::string text = toHex(bytes);
    for (const std::size_t place : {20u, 16u, 12u, 8u}) {
        text.insert(place, 1, '-');
    }
    return text;
}

std::string firmwareText(const Reply& reply)
{
    const std::optional<double> value = reply.value(Register::FirmwareVersion);
    if (!value) {
        return "?";
    }
    const std::uint32_t version = toWire(*value, Kind::Identity, Resolution::Int32);
    return std::to_string(version >> 16) + '.' + std::to_string((version >> 8) & 0xff) + '.' +
           std::to_string(version & 0xff);
}

}  // namespace boresight::moteus
