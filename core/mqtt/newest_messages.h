// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mqtt/broker.h"

#include <algorithm>
#include <deque>
#include <iterator>
#include <utility>
#include <vector>

// The newest messages that wait for another thread: at most kMost, and together at most kLargestMessage bytes. A sensor
// sends ten messages a second, so only a flood reaches this limit. If there are too many bytes, the largest message is
// dropped. If there are too many messages, the oldest message of the most frequent topic is dropped. So a flood of one
// topic does not displace a STOP of another topic. Pure.
namespace boresight::mqtt {

class NewestMessages
{
public:
    static constexpr std::size_t kMost = 32;

    void add(Message message)
    {
        m_bytes += message.payload.size();
        m_messages.push_back(std::move(message));
        while (m_bytes > kLargestMessage) {
            drop(std::ranges::max_element(m_messages, {}, [](const Message& one) { return one.payload.size(); }));
        }
        if (m_messages.size() > kMost) {
            drop(std::ranges::find(m_messages, mostFrequentTopic(), &Message::topic));
        }
    }
    // The oldest comes first.
    [[nodiscard]] std::vector<Message> take()
    {
        m_bytes = 0;
        const std::deque<Message> all = std::exchange(m_messages, {});
        return {all.begin(), all.end()};
    }

private:
    [[nodiscard]] QString mostFrequentTopic() const
    {
        const auto count = [this](const Message& one) {
            return std::ranges::count(m_messages, one.topic, &Message::topic);
        };
        return std::ranges::max_element(m_messages, {}, count)->topic;
    }
    void drop(std::deque<Message>::iterator one)
    {
        m_bytes -= one->payload.size();
        m_messages.erase(one);
    }

    std::deque<Message> m_messages;
    qint64 m_bytes = 0;
};

}  // namespace boresight::mqtt
