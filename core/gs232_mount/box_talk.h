// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/gs232/box_reply.h"
#include "core/rotator_box/rotator_talk.h"
#include "core/serial/line_splitter.h"

#include <optional>
#include <string>
#include <string_view>

// The conversation with a GS-232 box: decides when to send what, and which answers count. Such a box carries out one
// command at a time. So the next command waits for 50 ms after each command, and for an answer. The position is asked
// at most four times a second, and a target is sent at most twice a second. A stop is sent at once.
//
// The port may lead to a radio, which would read our lines as its own commands. So only questions are sent before the
// port has answered like such a box. A port that answers three questions with other data is foreign, and nothing more
// is sent. A byte of noise, or the greeting of a starting box, does not make it foreign. Pure: time and bytes are
// passed in.
namespace boresight::gs232 {

// The question to the box.
enum class Question
{
    Both,
    Azimuth  // an azimuth-only box answers this one too
};

using Proof = RotatorTalk::Proof;

class BoxTalk final : public RotatorTalk
{
public:
    static constexpr std::chrono::milliseconds kPause{50};           // after each command
    static constexpr std::chrono::milliseconds kAnswerTime{400};     // in addition to the time of the bytes on the line
    static constexpr std::chrono::milliseconds kBetweenAsks{250};    // from one question to the next
    static constexpr std::chrono::milliseconds kBetweenGoes{500};    // from one target to the next
    static constexpr std::chrono::milliseconds kBetweenTries{1000};  // between questions while nothing answers
    static constexpr std::chrono::seconds kProbeTime{3};             // after the first meaningless bytes
    static constexpr int kProbeQuestions = 3;                        // questions with such bytes as their answer
    static constexpr std::chrono::seconds kNoise{10};                // a longer gap: the bytes before it were noise

    // `baud`: bits per second of the line.
    BoxTalk(Question question, int baud) : m_question(question), m_baud(baud) {}

    void restart() override;
    void take(std::string_view bytes, SteadyTime now) override;
    [[nodiscard]] std::optional<Places> takePlaces() override;

    // Replaces a target that was not sent yet.
    void go(std::string command) { m_go = std::move(command); }
    void stop() override;
    [[nodiscard]] std::string send(SteadyTime now) override;

    [[nodiscard]] Result<> mayType(std::string_view line) const override;
    [[nodiscard]] std::string type(std::string_view line, SteadyTime::duration pause, SteadyTime now) override;
    [[nodiscard]] bool takesLines() const override { return true; }

    [[nodiscard]] Proof proof() const override { return m_proof; }
    [[nodiscard]] Dialect dialect() const { return m_dialect; }
    [[nodiscard]] bool echoes() const { return m_echoes; }    // our commands came back since the last answer
    [[nodiscard]] bool refuses() const { return m_refuses; }  // the answer was ?> since the last good answer
    // It answered like an ESP32 relay controller, which needs another conversation.
    [[nodiscard]] bool speaksWords() const { return m_speaksWords; }
    [[nodiscard]] const Counts& counts() const override { return m_counts; }
    [[nodiscard]] const std::string& strange() const override { return m_strange.text; }

private:
    void takePiece(std::string_view text, SteadyTime now);
    void takeLine(std::string_view line, SteadyTime now);
    void takeStrange(std::string_view bytes, SteadyTime now);
    void judge(SteadyTime now);
    [[nodiscard]] bool mustWait(SteadyTime now) const;
    [[nodiscard]] bool isWhole(const Position& position) const;
    [[nodiscard]] SteadyTime::duration timeOf(std::size_t bytes) const;  // time of so many bytes on the line
    [[nodiscard]] std::string say(std::string command, SteadyTime now);

    Question m_question;
    int m_baud;
    LineSplitter m_splitter;
    Proof m_proof = Proof::Unknown;
    Dialect m_dialect = Dialect::A;
    std::optional<Places> m_places;
    std::string m_go;
    bool m_stop = false;
    bool m_echoes = false;
    bool m_refuses = false;
    bool m_speaksWords = false;
    struct
    {
        std::string text;
        std::optional<SteadyTime> first;  // first strange bytes since the last answer or noise
        SteadyTime last{};
        int questions = 0;        // questions that were followed by strange bytes
        bool sinceAsked = false;  // already counted for the last question
    } m_strange;
    struct
    {
        SteadyTime free{};                // end of the pause after the last command
        std::optional<SteadyTime> asked;  // a question without an answer yet
        std::optional<SteadyTime> lastAsk;
        std::optional<SteadyTime> lastGo;
    } m_times;
    Counts m_counts;
};

}  // namespace boresight::gs232
