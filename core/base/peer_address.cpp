// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/peer_address.h"

#include <QString>

#include <algorithm>

namespace boresight {
namespace {

QHostAddress plain(const std::string& host)
{
    const QHostAddress address(QString::fromStdString(host));
    bool mapped = false;
    const quint32 fourth = address.toIPv4Address(&mapped);
    return mapped ? QHostAddress(fourth) : address;
}

}  // namespace

std::string hostOf(std::string_view address)
{
    if (address.starts_with('/')) {
        return "127.0.0.1";
    }
    if (address.find(' ') != std::string_view::npos) {
        return {};
    }
    std::string_view host = address.substr(0, address.rfind(':'));
    if (host.starts_with('[') && host.ends_with(']')) {
        host = host.substr(1, host.size() - 2);
    }
    return std::string(host);
}

bool sameHost(const std::string& one, const std::string& other)
{
    const QHostAddress first = plain(one);
    return !first.isNull() && first == plain(other);
}

bool isThisComputer(const std::string& host)
{
    return host == "localhost" || plain(host).isLoopback();
}

AllowList::AllowList(const std::vector<std::string>& entries)
{
    for (const std::string& entry : entries) {
        // An entry without a slash is a single address. parseSubnet() would read an incomplete address as a network.
        m_networks.push_back(entry.find('/') == std::string::npos
                                 ? std::pair(plain(entry), -1)
                                 : QHostAddress::parseSubnet(QString::fromStdString(entry)));
    }
}

bool AllowList::admits(const std::string& host) const
{
    const QHostAddress address = plain(host);
    return m_networks.empty() || std::ranges::any_of(m_networks, [&](const auto& network) {
               return !network.first.isNull() &&
                      (network.second < 0 ? address == network.first
                                          : address.isInSubnet(network.first, network.second));
           });
}

}  // namespace boresight
