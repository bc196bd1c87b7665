// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/passes/pass_finder.h"

#include <QObject>
#include <QThreadPool>

#include <functional>
#include <stop_token>
#include <vector>

// Searches passes beside the station thread, one search after the other, and tells on the station thread what it found.
// Its end ends a search. Station thread only.
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
    QThreadPool m_worker;  // last: it ends before what it tells
};

}  // namespace boresight
