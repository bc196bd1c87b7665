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

// The text console of one drive, tunnelled through CAN frames. A state machine for one command at a time, without clock
// and bus. Its owner sends the frame from nextFrame(). If the frame wants a reply, the owner reports the reply, or the
// silence after its own time-out (20 to 50 ms). Then it asks for the next frame, until isFinished().
//
// Before a command, old text in the channel is read and dropped. The first poll also detects whether the drive has flow
// control (0x44/0x43, lost replies are repeated) or not (0x42, a lost reply loses text, and the command fails).
namespace boresight::moteus {

inline constexpr std::size_t kMaxDiagnosticCommand = 100;  // characters; the limit of the drive
inline constexpr std::uint32_t kDiagnosticChannel = 1;
// Our source id for the console. Its replies must not be confused with replies to the motion commands of kHostId. The
// maker's tools use ids from 0x7e downwards.
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
        int maxEmptyAnswers = 500;  // empty answers in a row: `conf write` takes some time
    };

    // Without line ends and without the final OK. For `tel get` in the binary format: one "line" with the bytes of the
    // data.
    using Lines = std::vector<std::string>;

    explicit DiagnosticClient(Settings settings) : m_settings(settings) {}

    // Refuses a second command while one runs, an empty or too long command, line ends, and commands with binary
    // answers (`conf schema`, `conf data`, `tel schema`).
    [[nodiscard]] Result<> start(std::string_view command);

    // Empty if there is nothing to send: idle, finished, or waiting for a reply.
    [[nodiscard]] std::optional<CanFrame> nextFrame();
    // Replies of other drives and channels are ignored.
    void handleReply(const Reply& reply);
    void handleSilence();

    [[nodiscard]] bool isBusy() const { return m_state != State::Idle && m_state != State::Finished; }
    [[nodiscard]] bool isFinished() const { return m_state == State::Finished; }
    // The lines of the answer, or an error: the `ERR …` of the drive (Refused), or why there is no answer. The client
    // is then idle.
    [[nodiscard]] Result<Lines> takeAnswer();

private:
    enum class State
    {
        Idle,
        Draining,  // reads old text until the channel is empty
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
    bool m_flowControl = true;  // until the drive shows that it has none
    std::uint8_t m_lastPacket = 0;
    bool m_answerIsOneLine = false;   // `conf get` sends its value without OK
    bool m_answerMayBeBlock = false;  // `tel get` sends lines and OK, or "emit" and a block of bytes
    bool m_blockFollows = false;
    std::string m_unsent;
    std::string m_text;  // received, but its line or block is not complete yet
    Lines m_lines;
    std::size_t m_received = 0;
    int m_silences = 0;
    int m_emptyAnswers = 0;
    Result<Lines> m_answer;
};

}  // namespace boresight::moteus
