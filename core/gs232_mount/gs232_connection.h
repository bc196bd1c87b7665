// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_board.h"
#include "core/gs232_mount/box_line.h"
#include "core/gs232_mount/gs232_mount.h"
#include "core/mount/mount_connection.h"
#include "core/mount/mount_kind.h"

#include <memory>

// A GS-232 rotator with its line. A line whose other end is not such a box is closed, and stays so until the operator
// reconnects. Station thread only.
namespace boresight::gs232 {

class Gs232Connection final : public MountConnection
{
    Q_OBJECT

public:
    Gs232Connection(std::unique_ptr<BoxLine> line, const MountStart& start, const profile::InForce& profile,
                    const Clock& clock, EventLog& log, AlarmBoard& alarms);
    ~Gs232Connection() override;

    [[nodiscard]] MountDriver& driver() override { return m_mount; }
    [[nodiscard]] const MountDriver& driver() const override { return m_mount; }
    [[nodiscard]] bool simulated() const override { return m_simulated; }
    [[nodiscard]] const Result<>& mine() const override { return m_mine; }
    void open() override;
    void close() override;
    void send() override;
    [[nodiscard]] Result<> admits(const Request& /*request*/) const override { return {}; }
    [[nodiscard]] Result<> carryOut(const Request& /*request*/) override { return {}; }
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
    Gs232Mount m_mount;
    std::unique_ptr<BoxLine> m_line;
    Result<> m_mine;
    Proof m_proof = Proof::Unknown;  // as reported
    bool m_closed = false;           // for good, or left alone
};

// A simulated one stays the same one when the mount is connected again.
[[nodiscard]] MountKind gs232Rotators();
// The rotator behind this line.
[[nodiscard]] MountMaker gs232Rotator(std::unique_ptr<BoxLine> line, const MountStart& start);

}  // namespace boresight::gs232
