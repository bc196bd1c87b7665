// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/moteus/codec.h"

#include <vector>

// Looks for every controller on a bus, with questions only: nothing it sends moves an axis or feeds a watchdog. All are
// asked for their UUID at once; then every id that stayed silent is asked, twice, whether somebody is there; then each
// controller is put the given questions, one by one. Pure: its owner sends frames() and brings the replies; about
// 1.3 seconds with frames() called every 20 ms or oftener.
//
// Two boards with one id destroy each other's answers, unless the answers are the same bits: the question whether
// somebody is there has such an answer, so that even such a pair is noticed.
namespace boresight::survey {

struct FoundController
{
    int id = 0;           // under which it answers
    moteus::Reply known;  // all it has told, of every answer

    // Neither its UUID nor a reason for not having one.
    [[nodiscard]] bool isUnreadable() const;
};

class BusScan
{
public:
    // `source`: our own number on the bus; only replies to it count. Each question is a query of at least one register.
    BusScan(std::uint8_t source, std::vector<moteus::Query> questions);

    void begin(SteadyTime now);
    // What is to be sent now; a reply may follow at any time. Several frames at once while the ids are asked.
    [[nodiscard]] std::vector<CanFrame> frames(SteadyTime now);
    void take(const moteus::Reply& reply);

    [[nodiscard]] bool isRunning() const { return m_phase != Phase::Idle; }
    // In the order of their ids; whole once the scan no longer runs.
    [[nodiscard]] const std::vector<FoundController>& controllers() const { return m_controllers; }

private:
    enum class Phase
    {
        Idle,
        Discover,  // all at once
        Sweep,     // is somebody there? id by id
        Settle,    // for late answers
        Identify,  // one question after the other, each repeated until it is answered
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
    SteadyTime m_entered{};  // the phase
    std::vector<FoundController> m_controllers;
    int m_asked = 0;               // ids, or broadcasts
    std::size_t m_controller = 0;  // which one is asked
    std::size_t m_question = 0;    // and for what
    int m_tries = 0;
    bool m_answered = false;
    SteadyTime m_questionSent{};
};

}  // namespace boresight::survey
