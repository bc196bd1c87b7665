// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mqtt/broker.h"

#include <algorithm>
#include <deque>
#include <functional>
#include <iterator>
#include <utility>
#include <vector>

// The newest messages that wait for another thread: at most kMost, and together at most kLargestMessage bytes. A sensor
// sends ten messages a second, so only a flood reaches this limit. If there are too many bytes, the largest message is
// dropped. If there are too many messages, the oldest message of the most frequent topic is dropped. So a flood of one
// topic does not displace a message of another topic. An urgent message, such as a STOP, is dropped only beside other
// urgent ones, at first one that repeats another. Pure.
namespace boresight::mqtt {

// Any thread may call it.
using IsUrgent = std::function<bool(const Message& message)>;

class NewestMessages
{
public:
    static constexpr std::size_t kMost = 32;

    void keepUrgent(IsUrgent isUrgent) { m_isUrgent = std::move(isUrgent); }

    void add(Message message)
    {
        m_bytes += message.payload.size();
        const bool isUrgent = m_isUrgent && m_isUrgent(message);
        m_waiting.push_back({.message = std::move(message), .isUrgent = isUrgent});
        while (m_bytes > kLargestMessage) {
            drop(std::ranges::max_element(m_waiting, {}, [](const Waiting& one) {
                return std::pair(!one.isUrgent, one.message.payload.size());
            }));
        }
        if (m_waiting.size() > kMost) {
            drop(surplus());
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
        bool isUrgent = false;
    };
    using Place = std::deque<Waiting>::iterator;

    [[nodiscard]] QString mostFrequentTopic() const
    {
        const auto count = [this](const Waiting& one) {
            return std::ranges::count(m_waiting, one.message.topic, &topicOf);
        };
        return std::ranges::max_element(m_waiting, {}, count)->message.topic;
    }
    [[nodiscard]] Place surplus()
    {
        const QString topic = mostFrequentTopic();
        const auto oldest = std::ranges::find_if(
            m_waiting, [&topic](const Waiting& one) { return !one.isUrgent && one.message.topic == topic; });
        return oldest != m_waiting.end() ? oldest : newestRepeated(topic);
    }
    // The newest message of this topic that repeats an earlier one, else the newest one.
    [[nodiscard]] Place newestRepeated(const QString& topic)
    {
        Place newest = m_waiting.end();
        for (auto i = std::ssize(m_waiting); i-- > 0;) {
            const Place one = m_waiting.begin() + i;
            if (one->message.topic != topic) {
                continue;
            }
            newest = newest == m_waiting.end() ? one : newest;
            if (std::any_of(m_waiting.begin(), one,
                            [one](const Waiting& other) { return other.message == one->message; })) {
                return one;
            }
        }
        return newest;
    }
    [[nodiscard]] static const QString& topicOf(const Waiting& one) { return one.message.topic; }
    void drop(Place one)
    {
        m_bytes -= one->message.payload.size();
        m_waiting.erase(one);
    }

    IsUrgent m_isUrgent;
    std::deque<Waiting> m_waiting;
    qint64 m_bytes = 0;
};

}  // namespace boresight::mqtt
