// SPDX-License-Identifier: GPL-3.0-or-later
// The output of an adapter: gives any bytes to the line splitter, the line protocol and a real FdcanusbLink behind a
// pseudo-terminal. The link must count exactly the contents of the lines.
#include "core/base/control_characters.h"
#include "core/can/fdcanusb_link.h"
#include "core/can/fdcanusb_protocol.h"
#include "core/can/line_checksum.h"
#include "core/serial/line_splitter.h"
#include "core/sim_bus/fdcanusb_request.h"
#include "tests/fakes/manual_clock.h"
#include "tests/fakes/pseudo_terminal.h"
#include "tests/fuzz/harness.h"

#include <QCoreApplication>
#include <QEventLoop>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <array>
#include <variant>
#include <vector>

namespace boresight::fuzz {
namespace {

using namespace boresight::fdcanusb;

constexpr std::size_t kFdcanusbMaxInput = 1200;  // several lines, one of them too long; far less than a terminal holds
constexpr std::array<std::uint8_t, 3> kLastWords{0x5a, 0xa5, 0x5a};

struct Lines
{
    std::vector<std::string> lines;
    std::uint64_t overlong = 0;

    bool operator==(const Lines&) const = default;
};

Lines split(std::string_view bytes, std::size_t piece)
{
    Lines result;
    LineSplitter splitter;
    for (; !bytes.empty(); bytes.remove_prefix(std::min(piece, bytes.size()))) {
        splitter.add(bytes.substr(0, piece), [&](std::string_view line) { result.lines.emplace_back(line); });
    }
    result.overlong = splitter.overlongLines();
    return result;
}

Lines checkedLines(std::string_view bytes)
{
    const Lines whole = split(bytes, bytes.size());
    require(split(bytes, 1) == whole && split(bytes, 7) == whole, "lines do not depend on how the bytes arrive");
    for (const std::string& line : whole.lines) {
        require(!line.empty() && line.size() <= LineSplitter::kLongestLine, "a line is neither empty nor overlong");
        require(line.find_first_of("\r\n") == std::string::npos, "a line has no line end in it");
    }
    return whole;
}

bool same(const Answer& a, const Answer& b)
{
    const auto* const frame = std::get_if<CanFrame>(&a);
    return a.index() == b.index() && (frame == nullptr || *frame == std::get<CanFrame>(b));
}

void checkFrame(const CanFrame& frame)
{
    require(frame.size <= kMaxCanPayload && legalCanLength(frame.size) == frame.size, "a frame has a legal length");
    require(frame.id <= (frame.extended ? 0x1fffffffU : kMaxStandardId), "an identifier fits its frame");
    require(same(parseAnswer(sim::receivedLine(frame)), Answer(frame)), "a received frame writes and reads back");
    const auto line = sendLine(frame);
    require(line.has_value(), "what was received can be sent");
    const auto sent = sim::parseSendRequest(*line);
    CanFrame expected = frame;
    if (expected.size == 0) {
        expected.setPayload(std::array<std::uint8_t, 1>{0x50});
    }
    require(sent && *sent == expected, "a sent frame reads at the adapter as it was");
}

// The number of frames and unreadable lines in one input.
struct Tally
{
    std::uint64_t frames = 0;
    std::uint64_t unreadable = 0;
};

void checkLine(const std::string& line, Tally& tally)
{
    const Answer answer = parseAnswer(line);
    if (const auto* const frame = std::get_if<CanFrame>(&answer)) {
        checkFrame(*frame);
        ++tally.frames;
    }
    tally.unreadable += std::holds_alternative<Unreadable>(answer) ? 1 : 0;
    const Answer strict = parseAnswer(line, ChecksumRule::Require);
    require(std::holds_alternative<Unreadable>(strict) || same(strict, answer), "a demanded checksum only refuses");
    if (line.find('*') == std::string::npos) {
        require(same(parseAnswer(withChecksum(line), ChecksumRule::Require), answer), "a checksum changes no meaning");
        require(std::holds_alternative<Unreadable>(strict), "a demanded checksum must be there");
    }
}

// One link for all inputs, as for an adapter that sends all the time.
class Adapter
{
public:
    Adapter()
    {
        require(m_link.open().has_value(), "the link opens");
        QObject::connect(&m_link, &CanLink::frameReceived, &m_loop, [this](const CanFrame& frame) {
            if (std::ranges::equal(frame.payload(), kLastWords) && m_link.status().received >= m_expected) {
                m_loop.quit();
            }
        });
        QObject::connect(&m_link, &CanLink::statusChanged, &m_loop, [](const LinkStatus& status) {
            require(status.state == LinkState::Up || status.state == LinkState::Down, "words do not end the link");
            require(status.state == LinkState::Up || !status.text.isEmpty(), "a bus that is down has a reason");
            require(!hasControlCharacters(status.text.toStdString()), "what the operator reads is printable");
        });
    }

    void say(std::string_view bytes, const Tally& tally, std::uint64_t overlong)
    {
        static const CanFrame command{.id = 0x8001, .extended = true};
        require(m_link.send(std::array{command}).has_value(), "the link sends whatever the adapter said");
        const LinkStatus before = m_link.status();
        m_expected = before.received + tally.frames + 1;
        std::string text(bytes);
        text += "\n" + sim::receivedLine(lastWords()) + "\n";
        m_terminal.write(QByteArray::fromStdString(text));
        m_loop.exec();
        const LinkStatus after = m_link.status();
        require(after.received == m_expected, "the link has received each frame once");
        require(after.dropped == before.dropped + tally.unreadable + overlong, "each unreadable line is counted once");
        require(after.state == LinkState::Up, "a frame proves that the bus is up");
        m_clock.advance(kPause);
        checkWritten();
    }

private:
    static constexpr Seconds kPause{0.1};

