// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/log_throttle.h"
#include "core/messages/wind_status.h"
#include "core/profile/in_force.h"
#include "core/station/message_inlet.h"

#include <QObject>

#include <cstdint>

// The readings of an anemometer, from where the profile says. Opened and closed as the profile changes. Station thread.
namespace boresight {

class StationWind : public QObject
{
    Q_OBJECT

public:
    // All but the parent outlive this.
    StationWind(const profile::InForce& profile, EventLog& log, const Clock& clock, StationBroker& broker,
                QObject* parent);

    void open();
    void close();
    // What did not change goes on.
    void profileChanged(const profile::Profile& before, const profile::Profile& after);
    // What is wrong with where they come from, and what could not be read.
    void describe(WindStatus& status) const;

Q_SIGNALS:
    void measured(double speed);  // m/s

private:
    void take(const QByteArray& message);

    const profile::InForce& m_profile;
    LogThrottle m_lines;
    MessageInlet m_inlet;
    std::uint64_t m_refused = 0;
    QString m_refusal;
    bool m_open = false;
};

}  // namespace boresight
