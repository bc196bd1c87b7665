// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/rotator_box/rotator_talk.h"
#include "core/rotctl/reply_reader.h"
#include "core/serial/line_splitter.h"

#include <deque>
#include <optional>
#include <string>
#include <string_view>

// The conversation with a rotctld. It works at one command at a time, so the next one waits for the answer, however
// long that takes: what is sent before would stand in its queue, and a stop behind it. It is asked where the rotator
// stands four times a second at most, and sends it somewhere twice a second at most. A stop waits for nothing, and
// nothing but questions passes it. A refused stop is repeated. A rotator that cannot stop is sent to where it stands.
//
// First it is asked for its limits. The answer tells a rotctld from any other server. Whoever does not know the
// extended form is asked in the plain form, and then for the position only, each on a new connection: late answers
// belong to the old one. The form that it has answered in stays. Pure: time and bytes are passed in.
namespace boresight::rotctl {

class RotctldTalk final : public RotatorTalk
{
public:
    static constexpr std::chrono::milliseconds kBetweenAsks{250};    // from one question to the next
    static constexpr std::chrono::milliseconds kBetweenGoes{500};    // from one target to the next
    static constexpr std::chrono::milliseconds kBetweenStops{500};   // that were refused
    static constexpr std::chrono::milliseconds kBetweenTries{1000};  // of questions before the first answer
    static constexpr std::chrono::seconds kProbeTime{4};             // of an answer of somebody who is not known yet
    static constexpr std::chrono::seconds kHangs{5};                 // of an answer: it is connected to anew

    void restart() override;
    void take(std::string_view bytes, SteadyTime now) override;
    [[nodiscard]] std::optional<Places> takePlaces() override;

    // Replaces the target that was not sent yet. False: there is no such place.
    [[nodiscard]] bool go(const AxisPosition& target);
    void stop() override;
    // Where a rotator that cannot stop is sent to stop it. Empty: nobody knows where it stands.
    void standsAt(const std::optional<AxisPosition>& place) { m_stop.place = place; }
    [[nodiscard]] std::string send(SteadyTime now) override;

    [[nodiscard]] Proof proof() const override { return m_proof; }
    [[nodiscard]] const Counts& counts() const override { return m_counts; }
    [[nodiscard]] const std::string& strange() const override { return m_strange; }
    // Empty: not known, or this server does not tell.
    [[nodiscard]] const std::optional<RotatorState>& state() const { return m_state; }
    [[nodiscard]] bool wantsAnotherLine() const override { return m_wantsLine; }
    // Of the last question for the position; 0: it was answered.
    [[nodiscard]] int positionError() const { return m_positionError; }
    // Targets in a row that were refused, and the last error.
    [[nodiscard]] int refusals() const { return m_order.refusals; }
    [[nodiscard]] int refusal() const { return m_order.error; }

private:
    // What is asked of somebody who is not known yet, in this order.
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
        bool spoiled = false;  // a line of it was strange: the rest is passed over
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
    bool m_probeAnswered = false;  // by a rotctld, on this connection or an earlier one
    Proof m_proof = Proof::Unknown;
    std::optional<RotatorState> m_state;
    std::deque<Pending> m_waiting;
    struct
    {
        LineSplitter splitter;
        std::string rest;  // of a line without its end, its beginning
    } m_line;
    std::optional<Places> m_places;  // not taken yet
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
        SteadyTime from{};  // not before
        std::optional<AxisPosition> place{};
    } m_stop;
    std::optional<SteadyTime> m_asked;
    int m_positionError = 0;
    Counts m_counts;
    std::string m_strange;
    bool m_wantsLine = false;
};

}  // namespace boresight::rotctl
