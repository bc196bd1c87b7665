// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/peer_address.h"

#include <QString>

#include <cstddef>
#include <string>
#include <unordered_map>
#include <vector>

// Who may connect: by address, and by how many are served already, in all and of one host. Pure.
namespace boresight::rotctld {

class Admission
{
public:
    // Addresses and networks; empty: whoever can reach the port.
    explicit Admission(const std::vector<std::string>& allow) : m_allowed(allow) {}
    void setAllowed(const std::vector<std::string>& entries) { m_allowed = AllowList(entries); }

    [[nodiscard]] bool admits(const std::string& host) const { return m_allowed.admits(host); }
    // Why there is no room for one more client of this host; empty: there is.
    [[nodiscard]] QString crowd(const std::string& host, std::size_t most) const;
    // The log says once that there is no room, until a client leaves.
    [[nodiscard]] bool isCrowdNews();

    // A client is served; it is no more.
    void enter(const std::string& host);
    void leave(const std::string& host);

private:
    AllowList m_allowed;
    std::size_t m_served = 0;
    std::unordered_map<std::string, std::size_t> m_servedOf;  // the same by host
    bool m_crowdTold = false;
};

}  // namespace boresight::rotctld
