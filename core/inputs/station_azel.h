// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/azel/azel_feed.h"
#include "core/profile/in_force.h"

#include <QObject>
#include <QThreadPool>
#include <QTimer>

// Reads the azel.dat of WSJT-X on a thread of its own, because a folder of another computer may block a reader. One
// reading ends before the next one begins. Station thread only.
namespace boresight {

class StationAzel : public QObject
{
    Q_OBJECT

public:
    static constexpr std::chrono::milliseconds kPeriod{250};

    // The profile outlives this.
    StationAzel(const profile::InForce& profile, QObject* parent);

    void open() { m_timer.start(); }
    void close() { m_timer.stop(); }

    // The timer calls this.
    void look();

Q_SIGNALS:
    void looked(const boresight::azel::AzelReading& reading);

private:
    void take(const azel::AzelReading& reading);

    const profile::InForce& m_profile;
    QTimer m_timer{this};
    bool m_looking = false;
    QThreadPool m_reader;  // last member: its work ends before the other members are destroyed
};

}  // namespace boresight
