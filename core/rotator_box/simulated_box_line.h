// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/rotator_box/box_line.h"
#include "core/rotator_box/simulated_box.h"

#include <memory>

// The line to a simulated box.
namespace boresight {

class SimulatedBoxLine final : public BoxLine
{
    Q_OBJECT

public:
    explicit SimulatedBoxLine(std::shared_ptr<SimulatedBox> box) : m_box(std::move(box)) {}

    [[nodiscard]] QString name() const override { return QStringLiteral("simulated"); }
    void open() override { show(State::Up); }
    void close() override { show(State::Closed); }
    void write(const QByteArray& bytes) override { m_box->take(bytes.toStdString(), m_now); }
    void tick(SteadyTime now) override;

private:
    std::shared_ptr<SimulatedBox> m_box;
    SteadyTime m_now{};
};

}  // namespace boresight
