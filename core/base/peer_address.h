// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHostAddress>

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// The host of a connection's peer, and whether the profile admits it. Addresses are numeric: no name is looked up. An
// IPv4 address that arrives over IPv6 counts as the IPv4 address. Pure.
namespace boresight {

// "127.0.0.1" for "127.0.0.1:51234", "::1" for "[::1]:51234". A path is on this computer: "127.0.0.1". A topic of a
// broker ("topic boresight/command") has no host: empty.
[[nodiscard]] std::string hostOf(std::string_view address);
// "127.0.0.1:5", "[::1]:5".
[[nodiscard]] std::string addressText(const QHostAddress& host, std::uint16_t port);
// The address on which a program listens: an IP address or "localhost". Null if neither.
[[nodiscard]] QHostAddress listenAddress(const std::string& host);
// Compares addresses, not texts: "::1" equals "0:0:0:0:0:0:0:1".
[[nodiscard]] bool sameHost(const std::string& one, const std::string& other);

// "localhost" or a loopback address. No other name is looked up.
[[nodiscard]] bool isThisComputer(const std::string& host);

// Addresses and networks ("192.168.1.7", "10.0.0.0/8", "fd00::/8"). An empty list admits every host. An invalid entry
// admits no host.
class AllowList
{
public:
    AllowList() = default;
    explicit AllowList(const std::vector<std::string>& entries);

    [[nodiscard]] bool admits(const std::string& host) const;

private:
    std::vector<std::pair<QHostAddress, int>> m_networks;  // with the number of leading bits; -1: a single address
};

}  // namespace boresight
