// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/event_log.h"
#include "core/base/result.h"
#include "core/control/arming.h"
#include "core/control/client_control.h"
#include "core/control/helm.h"
#include "core/messages/request.h"
#include "core/messages/station_status.h"

#include <cstdint>
#include <optional>

// Carries out what the operator decides about the clients: whether the clients have the control, which of them has it,
// and which may only read. The motion of a client that lost the control ends. Station thread only.
namespace boresight {

class ClientDesk
{
public:
    ClientDesk(Helm& helm, Arming& arming, ClientControl& clientControl, EventLog& log)
        : m_helm(helm), m_arming(arming), m_clientControl(clientControl), m_log(log)
    {}

    Result<> ask(const request::TakeAuthority& wanted, const Source& by);
    Result<> ask(const request::GiveAuthority& wanted, const Source& by);
    Result<> ask(const request::GiveControl& wanted, const Source& by);
    Result<> ask(const request::SetReadOnly& wanted, const Source& by);
    // Only checks whether this is permitted. The Station owns the server and disconnects the client.
    Result<> ask(const request::Disconnect& wanted, const Source& by);

    // Writes into the client's part of the status what the client may do now. `lastMotion` is when the client last
    // asked for a motion.
    void describe(ClientStatus& client, const std::optional<SteadyTime>& lastMotion) const;

private:
    void letClientsMove();
    void endClientMotion();
    void endCalibrationMotion();
    [[nodiscard]] QString controlObstacle(const ClientStatus& client) const;
    [[nodiscard]] bool isWanting(const ClientStatus& client, const std::optional<SteadyTime>& lastMotion) const;

    Helm& m_helm;
    Arming& m_arming;
    ClientControl& m_clientControl;
    EventLog& m_log;
};

}  // namespace boresight
