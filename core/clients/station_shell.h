// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/log_throttle.h"
#include "core/elements/element_set.h"
#include "core/inputs/station_follow.h"
#include "core/inputs/station_tables.h"
#include "core/local_socket/local_server.h"
#include "core/messages/protocol_line.h"
#include "core/messages/request.h"
#include "core/messages/station_status.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

// Serves the local socket: translates commands of the shell into requests of the operator, and answers its questions.
// The shell may track a target when a client of this computer may move the mount, or when the operator has control.
// Station thread only.
namespace boresight {

class StationShell
{
public:
    struct Station
    {
        std::function<Result<>(const Request&, const Source&)> ask;
        std::function<Result<>()> mayShellCommand;
        std::function<void(const QString& path, StationTables::Then then)> readTable;
        std::function<void(const QString& name, StationFollow::Then then)> findRotator;
        std::function<std::shared_ptr<const std::vector<orbit::ElementSet>>()> satellites;
        std::function<std::vector<local::KnownAntenna>()> antennas;
        std::function<std::shared_ptr<const ScheduleStatus>()> schedule;
        std::function<RehearsalStatus()> rehearsal;
        std::function<StationStatus()> status;
        std::function<TransmitStatus()> transmit;
        // The oldest lines of the protocol log after a number, at most `limit` of them.
        std::function<ProtocolLines(std::uint64_t after, std::size_t limit)> protocolLines;
        std::function<Result<QString>(const QByteArray& text)> simulate;
    };

    // Log and clock outlive this.
    StationShell(Station station, EventLog& log, const Clock& clock, QObject* parent);

    // The folder of the user's sockets, as core/local_socket reports it. Without this call there is no socket and no
    // line about it in the log.
    void setRuntimeFolder(const QString& folder) { m_runtimeFolder = folder; }

    // The name of the socket contains the port of the rotctld server. A socket that does not open is a line in the log.
    void open(std::uint16_t port);
    void close() { m_server.close(); }

private:
    void obey(const local::LocalRequest& asked, const local::Reply& reply);
    [[nodiscard]] local::LocalAnswer answerNow(const local::LocalRequest& asked);
    [[nodiscard]] Result<> mayTrack() const;
    void track(const QByteArray& text, const local::Reply& reply);
    [[nodiscard]] local::LocalAnswer track(const targets::Target& target);
    [[nodiscard]] local::LocalAnswer follow(const QString& rotator);
    [[nodiscard]] local::LocalAnswer simulate(const QByteArray& text);
    [[nodiscard]] local::LocalAnswer told(const local::LocalRequest& asked, local::LocalAnswer answer);
    [[nodiscard]] QByteArray satelliteLines() const;
    [[nodiscard]] QByteArray antennaLines() const;
    [[nodiscard]] local::LocalAnswer protocolLines(const QByteArray& after) const;

    Station m_station;
    LogThrottle m_lines;
    local::LocalServer m_server;
    std::optional<QString> m_runtimeFolder;
};

}  // namespace boresight
