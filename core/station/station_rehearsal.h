// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/messages/rehearsal_status.h"
#include "core/rehearsal/rehearsal.h"

#include <QObject>
#include <QThreadPool>

#include <stop_token>

// Rehearses the schedule on a thread of its own, one rehearsal at a time. The destructor stops a running rehearsal.
// Station thread only.
namespace boresight {

class StationRehearsal : public QObject
{
    Q_OBJECT

public:
    explicit StationRehearsal(QObject* parent);
    ~StationRehearsal() override;

    Result<> begin(RehearsalTask task);
    void stop();
    [[nodiscard]] const RehearsalStatus& status() const { return m_status; }

private:
    void finish(const Result<RehearsedNight>& night);

    RehearsalStatus m_status;
    std::stop_source m_stop;
    QThreadPool m_worker;  // last member: its work ends before the other members are destroyed
};

}  // namespace boresight
