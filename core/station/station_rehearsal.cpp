// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/station_rehearsal.h"

#include "core/base/text.h"

#include <utility>

namespace boresight {

StationRehearsal::StationRehearsal(QObject* parent) : QObject(parent)
{
    m_worker.setMaxThreadCount(1);
    m_worker.setThreadPriority(QThread::IdlePriority);
}

StationRehearsal::~StationRehearsal()
{
    stop();
    m_worker.waitForDone();
}

Result<> StationRehearsal::begin(RehearsalTask task)
{
    if (m_status.progress) {
        return failure(ErrorCode::Busy, Text::tr("A rehearsal runs already. Wait for its end, or stop it."));
    }
    m_status = {.progress = 0.0, .problem = {}, .night = {}};
    m_stop = {};
    m_worker.start([this, task = std::move(task), stop = m_stop.get_token()] {
        const Result<RehearsedNight> night = rehearse(task, stop, [this](double done) {
            QMetaObject::invokeMethod(
                this, [this, done] { m_status.progress = done; }, Qt::QueuedConnection);
        });
        QMetaObject::invokeMethod(
            this, [this, night] { finish(night); }, Qt::QueuedConnection);
    });
    return {};
}

void StationRehearsal::stop()
{
    m_stop.request_stop();
}

void StationRehearsal::finish(const Result<RehearsedNight>& night)
{
    m_status = {};
    if (night) {
        m_status.night = std::make_shared<const RehearsedNight>(*night);
    } else {
        m_status.problem = night.error().text;
    }
}

}  // namespace boresight

#include "moc_station_rehearsal.cpp"
