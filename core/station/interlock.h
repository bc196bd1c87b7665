// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/station/station_status.h"

#include <QString>

#include <optional>

// Who may start motion now, and why not: the STOP latch, the fault latch and the authority. Decides nothing else.
namespace boresight {

class Interlock
{
public:
    // Nothing moves until reset; a STOP of the operator also takes the authority.
    void latchStop();
    Result<> resetStop();
    [[nodiscard]] bool stopLatched() const { return m_stopLatched; }

    // `reason` in words: "azimuth drive: over temperature (38)". The first reason of a series stays.
    void latchFault(const QString& reason);
    void clearFault() { m_fault.reset(); }
    [[nodiscard]] const std::optional<QString>& fault() const { return m_fault; }

    void setAuthority(Authority authority) { m_authority = authority; }
    [[nodiscard]] Authority authority() const { return m_authority; }

    // May this source clear a drive's fault or time-out? Not a client while the operator has taken over.
    [[nodiscard]] Result<> admitsRearm(const Source& source) const;
    // May this source start motion? The error says what stands in the way and what to do.
    [[nodiscard]] Result<> admits(const Source& source) const;

private:
    bool m_stopLatched = false;
    std::optional<QString> m_fault;
    Authority m_authority = Authority::Clients;
};

}  // namespace boresight
