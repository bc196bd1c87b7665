// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/inputs/station_azel.h"

#include "core/azel_file/azel_file.h"

namespace boresight {

StationAzel::StationAzel(const profile::InForce& profile, QObject* parent) : QObject(parent), m_profile(profile)
{
    m_reader.setMaxThreadCount(1);
    m_timer.setInterval(kPeriod);
    connect(&m_timer, &QTimer::timeout, this, &StationAzel::look);
}

void StationAzel::look()
{
    if (m_looking) {
        return;
    }
    m_looking = true;
    m_reader.start([this, path = azel::azelPath(m_profile->azel)] {
        QMetaObject::invokeMethod(
            this, [this, reading = azel::readAzelFile(path)] { take(reading); }, Qt::QueuedConnection);
    });
}

// Ignores a reading of a file that the profile does not name any more.
void StationAzel::take(const azel::AzelReading& reading)
{
    m_looking = false;
    if (reading.path == azel::azelPath(m_profile->azel)) {
        Q_EMIT looked(reading);
    }
}

}  // namespace boresight

#include "moc_station_azel.cpp"
