// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/rotator_box/rotator_talk.h"
#include "core/rotctl/reply_reader.h"
#include "core/serial/line_splitter.h"

#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

// The conversation with a rotctld. rotctld carries out one command at a time. So the next command waits for the answer,
// however long that takes: a command sent earlier would wait in the queue of rotctld, and a stop would wait behind it.
// The position is asked at most four times a second, and a target is sent at most twice a second. A stop is sent at
// once. A refused stop is repeated, and until then only questions are sent. A rotator without a stop command is sent to
// where it is.
//
// First the limits are asked for. The answer shows whether the server is a rotctld. A server that does not know the
// extended form is asked in the plain form, and then only for the position. Each attempt uses a new connection, because
// late answers belong to the old one. The form of the first answer is kept. Pure: time and bytes are passed in.
namespace boresight::rotctl {

class RotctldTalk final : public RotatorTalk
{
public:
    static constexpr std::chrono::milliseconds kBetweenAsks{250};    // from one question to the next
    static constexpr std::chrono::milliseconds kBetweenGoes{500};    // from one target to the next
    static constexpr std::chrono::milliseconds kBetweenStops{500};   // after a refused stop
    static constexpr std::chrono::milliseconds kBetweenTries{1000};  // between questions before the first answer
    static constexpr std::chrono::seconds kProbeTime{4};             // for an answer of a server that is not known yet
    static constexpr std::chrono::seconds kHangs{5};                 // without an answer: a new connection is made

    void restart() override;
    void take(std::string_view bytes, SteadyTime now) override;
    [[nodiscard]] std::optional<Places> takePlaces() override;

    // Replaces a target that was not sent yet. False if no rotator can have this position.
    [[nodiscard]] bool go(const AxisPosition& target);
    void stop() override;
    [[nodiscard]] bool makesHomeRuns() const override { return true; }
    void home() override;
    [[nodiscard]] std::optional<Result<>> takeHomeAnswer() override
    {
        return std::exchange(m_home.answer, std::nullopt);
    }
    // The target that stops a rotator without a stop command. Empty if its position is not known.
    void standsAt(const std::optional<AxisPosition>& place) { m_stop.place = place; }
    [[nodiscard]] std::string send(SteadyTime now) override;

    [[nodiscard]] Proof proof() const override { return m_proof; }
    [[nodiscard]] const Counts& counts() const override { return m_counts; }
    [[nodiscard]] const std::string& strange() const override { return m_strange; }
    // Empty if not known, or if this server does not report it.
    [[nodiscard]] const std::optional<RotatorState>& state() const { return m_state; }
    [[nodiscard]] bool wantsAnotherLine() const override { return m_wantsLine; }
    // The error of the last question for the position. 0 if it was answered.
    [[nodiscard]] int positionError() const { return m_positionError; }
    // The number of targets refused in a row, and the last error.
    [[nodiscard]] int refusals() const { return m_order.refusals; }
    [[nodiscard]] int refusal() const { return m_order.error; }

private:
    // The attempts with a server that is not known yet, in this order.
    enum class Probe
    {
        ExtendedState,
        PlainState,
        PlainPosition
    };
    struct Pending
    {
        Question question;
        SteadyTime sent;
        ReplyReader reader;
        bool stops = false;
        bool spoiled = false;  // one line was strange, so the rest is ignored
    };

    [[nodiscard]] Form form() const;
    void nextProbe();
    void takeLine(std::string_view line, SteadyTime now);
    void takeStrange(std::string_view line);
    void finish(const Pending& pending, const Reply& reply, SteadyTime now);
    void finishOrder(bool stops, int code, SteadyTime now);
    void leaveOut(SteadyTime now);
    [[nodiscard]] bool stopWaits() const;
    [[nodiscard]] std::string probe(SteadyTime now);
    [[nodiscard]] std::string sendStop(SteadyTime now);
    [[nodiscard]] std::string say(Question question, std::string command, SteadyTime now, bool stops = false);

    Probe m_probe = Probe::ExtendedState;
    bool m_probeAnswered = false;  // by a rotctld, on this or an earlier connection
    Proof m_proof = Proof::Unknown;
    std::optional<RotatorState> m_state;
    std::deque<Pending> m_waiting;
    struct
    {
        LineSplitter splitter;
        std::string rest;  // the beginning of a line without its end
    } m_line;
    std::optional<Places> m_places;  // not yet read
    struct
    {
        std::optional<AxisPosition> next{};
        std::optional<AxisPosition> last{};
        std::optional<SteadyTime> sent{};
        int refusals = 0;
        int error = 0;
    } m_order;
    struct
    {
        bool wanted = false;
        bool unavailable = false;
        SteadyTime from{};  // earliest time of the next stop
        std::optional<AxisPosition> place{};
    } m_stop;
    struct
    {
        bool wanted = false;
        std::optional<Result<>> answer;  // not yet read
    } m_home;
    std::optional<SteadyTime> m_asked;
    int m_positionError = 0;
    Counts m_counts;
    std::string m_strange;
    bool m_wantsLine = false;
};

}  // namespace boresight::rotctl
