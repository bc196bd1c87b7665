// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_board.h"
#include "core/mount/mount_connection.h"
#include "core/mount/mount_kind.h"
#include "core/rotator_box/box_line.h"
#include "core/rotator_box/box_mount.h"

#include <memory>

// A rotator with a control box, and its line. A line to another kind of device is closed, and stays closed until the
// operator reconnects. Station thread only.
namespace boresight {

class BoxConnection final : public MountConnection
{
    Q_OBJECT

public:
    BoxConnection(std::unique_ptr<BoxLine> line, std::unique_ptr<BoxMount> mount, bool simulated, const Clock& clock,
                  EventLog& log, AlarmBoard& alarms);
    ~BoxConnection() override;

    [[nodiscard]] MountDriver& driver() override { return *m_mount; }
    [[nodiscard]] const MountDriver& driver() const override { return *m_mount; }
    [[nodiscard]] bool simulated() const override { return m_simulated; }
    [[nodiscard]] const Result<>& mine() const override { return m_mine; }
    void open() override;
    void close() override;
    void send() override;
    [[nodiscard]] Result<> admits(const Request& request) const override;
    [[nodiscard]] Result<> carryOut(const Request& request) override;
    void profileChanged(const profile::Profile& /*before*/, const profile::Profile& /*after*/) override {}
    void setCourse(const std::optional<SensorCourse>& /*course*/) override {}
    void describe(StationStatus& status) const override;

private:
    void showLine();
    void watchProof();

    const Clock& m_clock;
    EventLog& m_log;
    AlarmBoard& m_alarms;
    const bool m_simulated;
    std::unique_ptr<BoxMount> m_mount;
    std::unique_ptr<BoxLine> m_line;
    Result<> m_mine;
    RotatorTalk::Proof m_proof = RotatorTalk::Proof::Unknown;  // as last reported
    bool m_closed = false;                                     // for good, or because the device is foreign
};

// The rotator of this kind behind this line.
template <class Mount>
[[nodiscard]] MountMaker rotatorBehind(std::unique_ptr<BoxLine> line, const MountStart& start)
{
    // A std::function must be copyable, and a line is not.
    return [line = std::make_shared<std::unique_ptr<BoxLine>>(std::move(line)), start](
               const profile::InForce& profile, const Clock& clock, EventLog& log, AlarmBoard& alarms) {
        return std::make_unique<BoxConnection>(std::move(*line), std::make_unique<Mount>(profile, alarms, start.axes),
                                               start.simulation != Simulation::Off, clock, log, alarms);
    };
}

}  // namespace boresight
