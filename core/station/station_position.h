// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/log_throttle.h"
#include "core/messages/position_status.h"
#include "core/position/position_text.h"
#include "core/profile/in_force.h"
#include "core/station/message_inlet.h"

#include <QObject>

// Where the positions of a balloon or a rocket come from: the UDP port or the topic that the profile names, opened and
// closed as the profile changes. Station thread.
namespace boresight {

class StationPosition : public QObject
{
    Q_OBJECT

public:
    // All but the parent outlive this.
    StationPosition(const profile::InForce& profile, EventLog& log, const Clock& clock, StationBroker& broker,
                    QObject* parent);

    void open();
    void close();
    // What did not change goes on.
    void profileChanged(const profile::Profile& before, const profile::Profile& after);
    // What arrived was not believed. That others fly, too, is no trouble.
    void tellRefused(const Error& why);
    // Where they come from, and what is wrong with that.
    void describe(PositionStatus& status) const;

Q_SIGNALS:
    void received(const boresight::Result<boresight::position::PositionText>& read);

private:
    const profile::InForce& m_profile;
    LogThrottle m_lines;
    MessageInlet m_inlet;
    bool m_open = false;
};

}  // namespace boresight
