// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/log_throttle.h"
#include "core/inputs/message_inlet.h"
#include "core/messages/position_status.h"
#include "core/position/position_text.h"
#include "core/profile/in_force.h"

#include <QObject>

// Receives the positions of a balloon or a rocket from the UDP port or the topic that the profile names. The source is
// opened and closed when the profile changes. Station thread.
namespace boresight {

class StationPosition : public QObject
{
    Q_OBJECT

public:
    // All arguments but the parent outlive this.
    StationPosition(const profile::InForce& profile, EventLog& log, const Clock& clock, StationBroker& broker,
                    QObject* parent);

    void open();
    void close();
    // A source that did not change stays open.
    void profileChanged(const profile::Profile& before, const profile::Profile& after);
    // Logs why a position was refused. A position of another balloon or rocket is not logged.
    void tellRefused(const Error& why);
    // Fills in the source of the positions and its trouble.
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
