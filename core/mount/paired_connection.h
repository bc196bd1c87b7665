// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mount/mount_connection.h"
#include "core/mount/paired_mount.h"

#include <memory>

// Two mounts as one: the azimuth of the first and the elevation of the second, each with its own line. Station thread
// only.
namespace boresight {

class PairedConnection final : public MountConnection
{
    Q_OBJECT

public:
    // Neither of them may have the axis of the other.
    PairedConnection(std::unique_ptr<MountConnection> azimuth, std::unique_ptr<MountConnection> elevation);
    ~PairedConnection() override;

    [[nodiscard]] MountDriver& driver() override { return m_mount; }
    [[nodiscard]] const MountDriver& driver() const override { return m_mount; }
    [[nodiscard]] bool simulated() const override { return m_azimuth->simulated() && m_elevation->simulated(); }
    [[nodiscard]] const Result<>& mine() const override;
    void open() override;
    void close() override;
    void send() override;
    [[nodiscard]] Result<> admits(const Request& request) const override;
    [[nodiscard]] Result<> carryOut(const Request& request) override;
    void profileChanged(const profile::Profile& before, const profile::Profile& after) override;
    void setCourse(const std::optional<SensorCourse>& course) override;
    // The first of the two that can read it.
    [[nodiscard]] contacts::InputReading pin(const contacts::BoardPin& pin) const override;
    [[nodiscard]] std::unique_ptr<outputs::Output> pinOutput(const contacts::BoardPin& pin) override;
    // Shows one of the two lines: the one with a problem.
    void describe(StationStatus& status) const override;

private:
    std::unique_ptr<MountConnection> m_azimuth;
    std::unique_ptr<MountConnection> m_elevation;
    PairedMount m_mount;
};

[[nodiscard]] MountMaker pairOf(const MountMaker& azimuth, const MountMaker& elevation);

}  // namespace boresight