    static CanFrame lastWords()
    {
        CanFrame frame{.id = 0x100};
        frame.setPayload(kLastWords);
        return frame;
    }

    // The link sends whole lines, and restarts the adapter's controller at most once a second.
    void checkWritten()
    {
        m_heard += m_terminal.takeWritten();
        for (qsizetype end = m_heard.indexOf('\n'); end >= 0; end = m_heard.indexOf('\n')) {
            const QByteArray line = m_heard.left(end);
            m_heard.remove(0, end + 1);
            require(line == "can send 8001 50 BF" || line == "can off" || line == "can on" || line == "can status",
                    "the link says only its commands");
            m_restarts += line == "can off" ? 1 : 0;
        }
        require(m_restarts <= 1 + (m_clock.now() - m_opened) / FdcanusbLink::kCheckPeriod, "restarts are rare");
    }

    int m_count = 0;
    QCoreApplication m_application{m_count, nullptr};
    fakes::ManualClock m_clock;
    fakes::PseudoTerminal m_terminal;
    FdcanusbLink m_link{m_terminal.path(), m_clock};
    QEventLoop m_loop;
    std::uint64_t m_expected = 0;
    SteadyTime m_opened = m_clock.now();
    int m_restarts = 0;
    QByteArray m_heard;
};

Adapter& adapter()
{
    static Adapter one;
    return one;
}

// Corrects the checksum of each line that has one.
void repairChecksums(std::string& text)
{
    std::string repaired;
    for (std::size_t start = 0; start < text.size();) {
        const std::size_t end = std::min(text.find_first_of("\r\n", start), text.size());
        const std::string line = text.substr(start, end - start);
        const std::size_t star = line.find(" *");
        repaired += star == std::string::npos ? line : withChecksum(line.substr(0, star));
        repaired += text.substr(end, 1);
        start = end + 1;
    }
    text = repaired;
}

std::vector<std::string> recordedLines()
{
    QFile file(QStringLiteral(BORESIGHT_TEST_DATA "/moteus_golden.json"));
    require(file.open(QIODevice::ReadOnly), "the recorded lines can be read");
    const QJsonObject all = QJsonDocument::fromJson(file.readAll()).object();
    std::vector<std::string> lines;
    const QJsonArray recorded = all[QStringLiteral("serial_lines")].toArray();
    for (const auto& exchange : recorded) {
        lines.push_back(exchange.toObject()[QStringLiteral("rx_line")].toString().toStdString());
        lines.push_back(exchange.toObject()[QStringLiteral("ok_line")].toString().toStdString());
    }
    return lines;
}

}  // namespace

Grammar grammar()
{
    Grammar grammar;
    std::string conversation;
    for (const std::string& line : recordedLines()) {
        grammar.corpus.push_back(line + "\r\n");
        grammar.corpus.push_back(withChecksum(line.substr(0, line.find(" *"))) + "\n");
        conversation += line + "\r\n";
        if (conversation.size() > 200) {
            grammar.corpus.push_back(conversation);
            conversation.clear();
        }
    }
    for (const char* const line :
         {"OK", "ERR", "ERR not in BusOn state", "ERR unknown command", "ERR data invalid length",
          "lec=0 dlec=0 err=0 warn=0 busoff=0", "lec=3 dlec=0 err=1 warn=1 busoff=0",
          "lec=5 dlec=7 err=1 warn=1 busoff=1", "rcv 100 2100 ", "rcv 1FFFFFFF 00 E B F r t1234",
          "rcv 7FF 0011223344556677 e b f r f00", "rcv 1 00 R"}) {
        grammar.corpus.push_back(std::string(line) + "\r\n");
    }
    grammar.tokens = {"\r\n",
                      "\n",
                      "\r",
                      " ",
                      "  ",
                      "rcv",
                      "OK",
                      "ERR ",
                      "not in BusOn",
                      "E",
                      "e",
                      "B",
                      "b",
                      "F",
                      "f",
                      "R",
                      "r",
                      "x-1",
                      "t1234",
                      "lec=0",
                      "busoff=1",
                      "busoff=0",
                      "err=1",
                      " *00",
                      " *",
                      "*BD",
                      "100",
                      "8001",
                      "7FF",
                      "800",
                      "1FFFFFFF",
                      "20000000",
                      "FFFFFFFFF",
                      "00",
                      "50",
                      "0",
                      "+1",
                      "-1",
                      "0x1",
                      std::string("\0", 1),
                      "\xff",
                      "\x1b[2J",
                      std::string(64, 'A'),
                      std::string(128, '0'),
                      std::string(LineSplitter::kLongestLine, 'x')};
    grammar.separators = " \r\n";
    grammar.maxLength = kFdcanusbMaxInput;
    grammar.repair = repairChecksums;
    return grammar;
}

void feed(std::span<const std::uint8_t> input)
{
    const std::string_view bytes = asText(input.first(std::min(input.size(), kFdcanusbMaxInput)));
    Lines lines = checkedLines(std::string(bytes) + "\n");
    Tally tally;
    for (const std::string& line : lines.lines) {
        checkLine(line, tally);
    }
    adapter().say(bytes, tally, lines.overlong);
    if (tally.frames > 0 && tally.unreadable + lines.overlong == 0) {
        accept();
    }
}

}  // namespace boresight::fuzz
