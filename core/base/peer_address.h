// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHostAddress>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

// Whose connection it is: the host of a peer, and whether the profile lets it in. Addresses are numbers, nothing is
// looked up, and an IPv4 address that came over IPv6 is the IPv4 address. Pure.
namespace boresight {

// "127.0.0.1" of "127.0.0.1:51234", "::1" of "[::1]:51234". A path is a place of this computer: "127.0.0.1".
[[nodiscard]] std::string hostOf(std::string_view address);
// However they are written: "::1" and "0:0:0:0:0:0:0:1".
[[nodiscard]] bool sameHost(const std::string& one, const std::string& other);

// "localhost" or a loopback address. Another name is not looked up.
[[nodiscard]] bool isThisComputer(const std::string& host);

// Addresses and networks ("192.168.1.7", "10.0.0.0/8", "fd00::/8"); an empty list admits everybody, an entry that is
// neither admits nobody.
class AllowList
{
public:
    AllowList() = default;
    explicit AllowList(const std::vector<std::string>& entries);

    [[nodiscard]] bool admits(const std::string& host) const;

private:
    std::vector<std::pair<QHostAddress, int>> m_networks;  // with the number of leading bits, or -1
};

}  // namespace boresight
