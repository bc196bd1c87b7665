// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/moteus/codec.h"

#include <vector>

// Finds every controller on a bus with queries only: nothing that it sends moves an axis or feeds a watchdog. First it
// asks all at once for their UUID. Then it asks every id that stayed silent, twice, whether a board is there. Then it
// puts the given queries to each controller, one by one. Pure: its owner sends frames() and passes the replies in.
// Takes about 1.3 seconds if frames() is called every 20 ms or more often.
//
// If two boards have the same id, their answers destroy each other, unless the answers are the same bits. The query
// whether a board is there has such an answer, so even such a pair is found.
namespace boresight::drive_check {

struct FoundController
{
    int id = 0;           // the id with which it answers
    moteus::Reply known;  // the values of all its answers

    // The board has reported neither its UUID nor an error for it.
    [[nodiscard]] bool isUnreadable() const;
};

class BusScan
{
public:
    // `source`: our id on the bus. Only replies to this id count. Each query has at least one register.
    BusScan(std::uint8_t source, std::vector<moteus::Query> questions);

    void begin(SteadyTime now);
    // The frames to send now. Replies may come at any time. Several frames at once while the ids are asked.
    [[nodiscard]] std::vector<CanFrame> frames(SteadyTime now);
    void take(const moteus::Reply& reply);

    [[nodiscard]] bool isRunning() const { return m_phase != Phase::Idle; }
    // In the order of their ids. Complete once the scan has ended.
    [[nodiscard]] const std::vector<FoundController>& controllers() const { return m_controllers; }

private:
    enum class Phase
    {
        Idle,
        Discover,  // all boards at once
        Sweep,     // id by id: is a board there?
        Settle,    // waits for late answers
        Identify,  // one query after the other, each repeated until it is answered
    };

    void enter(Phase phase, SteadyTime now);
    [[nodiscard]] std::vector<CanFrame> discover(SteadyTime now);
    [[nodiscard]] std::vector<CanFrame> sweep(SteadyTime now);
    [[nodiscard]] std::vector<CanFrame> identify(SteadyTime now);
    [[nodiscard]] bool passToUnanswered();
    [[nodiscard]] moteus::Request question() const;
    void takeDiscovered(const moteus::Reply& reply);
    void takeAnswer(const moteus::Reply& reply);
    [[nodiscard]] bool isKnown(int id) const;

    std::uint8_t m_source;
    std::vector<moteus::Query> m_questions;
    Phase m_phase = Phase::Idle;
    SteadyTime m_entered{};  // when the phase began
    std::vector<FoundController> m_controllers;
    int m_asked = 0;               // number of ids or broadcasts so far
    std::size_t m_controller = 0;  // index of the controller that is being asked
    std::size_t m_question = 0;    // index of the query
    int m_tries = 0;
    bool m_answered = false;
    SteadyTime m_questionSent{};
};

}  // namespace boresight::drive_check
