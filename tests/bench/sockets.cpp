// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/sockets.h"

#include "core/base/numbers.h"
#include "core/base/text.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <cerrno>
#include <string>

namespace boresight::bench {
namespace {

constexpr timeval kReadTimeout{.tv_sec = 5, .tv_usec = 0};

}  // namespace

Result<Endpoint> parseEndpoint(std::string_view text)
{
    const std::size_t colon = text.rfind(':');
    if (colon == std::string_view::npos) {
        return failure(ErrorCode::InvalidInput, QStringLiteral("not HOST:PORT: %1").arg(toQString(text)));
    }
    const auto port = parseInteger(text.substr(colon + 1));
    const std::string host(text.substr(0, colon));
    in_addr address{};
    if (!port || *port < 1 || *port > 65535 || inet_pton(AF_INET, host.c_str(), &address) != 1) {
        return failure(ErrorCode::InvalidInput, QStringLiteral("not HOST:PORT: %1").arg(toQString(text)));
    }
    if ((ntohl(address.s_addr) >> 24) != IN_LOOPBACKNET) {
        return failure(ErrorCode::Refused,
                       QStringLiteral("only loopback addresses are measured: %1").arg(toQString(host)));
    }
    return Endpoint{.address = address.s_addr, .port = static_cast<std::uint16_t>(*port)};
}

int openSocket(int flags)
{
    const int fd = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | flags, 0);
    const int on = 1;
    setsockopt(fd, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
    setsockopt(fd, SOL_SOCKET, SO_RCVTIMEO, &kReadTimeout, sizeof kReadTimeout);
    return fd;
}

bool connectTo(int fd, const Endpoint& endpoint)
{
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = endpoint.address;
    address.sin_port = htons(endpoint.port);
    return ::connect(fd, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0 || errno == EINPROGRESS;
}

}  // namespace boresight::bench
