// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mqtt/broker.h"

#include <deque>
#include <utility>
#include <vector>

// The newest messages that wait for another thread: at most kMost, and together at most kLargestMessage bytes. Above
// that the oldest are dropped. A sensor sends ten messages a second, so only a flood reaches this limit. Pure.
namespace boresight::mqtt {

class NewestMessages
{
public:
    static constexpr std::size_t kMost = 32;

    void add(Message message)
    {
        m_bytes += message.payload.size();
        m_messages.push_back(std::move(message));
        while (m_messages.size() > kMost || m_bytes > kLargestMessage) {
            m_bytes -= m_messages.front().payload.size();
            m_messages.pop_front();
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
    std::deque<Message> m_messages;
    qint64 m_bytes = 0;
};

}  // namespace boresight::mqtt
