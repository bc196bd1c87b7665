// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/log_throttle.h"
#include "core/alarms/stream_log.h"
#include "core/control/station_control.h"
#include "core/profile/in_force.h"
#include "core/rotctld/rotator.h"

#include <optional>

// The mount for the rotctld server. Translates commands of clients into requests to StationControl, and the measured
// position into the azimuth convention of the profile. Clients see true directions only. Station thread only.
namespace boresight {

class StationRotator final : public rotctld::Rotator
{
public:
    StationRotator(StationControl& control, const profile::InForce& profile, EventLog& log, const Clock& clock);

    [[nodiscard]] std::string info() const override;
    [[nodiscard]] rotctld::Limits limits() const override;
    [[nodiscard]] Result<SkyPointing> position(const rotctld::Client& client) override;
    [[nodiscard]] Result<SkyPointing> target() const override;
    [[nodiscard]] rotctld::MotionFlags motion() const override;

    Result<QString> pointTo(const rotctld::Client& client, const rotctld::PointRequest& request) override;
    Result<> move(const rotctld::Client& client, rotctld::MoveDirection direction, int speed) override;
    Result<QString> moveAt(const rotctld::Client& client, rotctld::MoveDirection direction, AngularRate rate) override;
    Result<> stop(const rotctld::Client& client) override;
    Result<> park(const rotctld::Client& client) override;
    Result<> reset(const rotctld::Client& client, int kind) override;

    [[nodiscard]] int speedLevel() const override { return m_speedLevel; }
    Result<> setSpeedLevel(const rotctld::Client& client, int level) override;

    void clientConnected(const rotctld::Client& client) override;
    void clientGone(const rotctld::Client& client, const QString& reason) override;
    void clientRemark(const rotctld::Client& client, const QString& text) override;

private:
    [[nodiscard]] const pointing::PointingModel& model() const { return m_control.pointing(); }
    [[nodiscard]] SkyPointing inConvention(const SkyPointing& beam) const;
    [[nodiscard]] QString becameOf(const rotctld::PointRequest& request) const;
    [[nodiscard]] std::optional<AxisPosition> placeOf(const SkyPointing& continuous) const;
    Result<> ask(const rotctld::Client& client, const Request& request, const QString& command);
    Result<> turn(const rotctld::Client& client, rotctld::MoveDirection direction, AngularRate rate);
    [[nodiscard]] Result<> permitted(const rotctld::PointRequest& request) const;
    void logRefusal(const rotctld::Client& client, const QString& command, const Error& error);

    StationControl& m_control;
    const profile::InForce& m_profile;
    int m_speedLevel = 2;  // 1…4; the dummy rotator of Hamlib starts with this level
    // Limits the lines that clients can cause at will. Each kind has its own limit, so that no kind hides another.
    LogThrottle m_remarks;      // dropped clients, foreign protocols, odd commands
    LogThrottle m_refusals;     // refused commands
    LogThrottle m_commands;     // accepted commands
    StreamLog m_points;         // accepted positions of a stream
    StreamLog m_refusedPoints;  // refused positions of a stream
    LogThrottle m_connections;  // connects and disconnects
};

// The name of a client in the log and as the source of a motion.
[[nodiscard]] Source clientSource(const rotctld::Client& client);

}  // namespace boresight
