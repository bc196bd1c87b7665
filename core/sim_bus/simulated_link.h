// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/can/can_link.h"
#include "core/sim/simulated_pair.h"
#include "core/sim/simulated_sensor.h"
#include "core/sim_bus/due_queue.h"

#include <QTimer>

#include <memory>

// The bus "simulated": the pair inside the program. Lives on the station thread. The pair follows the injected clock:
// it catches up whenever frames arrive or its state is read. The mount may outlive the link, like a real mount: the
// next link finds its position and the settings of its drives again. Replies come through the event loop. With a
// hand-turned clock, deliver() hands over the replies that are due.
namespace boresight {

// A pair, the time at which it began, and the sensor on its antenna. Used by one link and one source at a time.
struct SimulatedMount
{
    SimulatedMount(const Clock& clock, const sim::PairSettings& settings) : epoch(clock.now()), pair(settings) {}

    SteadyTime epoch;
    sim::SimulatedPair pair;
    sim::SimulatedSensor sensor;
};

class SimulatedLink final : public CanLink
{
    Q_OBJECT

public:
    // The clock must outlive the link. The mount exists from now on, also while the link is closed.
    explicit SimulatedLink(const Clock& clock, const sim::PairSettings& settings = sim::commissionedPair(),
                           QObject* parent = nullptr);
    SimulatedLink(const Clock& clock, std::shared_ptr<SimulatedMount> mount, QObject* parent = nullptr);

    [[nodiscard]] QString name() const override;
    [[nodiscard]] LinkStatus status() const override { return m_status; }
    Result<> open() override;
    void close() override;
    Result<> send(std::span<const CanFrame> frames) override;

    void deliver();

    // Both move the pair on to the present first.
    [[nodiscard]] sim::AxisTruth truth(Axis axis);
    [[nodiscard]] sim::SimulatedSensor& sensor() { return m_mount->sensor; }
    [[nodiscard]] sim::SimulatedPair& pair();
    // From now on for the duration of the injection (without end if it has none). Use pair().faults() to plan
    // injections.
    sim::FaultSchedule::Handle inject(sim::Injection injection);

private:
    [[nodiscard]] Seconds pairTime() const { return m_clock.now() - m_mount->epoch; }
    [[nodiscard]] bool isInjected(sim::FaultKind kind) const;
    [[nodiscard]] QString adapterTrouble() const;
    void setState(LinkState state, const QString& text);
    void schedule();

    const Clock& m_clock;
    std::shared_ptr<SimulatedMount> m_mount;
    sim::SimulatedPair& m_pair;
    sim::DueQueue<sim::PairReply> m_replies;
    LinkStatus m_status;
    QTimer m_timer{this};
};

}  // namespace boresight
