// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/station_passes.h"

#include <utility>

namespace boresight {

StationPasses::StationPasses(QObject* parent) : QObject(parent)
{
    m_worker.setMaxThreadCount(1);
}

StationPasses::~StationPasses()
{
    m_stop.request_stop();
    m_worker.waitForDone();
}

void StationPasses::search(std::vector<passes::SatelliteSearch> searches,
                           std::function<void(const std::vector<passes::PassList>&)> found)
{
    m_worker.start(
        [this, searches = std::move(searches), found = std::move(found), stop = m_stop.get_token()]() mutable {
            auto lists = passes::findPasses(searches, stop);
            QMetaObject::invokeMethod(
                this, [found = std::move(found), lists = std::move(lists)] { found(lists); }, Qt::QueuedConnection);
        });
}

}  // namespace boresight

#include "moc_station_passes.cpp"
