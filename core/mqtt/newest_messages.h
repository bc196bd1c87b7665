// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mqtt/broker.h"

#include <algorithm>
#include <deque>
#include <functional>
#include <utility>
#include <vector>

// The newest messages that wait for another thread: at most kMost, and together at most kLargestMessage bytes. A sensor
// sends ten messages a second, so only a flood reaches this limit. If there are too many bytes, the largest message is
// dropped. If there are too many messages, the oldest message of the most frequent topic is dropped. So a flood of one
// topic does not displace a message of another topic. The newest hold and the newest STOP of each topic stay. Where
// even these have too many bytes, the holds are dropped first, and one STOP stays. Pure.
namespace boresight::mqtt {

enum class Urgency
{
    None,
    Hold,
    Stop
};

// Any thread may call it. It may remove a payload that nobody reads.
using UrgencyOf = std::function<Urgency(Message& message)>;

class NewestMessages
{
public:
    static constexpr std::size_t kMost = 32;

    void keepUrgent(UrgencyOf urgencyOf) { m_urgencyOf = std::move(urgencyOf); }

    void add(Message message)
    {
        const Urgency urgency = m_urgencyOf ? m_urgencyOf(message) : Urgency::None;
        m_bytes += message.payload.size();
        m_waiting.push_back({.message = std::move(message), .urgency = urgency});
        while (m_bytes > kLargestMessage) {
            dropOne([](const Waiting& one) { return one.message.payload.size(); });
        }
        if (m_waiting.size() > kMost) {
            dropOne([this](const Waiting& one) {
                return std::ranges::count(m_waiting, one.message.topic,
                                          [](const Waiting& other) -> const QString& { return other.message.topic; });
            });
        }
    }
    // The oldest comes first.
    [[nodiscard]] std::vector<Message> take()
    {
        m_bytes = 0;
        std::vector<Message> all;
        for (Waiting& one : std::exchange(m_waiting, {})) {
            all.push_back(std::move(one.message));
        }
        return all;
    }

private:
    struct Waiting
    {
        Message message;
        Urgency urgency = Urgency::None;
    };

    // A newer message of the same kind and topic replaces an urgent one.
    [[nodiscard]] Urgency needOf(const Waiting& one) const
    {
        if (one.urgency == Urgency::None) {
            return Urgency::None;
        }
        const auto newest = std::find_if(m_waiting.rbegin(), m_waiting.rend(), [&one](const Waiting& other) {
            return other.urgency == one.urgency && other.message.topic == one.message.topic;
        });
        return &*newest == &one ? one.urgency : Urgency::None;
    }
    // Drops the oldest of those with the greatest weight that are needed least.
    template <class Weight>
    void dropOne(Weight weight)
    {
        const auto least = std::ranges::min_element(
            m_waiting, {}, [&](const Waiting& one) { return std::pair(needOf(one), -weight(one)); });
        m_bytes -= least->message.payload.size();
        m_waiting.erase(least);
    }

    UrgencyOf m_urgencyOf;
    std::deque<Waiting> m_waiting;
    qint64 m_bytes = 0;
};

}  // namespace boresight::mqtt
