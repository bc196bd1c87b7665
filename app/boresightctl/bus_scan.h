// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/boresightctl/scan_report.h"
#include "core/can/can_link.h"

#include <QObject>
#include <QTimer>

#include <vector>

// Looks for every controller on an open bus, with questions only: nothing it sends moves an axis or feeds a watchdog.
// All are asked for their UUID at once; then every id that stayed silent is asked, twice, whether somebody is there;
// then each controller is asked what it is and how it is. Takes 1.3 seconds. Lives with its link.
//
// Two boards with one id destroy each other's answers, unless the answers are the same bits: the question whether
// somebody is there has such an answer, so that even such a pair is noticed.
namespace boresight::ctl {

class BusScan final : public QObject
{
    Q_OBJECT

public:
    // The link outlives the scan and is open.
    explicit BusScan(CanLink& link, QObject* parent = nullptr);

    void start();
    // In the order of their ids.
    [[nodiscard]] const std::vector<FoundController>& controllers() const { return m_controllers; }

Q_SIGNALS:
    // With the link's reason if a question could not be sent; else empty.
    void finished(const QString& problem);

private:
    enum class Phase
    {
        Discover,  // all at once
        Sweep,     // is somebody there? id by id
        Identify,  // one question after the other, each repeated until it is answered
        Done,
    };

    void next();
    void sweep();
    void beginIdentify();
    void identify();
    void ask(const moteus::Request& request);
    void send(const CanFrame& frame);
    void end(const QString& problem);

    void take(const CanFrame& frame);
    void takeDiscovered(const moteus::Reply& reply);
    void takeAnswer(const moteus::Reply& reply);
    [[nodiscard]] bool isKnown(int id) const;
    [[nodiscard]] moteus::Request question() const;

    CanLink& m_link;
    QTimer m_timer;
    Phase m_phase = Phase::Discover;
    std::vector<FoundController> m_controllers;
    int m_sweptId = 0;
    int m_sweeps = 0;
    std::size_t m_controller = 0;  // which one is asked
    std::size_t m_question = 0;    // and for what
    int m_tries = 0;
};

}  // namespace boresight::ctl
