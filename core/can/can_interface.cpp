// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/can/can_interface.h"

#include "core/base/text.h"
#include "core/can/bit_timing.h"

#include <QFile>
#include <QLoggingCategory>

#include <linux/can.h>
#include <linux/can/error.h>
#include <linux/can/raw.h>
#include <linux/rtnetlink.h>
#include <net/if.h>
#include <net/if_arp.h>
#include <sys/ioctl.h>
#include <sys/socket.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <span>
#include <vector>

namespace boresight::socketcan {
namespace {

Q_LOGGING_CATEGORY(lcInterface, "boresight.can.socketcan")

// Room for 1300 frames (the kernel counts about 800 bytes for each).
constexpr int kReceiveBuffer = 1 << 20;

template <class Value>
bool setOption(const FileDescriptor& socket, int level, int name, const Value& value)
{
    return setsockopt(socket.number(), level, name, &value, sizeof value) == 0;
}

Result<> configure(const FileDescriptor& socket)
{
    constexpr int kOn = 1;
    constexpr can_err_mask_t kAllErrors = CAN_ERR_MASK;
    if (!setOption(socket, SOL_CAN_RAW, CAN_RAW_FD_FRAMES, kOn)) {
        return failure(ErrorCode::NotAvailable, Text::tr("this kernel's SocketCAN has no CAN-FD"));
    }
    // The bus works without the following options. They only improve the diagnosis.
    setOption(socket, SOL_CAN_RAW, CAN_RAW_ERR_FILTER, kAllErrors);
    setOption(socket, SOL_SOCKET, SO_RXQ_OVFL, kOn);
    if (!setOption(socket, SOL_SOCKET, SO_RCVBUFFORCE, kReceiveBuffer)) {
        setOption(socket, SOL_SOCKET, SO_RCVBUF, kReceiveBuffer);
    }
    return {};
}

ifreq requestFor(const QString& name)
{
    ifreq request{};
    const QByteArray bytes = QFile::encodeName(name);
    std::strncpy(request.ifr_name, bytes.constData(), IFNAMSIZ - 1);
    return request;
}

// Reads the kernel's list. A direct query for an unknown name would make the kernel look for a module, for 70 ms or
// more.
int indexOf(const std::string& name)
{
    const std::unique_ptr<struct if_nameindex, void (*)(struct if_nameindex*)> all(if_nameindex(), if_freenameindex);
    for (const struct if_nameindex* entry = all.get(); entry != nullptr && entry->if_index != 0; ++entry) {
        if (name == entry->if_name) {
            return static_cast<int>(entry->if_index);
        }
    }
    return 0;
}

QString systemError(const QString& name)
{
    return QStringLiteral("%1: %2").arg(name, toQString(std::strerror(errno)));
}

}  // namespace

Result<FileDescriptor> KernelCanInterface::openSocket()
{
    FileDescriptor socket(::socket(PF_CAN, SOCK_RAW | SOCK_NONBLOCK | SOCK_CLOEXEC, CAN_RAW));
    if (!socket.isOpen()) {
        if (errno == EAFNOSUPPORT || errno == EPROTONOSUPPORT) {
            return failure(ErrorCode::NotAvailable,
                           Text::tr("this kernel has no SocketCAN. Load it with `modprobe can-raw`, or use the adapter "
                                    "as a serial port with --bus fdcanusb:PATH"));
        }
        return failure(ErrorCode::Io, systemError(QStringLiteral("CAN socket")));
    }
    if (const auto found = findInterface(socket.number()); !found) {
        return tl::unexpected(found.error());
    }
    if (const auto configured = configure(socket); !configured) {
        return tl::unexpected(configured.error());
    }
    watchChanges();  // before bind, so that no change is missed
    sockaddr_can address{};
    address.can_family = AF_CAN;
    address.can_ifindex = m_index;
    if (bind(socket.number(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
        return failure(ErrorCode::NoDevice, systemError(m_name));
    }
    return socket;
}

Result<> KernelCanInterface::findInterface(int socket)
{
    m_index = indexOf(m_name.toStdString());
    if (m_index == 0) {
        return failure(ErrorCode::NoDevice, Text::tr("there is no interface %1. Is the adapter plugged in and its "
                                                     "driver loaded? `ip -brief link` shows the interfaces")
                                                .arg(m_name));
    }
    ifreq request = requestFor(m_name);
    if (ioctl(socket, SIOCGIFHWADDR, &request) != 0 || request.ifr_hwaddr.sa_family != ARPHRD_CAN) {
        return failure(ErrorCode::InvalidInput, Text::tr("%1 is not a CAN interface").arg(m_name));
    }
    const std::optional<InterfaceReport> known = report();
    const bool isVirtual = known ? known->kind != "can" : looksVirtual(m_name);
    if (ioctl(socket, SIOCGIFMTU, &request) != 0 || request.ifr_mtu < static_cast<int>(CANFD_MTU)) {
        return failure(ErrorCode::NotAvailable,
                       Text::tr("%1 is not a CAN-FD interface (mtu %2): `ip link set %1 down`, then `%3`")
                           .arg(m_name, QString::number(request.ifr_mtu), bringUpCommand(m_name, isVirtual)));
    }
    return {};
}

// Queried by its index, because the name may be gone.
InterfaceState KernelCanInterface::state() const
{
    const FileDescriptor socket(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0));
    ifreq request{};
    request.ifr_ifindex = m_index;
    if (ioctl(socket.number(), SIOCGIFNAME, &request) != 0 || QFile::decodeName(request.ifr_name) != m_name) {
        return InterfaceState::Absent;
    }
    if (ioctl(socket.number(), SIOCGIFFLAGS, &request) != 0) {
        return InterfaceState::Absent;
    }
    return (request.ifr_flags & IFF_UP) != 0 ? InterfaceState::Up : InterfaceState::Down;
}

// The kernel answers this query before send() returns, so nothing waits.
std::optional<InterfaceReport> KernelCanInterface::report() const
{
    const FileDescriptor socket(::socket(AF_NETLINK, SOCK_RAW | SOCK_NONBLOCK | SOCK_CLOEXEC, NETLINK_ROUTE));
    const std::vector<std::uint8_t> question = interfaceQuestion(m_index, 1);
    std::array<std::uint8_t, 16384> answer{};
    if (::send(socket.number(), question.data(), question.size(), 0) < 0) {
        return std::nullopt;
    }
    const ssize_t size = recv(socket.number(), answer.data(), answer.size(), 0);
    if (size < 0) {
        return std::nullopt;
    }
    const auto report = readInterfaceAnswer(std::span(answer).first(static_cast<std::size_t>(size)));
    if (!report) {
        qCDebug(lcInterface) << m_name << qUtf8Printable(report.error().text);
        return std::nullopt;
    }
    return *report;
}

void KernelCanInterface::watchChanges()
{
    if (m_changes.isOpen()) {
        return;
    }
    FileDescriptor changes(::socket(AF_NETLINK, SOCK_RAW | SOCK_NONBLOCK | SOCK_CLOEXEC, NETLINK_ROUTE));
    sockaddr_nl address{};
    address.nl_family = AF_NETLINK;
    address.nl_groups = RTMGRP_LINK;
    if (bind(changes.number(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
        qCWarning(lcInterface) << "changes of" << m_name << "are noticed only when sending:" << std::strerror(errno);
        return;
    }
    m_changes = std::move(changes);
    m_changesNotifier = std::make_unique<QSocketNotifier>(m_changes.number(), QSocketNotifier::Read);
    connect(m_changesNotifier.get(), &QSocketNotifier::activated, this, &KernelCanInterface::readChanges);
}

// The messages themselves are dropped. The state that is queried afterwards is never out of date.
void KernelCanInterface::readChanges()
{
    std::array<char, 8192> message{};
    ssize_t size = 0;
    do {
        size = recv(m_changes.number(), message.data(), message.size(), 0);
    } while (size > 0 || (size < 0 && (errno == EINTR || errno == ENOBUFS)));
    Q_EMIT changed();
}

}  // namespace boresight::socketcan

#include "moc_can_interface.cpp"
