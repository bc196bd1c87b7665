// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_board.h"
#include "core/alarms/event_log.h"
#include "core/control/helm.h"
#include "core/guards/brake_guard.h"
#include "core/guards/wind_guard.h"
#include "core/messages/request.h"

// Carries out what the operator decides about the control itself: trim, cable end, antenna, wind, alarms, another
// profile. None of this begins a motion. Station thread only.
namespace boresight {

class OperatorDesk
{
public:
    struct Parts
    {
        Helm& helm;
        AntennaChoice& antenna;
        WindGuard& wind;
        const BrakeGuard& brake;
        const Clock& clock;
        AlarmBoard& alarms;
        EventLog& log;
    };

    explicit OperatorDesk(const Parts& parts) : m_of(parts) {}

    Result<> ask(const request::ClearTrim& wanted, const Source& by);
    Result<> ask(const request::HoldAtEnd& wanted, const Source& by);
    Result<> ask(const request::UseAntenna& wanted, const Source& by);
    Result<> ask(const request::OverrideWind& wanted, const Source& by);
    Result<> ask(const request::AcknowledgeAlarms& wanted, const Source& by);
    Result<> ask(const request::AcknowledgeAlarm& wanted, const Source& by);
    // These two only judge the profile. The Station applies it and calls profileChanged(), or reconnects.
    Result<> ask(const request::ApplyProfile& wanted, const Source& by);
    Result<> ask(const request::Reconnect& wanted, const Source& by);

private:
    [[nodiscard]] Gates gates() const { return Gates(m_of.helm.view()); }

    Parts m_of;
};

}  // namespace boresight
