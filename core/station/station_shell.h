// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/log_throttle.h"
#include "core/local_socket/local_server.h"
#include "core/messages/request.h"
#include "core/messages/station_status.h"

#include <cstdint>
#include <functional>
#include <optional>

// The local socket as the station uses it: translates the commands of the shell into requests of the operator. Station
// thread only.
namespace boresight {

class StationShell
{
public:
    using Ask = std::function<Result<>(const Request&, const Source&)>;

    // Log and clock outlive this.
    StationShell(Ask ask, EventLog& log, const Clock& clock, QObject* parent);

    // Where the user's sockets are, as core/local_socket reports it. Without this there is no socket, and no line in
    // the log about it.
    void setRuntimeFolder(const QString& folder) { m_runtimeFolder = folder; }

    // The socket of the station whose rotctld server has this port. That it does not open is a line of the log.
    void open(std::uint16_t port);
    void close() { m_server.close(); }

private:
    [[nodiscard]] Result<> obey(local::LocalCommand command);

    Ask m_ask;
    LogThrottle m_lines;
    local::LocalServer m_server;
    std::optional<QString> m_runtimeFolder;
};

}  // namespace boresight
