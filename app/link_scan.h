// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/can/can_link.h"
#include "core/survey/bus_scan.h"

#include <QObject>
#include <QTimer>

#include <vector>

// A scan of an open bus (core/survey/bus_scan.h) with a timer of its own: who is there, and how each one is. Takes 1.3
// seconds. Lives with its link.
namespace boresight::app {

class LinkScan final : public QObject
{
    Q_OBJECT

public:
    // The link outlives the scan and is open.
    explicit LinkScan(CanLink& link, QObject* parent = nullptr);

    void start();
    // In the order of their ids.
    [[nodiscard]] const std::vector<survey::FoundController>& controllers() const { return m_scan.controllers(); }

Q_SIGNALS:
    // With the link's reason if a question could not be sent; else empty.
    void finished(const QString& problem);

private:
    void step();
    void take(const CanFrame& frame);
    void end(const QString& problem);

    CanLink& m_link;
    QTimer m_timer;
    SystemClock m_clock;
    survey::BusScan m_scan;
};

}  // namespace boresight::app
