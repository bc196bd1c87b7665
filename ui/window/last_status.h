// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/messages/station_status.h"

#include <optional>

// The last status that the station has sent, adjusted to the present time: its ages grow while the station is silent,
// actions that would use an old position are refused, and two alarms report the silence and a STOP without an answer.
// Gui thread.
namespace boresight::ui {

class LastStatus
{
public:
    // The clock outlives it.
    explicit LastStatus(const Clock& clock);

    void take(const StationStatus& status);
    [[nodiscard]] const StationStatus& received() const { return m_received; }

    // Lasts until a status shows the STOP, or it is refused.
    void stopAsked();
    void stopRefused() { m_stopSince.reset(); }

    // Whether the status looks different from when it was received.
    [[nodiscard]] bool ages() const;
    [[nodiscard]] StationStatus now() const;

private:
    const Clock& m_clock;
    StationStatus m_received;
    SteadyTime m_taken;
    std::optional<SteadyTime> m_stopSince;  // a STOP that the status does not show yet
};

}  // namespace boresight::ui
