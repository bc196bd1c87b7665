// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/moteus/arbitration.h"
#include "core/moteus/codec.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// The text console of one drive, tunnelled through CAN frames: a state machine for one command at a time. It has no
// clock and no bus. Its owner sends what nextFrame() gives; for a frame that wants a reply it then reports the reply
// or, after its own time-out (20 to 50 ms), the silence; and asks for the next frame until finished().
//
// Before a command, old text in the channel is read and dropped; that first poll also finds out whether the drive has
// flow control (0x44/0x43, lost replies are repeated) or not (0x42, a lost reply loses text and fails the command).
namespace boresight::moteus {

inline constexpr std::size_t kMaxDiagnosticCommand = 100;  // characters, the drive's own limit
inline constexpr std::uint32_t kDiagnosticChannel = 1;
// Our own source number for the console: its replies must not be confused with those to the motion commands of
// kHostId. The maker's tools count down from 0x7e.
inline constexpr std::uint8_t kDiagnosticHostId = 0x10;

class DiagnosticClient
{
public:
    struct Settings
    {
        std::uint8_t destination = 1;
        std::uint16_t prefix = 0;
        std::uint8_t source = kDiagnosticHostId;
        int maxSilences = 5;        // unanswered frames in a row before giving up
        int maxEmptyAnswers = 500;  // empty answers in a row: `conf write` takes its time
    };

    // Without line ends and without the final OK. Of `tel get` in the binary format: one "line", the bytes of the data.
    using Lines = std::vector<std::string>;

    explicit DiagnosticClient(Settings settings) : m_settings(settings) {}

    // Refuses a second command, an empty or too long one, line ends, and the commands with binary answers
    // (`conf schema`, `conf data`, `tel schema`).
    [[nodiscard]] Result<> start(std::string_view command);

    // Empty when there is nothing to send: idle, finished, or a reply is awaited.
    [[nodiscard]] std::optional<CanFrame> nextFrame();
    // Replies of other drives and channels are ignored.
    void handleReply(const Reply& reply);
    void handleSilence();

    [[nodiscard]] bool isBusy() const { return m_state != State::Idle && m_state != State::Finished; }
    [[nodiscard]] bool isFinished() const { return m_state == State::Finished; }
    // The answer: its lines, or the drive's `ERR …` (Refused), or why there is none. Afterwards the client is idle.
    [[nodiscard]] Result<Lines> takeAnswer();

private:
    enum class State
    {
        Idle,
        Draining,  // reading old text until the channel is empty
        Sending,
        Polling,
        Finished,
    };

    [[nodiscard]] CanFrame frame(const Subframe& subframe, bool replyWanted) const;
    [[nodiscard]] CanFrame sendPart();
    [[nodiscard]] CanFrame poll() const;
    [[nodiscard]] bool isNews(const TunnelText& text);
    void handleText(const std::string& text);
    [[nodiscard]] bool takeLine();
    [[nodiscard]] bool takeBlock();
    void handleLine(const std::string& line);
    void finish(Result<Lines> answer);

    Settings m_settings;
    State m_state = State::Idle;
    bool m_awaitingReply = false;
    bool m_flowControl = true;  // until the drive shows otherwise
    std::uint8_t m_lastPacket = 0;
    bool m_answerIsOneLine = false;   // `conf get` sends its value and no OK
    bool m_answerMayBeBlock = false;  // `tel get` sends lines and OK, or "emit" and a block of bytes
    bool m_blockFollows = false;
    std::string m_unsent;
    std::string m_text;  // received, up to the next line end or the end of the block
    Lines m_lines;
    std::size_t m_received = 0;
    int m_silences = 0;
    int m_emptyAnswers = 0;
    Result<Lines> m_answer;
};

}  // namespace boresight::moteus
