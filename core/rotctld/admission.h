// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/peer_address.h"

#include <QString>

#include <cstddef>
#include <string>
#include <unordered_map>
#include <vector>

// Decides who may connect: by address, and by the number of clients that are served already, in total and from one
// host. Pure.
namespace boresight::rotctld {

class Admission
{
public:
    // Addresses and networks. Empty: everybody who reaches the port.
    explicit Admission(const std::vector<std::string>& allow) : m_allowed(allow) {}
    void setAllowed(const std::vector<std::string>& entries) { m_allowed = AllowList(entries); }

    [[nodiscard]] bool admits(const std::string& host) const { return m_allowed.admits(host); }
    // Why there is no room for another client of this host. Empty if there is room.
    [[nodiscard]] QString crowd(const std::string& host, std::size_t most) const;
    // True once, until a client leaves: the log reports only once that there is no room.
    [[nodiscard]] bool isCrowdNews();

    // A client is being served. leave(): it is not served any more.
    void enter(const std::string& host);
    void leave(const std::string& host);

private:
    AllowList m_allowed;
    std::size_t m_served = 0;
    std::unordered_map<std::string, std::size_t> m_servedOf;  // number of clients by host
    bool m_crowdTold = false;
};

}  // namespace boresight::rotctld
