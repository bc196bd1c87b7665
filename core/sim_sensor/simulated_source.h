// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/orientation/sentence_stream.h"
#include "core/orientation_stream/sensor_source.h"
#include "core/sim_bus/simulated_link.h"

#include <QTimer>

#include <memory>

// The sensor of the built-in simulated mount as a source of orientations. Its messages go through the same parser as
// the bytes of a serial port. Lives on the station thread.
namespace boresight {

class SimulatedSource final : public orientation::SensorSource
{
    Q_OBJECT

public:
    // The clock outlives the source.
    SimulatedSource(const Clock& clock, std::shared_ptr<SimulatedMount> mount, QObject* parent = nullptr);

    [[nodiscard]] QString name() const override { return QStringLiteral("simulated"); }
    [[nodiscard]] const orientation::SourceStatus& status() const override { return m_status; }
    void open() override;
    void close() override;

    // The timer calls this. Tests with a hand-turned clock call it themselves.
    void read();

private:
    void setOpen(bool open);

    const Clock& m_clock;
    std::shared_ptr<SimulatedMount> m_mount;
    orientation::SentenceStream m_stream;
    orientation::SourceStatus m_status;
    QTimer m_timer{this};
};

}  // namespace boresight
