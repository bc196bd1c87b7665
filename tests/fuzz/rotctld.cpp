// SPDX-License-Identifier: GPL-3.0-or-later
// The data of a client: gives any bytes to a rotctld Session in pieces of any size, with a rotator that checks every
// request.
#include "core/rotctld/session.h"
#include "tests/fakes/manual_clock.h"
#include "tests/fuzz/harness.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <sstream>
#include <vector>

namespace boresight::fuzz {
namespace {

using namespace boresight::rotctld;

constexpr std::size_t kRotctldMaxInput = 600;
constexpr std::size_t kMaxReply = 4096;    // the longest are the help text and the capabilities, below 2000 bytes
constexpr std::size_t kShownCommand = 40;  // length of a command in ClientHabits::lastCommand()
constexpr double kFloatRounding = 1.0 / (1 << 23);

bool isPrintable(unsigned char byte)
{
    return byte >= ' ' && byte < 0x7f;
}

bool isPrintableOrBlank(unsigned char byte)
{
    return isPrintable(byte) || byte == '\n' || byte == '\r' || byte == '\t';
}

// Compares every request of a session with the client's own words, as read by the C library.
class DoubtingRotator final : public Rotator
{
public:
    [[nodiscard]] std::string info() const override { return "doubting rotator"; }
    [[nodiscard]] Limits limits() const override { return {0_deg, 360_deg, 0_deg, 90_deg}; }
    [[nodiscard]] Result<SkyPointing> position(const Client&) override { return SkyPointing{123.45_deg, 67.89_deg}; }
    [[nodiscard]] bool follows(const Client& /*client*/) const override { return true; }
    [[nodiscard]] MotionFlags motion() const override { return {.movingLeft = true, .limitUp = true}; }

    Result<QString> pointTo(const Client&, const PointRequest& request) override
    {
        require(request.azimuth.isFinite() && request.elevation.isFinite(), "a requested position is finite");
        const double elevation = request.elevation.degrees();
        require(elevation > -90.0001 && elevation < 180.0001, "a requested elevation is within -90°…180°");
        requireNumber(1, request.azimuth.degrees());
        requireNumber(2, elevation);
        return outcome().map([] { return QString(); });
    }
    Result<> move(const Client&, MoveDirection, int speed) override
    {
        requireInteger(2, speed);
        return outcome();
    }
    Result<QString> moveAt(const Client&, MoveDirection, AngularRate) override
    {
        require(false, "rotctld has no word for a rate");
        return QString();
    }
    Result<> stop(const Client&) override { return outcome(); }
    Result<> park(const Client&) override { return outcome(); }
    Result<> reset(const Client&, int kind) override
    {
        requireInteger(1, kind);
        return outcome();
    }
    [[nodiscard]] int speedLevel() const override { return 2; }
    Result<> setSpeedLevel(const Client&, int level) override
    {
        requireInteger(2, level);
        return outcome();
    }
    void clientConnected(const Client&) override {}
    void clientGone(const Client&, const QString&) override {}
    void clientRemark(const Client&, const QString& text) override
    {
        require(text.toUtf8().size() < 512, "a remark fits a line of the log");
        require(std::ranges::all_of(text, [](QChar one) { return one.isPrint(); }), "a remark is printable");
    }

    const Session* session = nullptr;
    bool refuses = false;
    bool shownAsSent = true;  // ClientHabits::lastCommand() replaces unprintable characters

private:
    [[nodiscard]] Result<> outcome() const
    {
        return refuses ? Result<>(failure(ErrorCode::Refused, QStringLiteral("the operator has the mount")))
                       : Result<>();
    }

    // The word with this number in the client's command. Empty if the session shows the command truncated or changed.
    [[nodiscard]] std::optional<std::string> word(int index) const
    {
        const std::string shown = session->habits().lastCommand().toStdString();
        if (!shownAsSent || shown.size() >= kShownCommand) {
            return std::nullopt;
        }
        std::istringstream words(shown);
        std::string word;
        for (int i = 0; i <= index; ++i) {
            word.clear();
            words >> word;
        }
        return word;
    }

    void requireNumber(int index, double value) const
    {
        std::string text = word(index).value_or(std::to_string(value));
        std::ranges::replace(text, ',', '.');
        char* end = nullptr;
        const double meant = std::strtod(text.c_str(), &end);
        require(end != text.c_str() && std::isfinite(meant), "what moves the mount has a finite number");
        require(std::abs(meant - value) <= std::abs(meant) * kFloatRounding + 1e-5,
                "what moves the mount is the number that was written");
    }

    void requireInteger(int index, int value) const
    {
        const std::string text = word(index).value_or(std::to_string(value));
        char* end = nullptr;
        const long meant = std::strtol(text.c_str(), &end, 10);
        require(end != text.c_str() && meant == value, "what moves the mount is the whole number that was written");
    }
};

bool isCode(std::string_view line)
{
    return line.starts_with("RPRT 0") || line.starts_with("RPRT -");
}

void checkReply(std::string_view reply)
{
    require(reply.size() <= kMaxReply, "a reply has a limited length");
    require(reply.ends_with('\n'), "a reply ends with a line end");
    int codes = 0;
    for (std::size_t start = 0; start < reply.size();) {
        const std::size_t end = reply.find('\n', start) + 1;
        require(codes == 0 || !isCode(reply.substr(start)), "a command has one code");
        codes += isCode(reply.substr(start)) ? 1 : 0;
        start = end;
    }
}

// A default reply consists of numbers, names and codes. A client would take "inf" for a number.
void checkNumbers(const Session& session, std::string_view reply)
{
    const std::string command = session.habits().lastCommand().toStdString();
    const bool echoes = reply.find(": ") != std::string_view::npos || reply.find(":|") != std::string_view::npos;
    if (!echoes && std::string_view("LlDdEeBAa").find(command.front()) != std::string_view::npos) {
        require(reply.find("inf") == std::string_view::npos && reply.find("nan") == std::string_view::npos,
                "a computed number is finite");
    }
}

struct Conversation
{
    fakes::ManualClock clock;
    DoubtingRotator rotator;
    Session session{{.id = 7, .address = "127.0.0.1:5"}, rotator, clock, DumpStateForm::OldAndNew};
    int answered = 0;
    bool refused = false;

