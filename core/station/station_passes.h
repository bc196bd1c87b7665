// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/passes/pass_finder.h"

#include <QObject>
#include <QThreadPool>

#include <functional>
#include <stop_token>
#include <vector>

// Searches passes on a thread of its own, one search after the other. The result arrives on the station thread. The
// destructor stops a running search. Station thread only.
namespace boresight {

class StationPasses : public QObject
{
    Q_OBJECT

public:
    explicit StationPasses(QObject* parent);
    ~StationPasses() override;

    void search(std::vector<passes::SatelliteSearch> searches,
                std::function<void(const std::vector<passes::PassList>&)> found);

private:
    std::stop_source m_stop;
    QThreadPool m_worker;  // last member: its work ends before the other members are destroyed
};

}  // namespace boresight
