// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mount/mount_connection.h"
#include "core/mount/mount_kind.h"
#include "core/simple_mount/simple_mount.h"

#include <memory>

// The simple simulated rotator with its box. The box is always there and needs no line. Station thread only.
namespace boresight {

class SimpleConnection final : public MountConnection
{
    Q_OBJECT

public:
    SimpleConnection(std::shared_ptr<SimpleBox> box, const SimpleMount::Axes& axes);

    [[nodiscard]] MountDriver& driver() override { return m_mount; }
    [[nodiscard]] const MountDriver& driver() const override { return m_mount; }
    [[nodiscard]] bool simulated() const override { return true; }
    [[nodiscard]] const Result<>& mine() const override { return m_mine; }
    void open() override {}
    void close() override {}
    void send() override { m_mount.send(); }
    [[nodiscard]] Result<> admits(const Request& /*request*/) const override { return {}; }
    [[nodiscard]] Result<> carryOut(const Request& /*request*/) override { return {}; }
    void profileChanged(const profile::Profile& /*before*/, const profile::Profile& /*after*/) override {}
    void setCourse(const std::optional<SensorCourse>& /*course*/) override {}
    void describe(StationStatus& status) const override;

private:
    std::shared_ptr<SimpleBox> m_box;
    SimpleMount m_mount;
    Result<> m_mine;
};

// The box stays the same when the mount is connected again.
[[nodiscard]] MountKind simpleRotators();

}  // namespace boresight