    // One step. Returns false when there is nothing more to do.
    bool step()
    {
        const std::uint64_t oddBefore = session.habits().oddCommands();
        const bool wasPaused = session.paused();
        std::string reply;
        const bool more = session.step(reply);
        const bool odd = session.habits().oddCommands() > oddBefore;
        if (!session.ending().isEmpty() || !more) {
            require(reply.empty(), "who is hung up on gets no half reply");
            return more;
        }
        if (reply.empty()) {
            require(odd || session.paused(), "each command has an answer");
            refused = refused || odd;
            return true;
        }
        checkReply(reply);
        if (!wasPaused) {
            checkNumbers(session, reply);
        }
        ++answered;
        refused = refused || odd;
        return true;
    }

    void drain()
    {
        while (step()) {
        }
    }

    void say(std::string_view bytes)
    {
        session.receive(bytes);
        drain();
    }
};

// After any invalid data a client that is still connected, and not in the middle of a command, is served.
void checkStillServed(Conversation& talk)
{
    talk.say("\n");
    if (!talk.session.ending().isEmpty() || talk.session.midCommand() || talk.session.paused()) {
        return;
    }
    talk.session.receive("p\n");
    std::string reply;
    while (talk.session.step(reply)) {
    }
    require(reply == "123.45\n67.89\n", "a client is served after any nonsense");
}

std::vector<std::string> recorded()
{
    QFile file(QStringLiteral(BORESIGHT_TEST_DATA "/rotctld_cases.json"));
    require(file.open(QIODevice::ReadOnly), "the recorded exchanges can be read");
    std::vector<std::string> inputs;
    const QJsonArray cases = QJsonDocument::fromJson(file.readAll()).object()[QStringLiteral("cases")].toArray();
    for (const auto& exchange : cases) {
        std::string text;
        const QJsonArray steps = exchange.toObject()[QStringLiteral("steps")].toArray();
        for (const auto& step : steps) {
            const QJsonArray chunks = step.toObject()[QStringLiteral("send")].toArray();
            for (const auto& chunk : chunks) {
                text += chunk.toString().toLatin1().toStdString();
            }
        }
        if (!text.empty() && text.size() < kRotctldMaxInput) {
            inputs.push_back(text);
        }
    }
    return inputs;
}

}  // namespace

// The first byte of an input selects how the rest is cut into pieces, and whether the rotator refuses.
Grammar grammar()
{
    Grammar grammar;
    for (const std::string& text : recorded()) {
        for (const char cut : {'\0', '\x01', '\x05', '\x83'}) {
            grammar.corpus.push_back(cut + text);
        }
    }
    grammar.tokens = {"\n",
                      "\r\n",
                      "\r",
                      " ",
                      "\t",
                      "+",
                      ";",
                      "|",
                      "\\",
                      "#",
                      "?",
                      "P 10 20\n",
                      "p\n",
                      "S\n",
                      "K\n",
                      "M 8 50\n",
                      "M UP -1\n",
                      "R 1\n",
                      "\\pause 1\n",
                      "q\n",
                      "+\\set_pos 1 2\n",
                      "+p\n",
                      ";p\n",
                      "E 0 1e308 0\n",
                      "D 0 0 1e308 1\n",
                      "L 1 2 6\n",
                      "JO31kh",
                      "SPEED",
                      "min_az",
                      "GET / HTTP/1.1\r\n",
                      "AZ10 EL20\r",
                      "W123 045\r",
                      "C2\r",
                      std::string("\0", 1),
                      "\x80",
                      "\xff\xfb",
                      "\x1b[2J"};
    for (const CommandSpec& spec : commandTable()) {
        grammar.tokens.push_back(std::string(1, static_cast<char>(spec.letter)));
        grammar.tokens.push_back("\\" + std::string(spec.name) + " ");
    }
    grammar.separators = " \n\r\t+;|\\";
    grammar.maxLength = kRotctldMaxInput;
    return grammar;
}

void feed(std::span<const std::uint8_t> input)
{
    if (input.empty()) {
        return;
    }
    Conversation talk;
    talk.rotator.session = &talk.session;
    talk.rotator.refuses = (input[0] & 0x80) != 0;
    talk.rotator.shownAsSent = std::ranges::all_of(input.subspan(1), isPrintableOrBlank);
    const std::size_t piece = (input[0] & 0x7f) == 0 ? input.size() : input[0] & 0x7f;
    for (std::string_view rest = asText(input.subspan(1)); !rest.empty() && talk.session.ending().isEmpty();
         rest.remove_prefix(std::min(piece, rest.size()))) {
        talk.say(rest.substr(0, piece));
        if (talk.session.paused()) {
            talk.clock.advance(std::chrono::seconds(2));
            talk.drain();
        }
    }
    if (talk.answered > 0 && !talk.refused && !talk.session.dropped()) {
        accept();
    }
    if (talk.session.ending().isEmpty()) {
        checkStillServed(talk);
    }
    talk.session.endOfInput();
    talk.drain();
    require(!talk.session.ending().isEmpty(), "a conversation ends with its input");
}

}  // namespace boresight::fuzz
