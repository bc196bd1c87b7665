// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus/diagnostic.h"

#include "core/base/text.h"

#include <algorithm>
#include <array>
#include <utility>

namespace boresight::moteus {
namespace {

constexpr std::size_t kMaxPart = 61;        // 64 bytes minus type, channel and length
constexpr std::uint32_t kMaxPoll = 48;      // the drive limits it further, to 38 or 39
constexpr std::size_t kMaxAnswer = 262144;  // a complete `conf enumerate` has about 30 kB

bool isLineEnd(char c)
{
    return c == '\r' || c == '\n';
}

bool hasBinaryAnswer(std::string_view command)
{
    static constexpr std::array<std::string_view, 3> kBinary{"conf schema", "conf data", "tel schema"};
    return std::ranges::any_of(kBinary, [&](std::string_view start) { return command.starts_with(start); });
}

Result<> checkCommand(std::string_view command)
{
    if (command.empty() || command.size() > kMaxDiagnosticCommand) {
        return failure(ErrorCode::OutOfRange, QStringLiteral("a diagnostic command has 1 to 100 characters"));
    }
    if (std::ranges::any_of(command, isLineEnd)) {
        return failure(ErrorCode::InvalidInput, QStringLiteral("a diagnostic command is one line"));
    }
    if (hasBinaryAnswer(command)) {
        return failure(ErrorCode::NotAvailable,
                       QStringLiteral("the answer to \"%1\" is not text").arg(toQString(command)));
    }
    return {};
}

std::span<const std::uint8_t> bytesOf(std::string_view text, std::array<std::uint8_t, kMaxPart>& storage)
{
    std::ranges::copy(text, storage.begin());
    return std::span(storage).first(text.size());
}

}  // namespace

Result<> DiagnosticClient::start(std::string_view command)
{
    if (isBusy()) {
        return failure(ErrorCode::Busy, QStringLiteral("the drive's console still works on the previous command"));
    }
    if (auto checked = checkCommand(command); !checked) {
        return checked;
    }
    // While telemetry runs, the channel never becomes empty. "tel stop" ends telemetry, so it is sent without draining.
    m_state = command == "tel stop" ? State::Sending : State::Draining;
    m_awaitingReply = false;
    m_answerIsOneLine = command.starts_with("conf get ");
    m_answerMayBeBlock = command.starts_with("tel get ");
    m_blockFollows = false;
    m_unsent = std::string(command) + '\n';
    m_text.clear();
    m_lines.clear();
    m_received = 0;
    m_silences = 0;
    m_emptyAnswers = 0;
    return {};
}

std::optional<CanFrame> DiagnosticClient::nextFrame()
{
    if (!isBusy() || m_awaitingReply) {
        return std::nullopt;
    }
    if (m_state == State::Sending) {
        return sendPart();
    }
    m_awaitingReply = true;
    return poll();
}

CanFrame DiagnosticClient::frame(const Subframe& subframe, bool replyWanted) const
{
    SubframeWriter writer;
    writer.append(subframe);
    return makeFrame({.prefix = m_settings.prefix,
                      .replyWanted = replyWanted,
                      .source = m_settings.source,
                      .destination = m_settings.destination},
                     writer.bytes());
}

CanFrame DiagnosticClient::sendPart()
{
    const std::string part = m_unsent.substr(0, kMaxPart);
    m_unsent.erase(0, part.size());
    if (m_unsent.empty()) {
        m_state = State::Polling;
    }
    std::array<std::uint8_t, kMaxPart> storage{};
    return frame(TunnelToDevice{kDiagnosticChannel, bytesOf(part, storage)}, false);
}

CanFrame DiagnosticClient::poll() const
{
    if (m_flowControl) {
        return frame(TunnelPollFlow{kDiagnosticChannel, m_lastPacket, kMaxPoll}, true);
    }
    return frame(TunnelPoll{kDiagnosticChannel, kMaxPoll}, true);
}

void DiagnosticClient::handleReply(const Reply& reply)
{
    if (!m_awaitingReply || reply.source != m_settings.destination || reply.destination != m_settings.source ||
        reply.prefix != m_settings.prefix) {
        return;
    }
    const auto found = std::ranges::find(reply.texts, kDiagnosticChannel, &TunnelText::channel);
    if (found != reply.texts.end()) {
        m_awaitingReply = false;
        m_silences = 0;
        handleText(isNews(*found) ? found->text : std::string());
    } else if (m_flowControl && reply.values.empty() && reply.errors.empty() && reply.texts.empty()) {
        m_awaitingReply = false;  // old firmware answers 0x44 with an empty frame, so the next poll is a 0x42
        m_flowControl = false;
    }
}

// With flow control, a repeated number is a late copy of a packet that was read already. This does not apply while
// draining, because the drive may have restarted and count from zero.
bool DiagnosticClient::isNews(const TunnelText& text)
{
    if (!text.number) {
        return !m_flowControl;
    }
    const bool news = m_flowControl && (*text.number != m_lastPacket || m_state == State::Draining);
    m_lastPacket = *text.number;
    return news;
}

void DiagnosticClient::handleText(const std::string& text)
{
    m_received += text.size();
    m_emptyAnswers = text.empty() ? m_emptyAnswers + 1 : 0;
    if (m_received > kMaxAnswer) {
        finish(
            failure(ErrorCode::Protocol, Text::tr("The console of the drive sends without end. Send \"tel stop\".")));
    } else if (m_state == State::Draining && text.empty()) {
        m_state = State::Sending;
        m_received = 0;
    } else if (m_emptyAnswers > m_settings.maxEmptyAnswers) {
        finish(failure(ErrorCode::NoAnswer, Text::tr("The console of the drive did not answer the command.")));
    } else if (m_state == State::Polling) {
        m_text += text;
        while (isBusy() && (m_blockFollows ? takeBlock() : takeLine())) {
        }
    }
}

bool DiagnosticClient::takeLine()
{
    const auto end = m_text.find('\n');
    if (end == std::string::npos) {
        return false;
    }
    std::string line = m_text.substr(0, end);
    m_text.erase(0, end + 1);
    std::erase(line, '\r');
    handleLine(line);
    return true;
}

// A block: its length in four bytes, the lowest first, then its bytes.
bool DiagnosticClient::takeBlock()
{
    constexpr std::size_t kHead = 4;
    std::size_t length = 0;
    for (std::size_t i = std::min(kHead, m_text.size()); i-- > 0;) {
        length = length << 8 | static_cast<std::uint8_t>(m_text[i]);
    }
    if (m_text.size() < kHead || m_text.size() - kHead < length) {
        return false;
    }
    finish(Lines{m_text.substr(kHead, length)});
    return true;
}

void DiagnosticClient::handleLine(const std::string& line)
{
    if (line.empty()) {
        return;
    }
    if (line.starts_with("ERR")) {
        finish(failure(ErrorCode::Refused, Text::tr("The drive answers: %1").arg(toQString(line))));
    } else if (m_answerMayBeBlock && line.starts_with("emit ")) {
        m_blockFollows = true;
    } else if (m_answerIsOneLine) {
        finish(Lines{line});
    } else if (line == "OK") {
        finish(std::exchange(m_lines, {}));
    } else {
        m_lines.push_back(line);
    }
}

void DiagnosticClient::handleSilence()
{
    if (!m_awaitingReply) {
        return;
    }
    m_awaitingReply = false;
    ++m_silences;
    if (m_silences >= m_settings.maxSilences) {
        finish(failure(ErrorCode::NoAnswer,
                       Text::tr("Drive %1 does not answer on its console.").arg(m_settings.destination)));
    } else if (!m_flowControl && m_state == State::Polling) {
        finish(failure(ErrorCode::NoAnswer, Text::tr("Part of the answer was lost. Repeat the command.")));
    }
}

void DiagnosticClient::finish(Result<Lines> answer)
{
    m_answer = std::move(answer);
    m_state = State::Finished;
    m_awaitingReply = false;
}

Result<DiagnosticClient::Lines> DiagnosticClient::takeAnswer()
{
    if (m_state != State::Finished) {
        return failure(ErrorCode::NoAnswer, QStringLiteral("the drive's console has no answer ready"));
    }
    m_state = State::Idle;
    return std::exchange(m_answer, Lines{});
}

}  // namespace boresight::moteus
