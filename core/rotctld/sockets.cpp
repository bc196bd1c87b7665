// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotctld/sockets.h"

#include "core/base/peer_address.h"
#include "core/base/text.h"

#include <QHostAddress>

#include <arpa/inet.h>
#include <fcntl.h>
#include <linux/tcp.h>
#include <net/if.h>
#include <netdb.h>
#include <netinet/in.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <memory>

namespace boresight::rotctld {
namespace {

constexpr int kBacklog = 512;  // for many connects at once; Hamlib has 4, and the system may limit it

void setOption(int fd, int level, int name, int value)
{
    // A failure costs comfort, but not correctness.
    ::setsockopt(fd, level, name, &value, sizeof value);
}

// A client whose computer vanished is detected within ten seconds: 4 s of silence, then three probes 2 s apart. The
// same limit applies to bytes that it does not acknowledge or has no room for. A client that does not read its answers
// fills the buffers of the kernel before the server notices. By default the kernel keeps up to 4 MB for it.
void prepareClient(int fd)
{
    constexpr int kGiveUpMilliseconds = 10'000;
    constexpr int kSendBuffer = 32'768;  // bytes; Linux doubles it for its own records
    setOption(fd, IPPROTO_TCP, TCP_NODELAY, 1);
    setOption(fd, SOL_SOCKET, SO_SNDBUF, kSendBuffer);
    setOption(fd, SOL_SOCKET, SO_KEEPALIVE, 1);
    setOption(fd, IPPROTO_TCP, TCP_KEEPIDLE, 4);
    setOption(fd, IPPROTO_TCP, TCP_KEEPINTVL, 2);
    setOption(fd, IPPROTO_TCP, TCP_KEEPCNT, 3);
    setOption(fd, IPPROTO_TCP, TCP_USER_TIMEOUT, kGiveUpMilliseconds);
}

// The last descriptors are not for clients, because the journal, the log and a reopened port need them. The kernel
// always gives the lowest free number, so all numbers above it are free.
bool isNearShortage(int fd)
{
    constexpr rlim_t kReserved = 32;
    rlimit limit{};
    const Descriptor lowest(::fcntl(fd, F_DUPFD_CLOEXEC, 0));
    return !lowest.valid() ||
           (::getrlimit(RLIMIT_NOFILE, &limit) == 0 && static_cast<rlim_t>(lowest.get()) + kReserved >= limit.rlim_cur);
}

// An address of one network interface contains its name: "[fe80::1%eth0]:4533".
std::string peerText(const sockaddr_storage& address)
{
    const void* const untyped = &address;
    QHostAddress host(static_cast<const sockaddr*>(untyped));
    if (address.ss_family != AF_INET6) {
        return addressText(host, ntohs(static_cast<const sockaddr_in*>(untyped)->sin_port));
    }
    const auto* const sixth = static_cast<const sockaddr_in6*>(untyped);
    std::array<char, IF_NAMESIZE> name{};
    if (::if_indextoname(sixth->sin6_scope_id, name.data()) != nullptr) {
        host.setScopeId(QString::fromLatin1(name.data()));
    }
    return addressText(host, ntohs(sixth->sin6_port));
}

QString reason()
{
    return toQString(std::strerror(errno));
}

struct FreeAddressInfo
{
    void operator()(addrinfo* info) const { ::freeaddrinfo(info); }
};

}  // namespace

Descriptor::~Descriptor()
{
    if (valid()) {
        ::close(m_fd);
    }
}

Result<Descriptor> listenOn(const std::string& host, std::uint16_t port)
{
    const std::string where = host + ":" + std::to_string(port);
    addrinfo hints{};
    hints.ai_flags = AI_NUMERICHOST | AI_NUMERICSERV | AI_PASSIVE;
    hints.ai_socktype = SOCK_STREAM;
    addrinfo* found = nullptr;
    const std::string numeric = listenAddress(host).toString().toStdString();
    if (numeric.empty() || ::getaddrinfo(numeric.c_str(), std::to_string(port).c_str(), &hints, &found) != 0) {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("cannot listen on %1: not an IP address").arg(toQString(where)));
    }
    const std::unique_ptr<addrinfo, FreeAddressInfo> info(found);
    Descriptor socket(::socket(info->ai_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
    if (!socket.valid()) {
        return failure(ErrorCode::Io, Text::tr("cannot listen on %1: %2").arg(toQString(where), reason()));
    }
    setOption(socket.get(), SOL_SOCKET, SO_REUSEADDR, 1);
    if (info->ai_family == AF_INET6) {
        setOption(socket.get(), IPPROTO_IPV6, IPV6_V6ONLY, 0);  // "::" serves IPv4 as well
    }
    if (::bind(socket.get(), info->ai_addr, info->ai_addrlen) != 0 || ::listen(socket.get(), kBacklog) != 0) {
        const ErrorCode code = errno == EADDRINUSE ? ErrorCode::Busy
                               : errno == EACCES   ? ErrorCode::Denied
                                                   : ErrorCode::Io;
        return failure(code, Text::tr("cannot listen on %1: %2").arg(toQString(where), reason()));
    }
    return socket;
}

std::string localAddress(const Descriptor& socket)
{
    sockaddr_storage address{};
    socklen_t length = sizeof address;
    void* const untyped = &address;
    ::getsockname(socket.get(), static_cast<sockaddr*>(untyped), &length);
    return peerText(address);
}

std::uint16_t localPort(const Descriptor& socket)
{
    const std::string address = localAddress(socket);
    return static_cast<std::uint16_t>(std::stoi("0" + address.substr(address.rfind(':') + 1)));
}

tl::expected<Accepted, AcceptFailure> acceptOne(const Descriptor& listener)
{
    if (isNearShortage(listener.get())) {
        return tl::unexpected(AcceptFailure::Shortage);
    }
    sockaddr_storage address{};
    socklen_t length = sizeof address;
    void* const untyped = &address;
    Descriptor socket(
        ::accept4(listener.get(), static_cast<sockaddr*>(untyped), &length, SOCK_NONBLOCK | SOCK_CLOEXEC));
    if (!socket.valid()) {
        const bool shortage = errno == EMFILE || errno == ENFILE || errno == ENOBUFS || errno == ENOMEM;
        return tl::unexpected(shortage ? AcceptFailure::Shortage : AcceptFailure::NoneWaiting);
    }
    prepareClient(socket.get());
    return Accepted{.socket = std::move(socket), .address = peerText(address)};
}

Received receiveSome(const Descriptor& socket, char* buffer, std::size_t size)
{
    const ssize_t count = ::read(socket.get(), buffer, size);
    if (count > 0) {
        return {.bytes = {buffer, static_cast<std::size_t>(count)}, .atEnd = false, .failure = {}};
    }
    if (count == 0) {
        return {.bytes = {}, .atEnd = true, .failure = {}};
    }
    if (errno == EAGAIN || errno == EINTR) {
        return {};
    }
    if (errno == EIO && ::isatty(socket.get()) != 0) {
        return {.bytes = {}, .atEnd = true, .failure = {}};  // the program has closed the terminal
    }
    if (errno == ETIMEDOUT) {  // by the limits of prepareClient()
        return {
            .bytes = {}, .atEnd = true, .failure = Text::tr("its computer or its program did not respond for 10 s")};
    }
    return {.bytes = {}, .atEnd = true, .failure = reason()};
}

std::optional<std::size_t> sendSome(const Descriptor& socket, std::string_view bytes)
{
    ssize_t count = ::send(socket.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (count < 0 && errno == ENOTSOCK) {
        count = ::write(socket.get(), bytes.data(), bytes.size());
    }
    if (count >= 0) {
        return static_cast<std::size_t>(count);
    }
    return errno == EAGAIN || errno == EINTR ? std::optional<std::size_t>(0) : std::nullopt;
}

void endSending(const Descriptor& socket)
{
    ::shutdown(socket.get(), SHUT_WR);
}

}  // namespace boresight::rotctld
