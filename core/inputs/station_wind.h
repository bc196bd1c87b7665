// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/log_throttle.h"
#include "core/inputs/message_inlet.h"
#include "core/messages/wind_status.h"
#include "core/profile/in_force.h"

#include <QObject>

#include <cstdint>

// Receives the readings of an anemometer from the source that the profile names. The source is opened and closed when
// the profile changes. Station thread.
namespace boresight {

class StationWind : public QObject
{
    Q_OBJECT

public:
    // All arguments but the parent outlive this.
    StationWind(const profile::InForce& profile, EventLog& log, const Clock& clock, StationBroker& broker,
                QObject* parent);

    void open();
    void close();
    // A source that did not change stays open.
    void profileChanged(const profile::Profile& before, const profile::Profile& after);
    // Why no reading comes. Empty: no trouble is known.
    [[nodiscard]] QString trouble() const { return m_inlet.trouble(); }
    // Fills in the trouble of the source, and the readings that were refused.
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
