// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/control/control_parts.h"
#include "core/messages/permissions.h"

// Asks the gates for every action whether the operator may request it now. Requests nothing. Computed again for each
// call. Station thread only.
namespace boresight {

class PermissionReport
{
public:
    explicit PermissionReport(const ControlParts& parts) : m_of(parts) {}

    [[nodiscard]] Permissions permissions() const;

private:
    void judgePlaces(Permissions& may) const;
    void judgeJogs(Permissions& may) const;
    void judgeDrives(Permissions& may) const;
    void judgeGains(Permissions& may) const;
    void judgeControl(Permissions& may) const;

    ControlParts m_of;
};

}  // namespace boresight
