// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/gs232/box_reply.h"
#include "core/rotator_box/rotator_talk.h"
#include "core/serial/line_splitter.h"

#include <optional>
#include <string>
#include <string_view>

// The conversation with a GS-232 box: what is sent when, and what of the answers counts. Such a box works at one
// command at a time, so the next one waits: 50 ms after each, and for an answer. It is asked where it stands four times
// a second at most, and sent somewhere twice a second at most. A stop waits for nothing.
//
// Behind the port may be a radio, which would take our lines for its commands. So only questions are sent before the
// port has answered as such a box does. A port that says other things to three questions is foreign, and nothing more
// is sent. A byte of noise, or the greeting of a box that starts, is not. Pure: time and bytes are passed in.
namespace boresight::gs232 {

// What the box is asked for.
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
    static constexpr std::chrono::milliseconds kAnswerTime{400};     // beside the time of the bytes on the line
    static constexpr std::chrono::milliseconds kBetweenAsks{250};    // from one question to the next
    static constexpr std::chrono::milliseconds kBetweenGoes{500};    // from one target to the next
    static constexpr std::chrono::milliseconds kBetweenTries{1000};  // of questions while nothing answers
    static constexpr std::chrono::seconds kProbeTime{3};             // from the first bytes that mean nothing
    static constexpr int kProbeQuestions = 3;                        // after which such bytes came
    static constexpr std::chrono::seconds kNoise{10};                // bytes so far apart have nothing to do with us

    // `baud` as bits per second of the line.
    BoxTalk(Question question, int baud) : m_question(question), m_baud(baud) {}

    void restart() override;
    void take(std::string_view bytes, SteadyTime now) override;
    [[nodiscard]] std::optional<Places> takePlaces() override;

    // Replaces the target that was not sent yet.
    void go(std::string command) { m_go = std::move(command); }
    void stop() override;
    [[nodiscard]] std::string send(SteadyTime now) override;

    [[nodiscard]] Proof proof() const override { return m_proof; }
    [[nodiscard]] Dialect dialect() const { return m_dialect; }
    [[nodiscard]] bool echoes() const { return m_echoes; }    // our commands came back since the last answer
    [[nodiscard]] bool refuses() const { return m_refuses; }  // it said ?> since the last answer
    [[nodiscard]] const Counts& counts() const override { return m_counts; }
    [[nodiscard]] const std::string& strange() const override { return m_strange.text; }

private:
    void takePiece(std::string_view text, SteadyTime now);
    void takeLine(std::string_view line, SteadyTime now);
    void takeStrange(std::string_view bytes, SteadyTime now);
    void judge(SteadyTime now);
    [[nodiscard]] bool isWhole(const Position& position) const;
    [[nodiscard]] SteadyTime::duration timeOf(std::size_t bytes) const;  // on the line
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
    struct
    {
        std::string text;
        std::optional<SteadyTime> first;  // since it last answered, or since it was noise
        SteadyTime last{};
        int questions = 0;        // after which something strange came
        bool sinceAsked = false;  // counted for the last question
    } m_strange;
    struct
    {
        SteadyTime free{};                // of the pause after the last command
        std::optional<SteadyTime> asked;  // and not answered yet
        std::optional<SteadyTime> lastAsk;
        std::optional<SteadyTime> lastGo;
    } m_times;
    Counts m_counts;
};

}  // namespace boresight::gs232
