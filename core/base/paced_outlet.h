// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>

#include <chrono>
#include <functional>
#include <utility>

// Decides when a thread may send its next report to another thread. Two reports are at least kPeriod apart, and the
// next one waits until the receiver has taken the last one. So a flood at the sender never becomes a queue at the
// receiver. The first report after a pause is sent at once. Lives on the sender's thread.
namespace boresight {

class PacedOutlet
{
public:
    static constexpr std::chrono::milliseconds kPeriod{20};

    // `send` is called once for each report, from ask(), taken() or the event loop. The outlet must be a member of
    // `owner`.
    PacedOutlet(QObject* owner, std::function<void()> send) : m_send(std::move(send)), m_pause(owner)
    {
        m_pause.setSingleShot(true);
        m_pause.setTimerType(Qt::PreciseTimer);
        m_pause.setInterval(kPeriod);
        m_pause.callOnTimeout([this] { sendIfDue(); });
    }
    PacedOutlet(const PacedOutlet&) = delete;
    PacedOutlet& operator=(const PacedOutlet&) = delete;

    // Call it when there is something to report.
    void ask()
    {
        m_asked = true;
        sendIfDue();
    }
    // Call it when the receiver has taken the last report.
    void taken()
    {
        m_untaken = false;
        sendIfDue();
    }

private:
    void sendIfDue()
    {
        if (m_asked && !m_untaken && !m_pause.isActive()) {
            m_asked = false;
            m_untaken = true;
            m_pause.start();
            m_send();
        }
    }

    std::function<void()> m_send;
    QTimer m_pause;
    bool m_asked = false;
    bool m_untaken = false;
};

}  // namespace boresight
