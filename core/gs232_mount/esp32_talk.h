// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/gs232/esp32_reply.h"
#include "core/gs232_mount/offset_question.h"
#include "core/rotator_box/rotator_talk.h"
#include "core/serial/line_splitter.h"
#include "core/units/sky.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>

// The conversation with the ESP32 relay controller. Before the box has answered with its version, only that question is
// sent. The next command waits for the answers to the last one.
//
// The box has no stop: a relay that was switched off is switched on again while the axis is away from its target. So a
// stop overwrites both targets with the reported position. The elevation that the box reports is the mean of its last
// five readings, and each question adds one. So five questions follow a stop, and their last answer becomes the target.
// The box fills its readings with zeros when it starts. So the first answers are not believed. Pure: time and bytes are
// passed in.
namespace boresight::gs232 {

class Esp32Talk final : public RotatorTalk
{
public:
    static constexpr std::chrono::milliseconds kAnswerTime{400};
    static constexpr std::chrono::milliseconds kBetweenAsks{250};    // from one question to the next
    static constexpr std::chrono::milliseconds kBetweenGoes{500};    // from one target of an axis to the next
    static constexpr std::chrono::milliseconds kBetweenTries{1000};  // between questions before the first answer
    static constexpr std::chrono::seconds kReportsStay{3};           // its reports come each 0.5 s
    static constexpr int kReadings = 5;                              // whose mean the box reports
    static constexpr int kProbeQuestions = 3;                        // questions with other text as their answer

    // `middle`: of the travel of the azimuth. The box reports a heading, which is counted nearest to this angle.
    explicit Esp32Talk(Angle middle) : m_middle(middle) {}

    void restart() override;
    void take(std::string_view bytes, SteadyTime now) override;
    [[nodiscard]] std::optional<Places> takePlaces() override;

    // Replaces a target of this axis that was not sent yet.
    void go(Axis axis, Angle angle);
    void stop() override;
    [[nodiscard]] std::string send(SteadyTime now) override;

    [[nodiscard]] Result<> mayType(std::string_view line) const override;
    [[nodiscard]] std::string type(std::string_view line, SteadyTime::duration pause, SteadyTime now) override;
    [[nodiscard]] bool takesLines() const override { return true; }

    [[nodiscard]] Proof proof() const override { return m_proof; }
    [[nodiscard]] const Counts& counts() const override { return m_counts; }
    [[nodiscard]] const std::string& strange() const override { return m_strange.text; }
    // How well its sensor is calibrated. Empty: not reported, or not any more.
    [[nodiscard]] std::optional<esp32::Digits> digits(SteadyTime now) const;
    // Of its sensor. Empty: not reported since the line was opened.
    [[nodiscard]] const std::optional<esp32::Offsets>& offsets() const { return m_offsets.known(); }

private:
    void takeLine(std::string_view line, SteadyTime now);
    void takePlace(const esp32::Place& place);
    void takeStrange(std::string_view line);
    void answered();
    [[nodiscard]] std::string say(std::string bytes, SteadyTime now, int answers = 1);
    [[nodiscard]] bool mustWait(SteadyTime now) const;
    [[nodiscard]] std::string stopAt(SteadyTime now);
    [[nodiscard]] std::string nextTarget(SteadyTime now);
    [[nodiscard]] std::string ask(std::string_view question, std::chrono::milliseconds pause, SteadyTime now);
    [[nodiscard]] bool wantsReports(SteadyTime now);

    struct Target
    {
        std::optional<Angle> next;
        std::optional<SteadyTime> sent;
    };

    Angle m_middle;
    LineSplitter m_splitter;
    Proof m_proof = Proof::Unknown;
    std::array<Target, 2> m_targets;
    std::optional<esp32::Place> m_known;
    std::optional<Places> m_places;
    int m_readings = 0;  // since the start of the box, at most kReadings
    int m_untilPin = 0;  // answers until the position becomes the target
    bool m_stop = false;
    struct
    {
        std::string text;
        int questions = 0;        // questions that were followed by strange text
        bool sinceAsked = false;  // already counted for the last question
    } m_strange;
    struct
    {
        int open = 0;  // answers that are still to come
        SteadyTime said{};
        SteadyTime free{};  // end of the pause after a typed line
        std::optional<SteadyTime> asked;
        std::optional<SteadyTime> switched;  // when its reports were last switched
    } m_times;
    struct
    {
        esp32::Digits value;
        std::optional<SteadyTime> when;
    } m_digits;
    OffsetQuestion m_offsets;
    Counts m_counts;
};

}  // namespace boresight::gs232
