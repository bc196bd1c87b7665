// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/can/can_link.h"
#include "core/drive_check/bus_scan.h"

#include <QObject>
#include <QTimer>

#include <vector>

// A scan of an open bus (core/drive_check/bus_scan.h) with its own timer: which controllers answer, and the condition
// of each. Takes 1.3 seconds. Lives on the thread of its link.
namespace boresight::app {

class LinkScan final : public QObject
{
    Q_OBJECT

public:
    // The link must be open and outlive the scan.
    explicit LinkScan(CanLink& link, QObject* parent = nullptr);

    void start();
    // Sorted by id.
    [[nodiscard]] const std::vector<drive_check::FoundController>& controllers() const { return m_scan.controllers(); }

Q_SIGNALS:
    // `problem`: why the link could not send a query. Empty: no problem.
    void finished(const QString& problem);

private:
    void step();
    void take(const CanFrame& frame);
    void end(const QString& problem);

    CanLink& m_link;
    QTimer m_timer;
    SystemClock m_clock;
    drive_check::BusScan m_scan;
};

}  // namespace boresight::app
