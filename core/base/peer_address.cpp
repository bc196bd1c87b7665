// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/peer_address.h"

#include <QString>

#include <algorithm>

namespace boresight {
namespace {

QHostAddress plain(const QHostAddress& address)
{
    bool mapped = false;
    const quint32 fourth = address.toIPv4Address(&mapped);
    return mapped ? QHostAddress(fourth) : address;
}

QHostAddress plain(const std::string& host)
{
    return plain(QHostAddress(QString::fromStdString(host)));
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

std::string addressText(const QHostAddress& host, std::uint16_t port)
{
    const QHostAddress own = plain(host);
    const std::string text = own.toString().toStdString();
    return (own.protocol() == QAbstractSocket::IPv6Protocol ? "[" + text + "]" : text) + ":" + std::to_string(port);
}

QHostAddress listenAddress(const std::string& host)
{
    return host == "localhost" ? QHostAddress(QHostAddress::LocalHost) : QHostAddress(QString::fromStdString(host));
}

bool sameHost(const std::string& one, const std::string& other)
{
    const QHostAddress first = plain(one);
    return !first.isNull() && first == plain(other);
}

bool isThisComputer(const std::string& host)
{
    return plain(listenAddress(host)).isLoopback();
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
