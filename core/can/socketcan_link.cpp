// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/can/socketcan_link.h"

#include "core/base/text.h"
#include "core/can/bit_timing.h"
#include "core/can/bus_advice.h"

#include <sys/socket.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <utility>
#include <vector>

namespace boresight {
namespace {

// The most frames that are read at once. Then the event loop continues, even on a full bus.
constexpr int kFramesPerTurn = 64;
// On a bad bus, frames and error frames alternate. The error is over when no error frame came for this time.
constexpr std::chrono::seconds kErrorMemory{1};
// In frames per second. Two drives at 100 Hz answer with 200, and a full bus carries some 8000 short ones.
constexpr int kFloodRate = 2000;
constexpr Seconds kLoadWindow{0.2};  // short enough that a flood is on the screen within 300 ms

QString systemText(int error)
{
    return QString::fromLocal8Bit(std::strerror(error));
}

// All or nothing: with one impossible frame the whole batch is refused.
Result<std::vector<socketcan::RawFrame>> rawFramesOf(std::span<const CanFrame> frames)
{
    std::vector<socketcan::RawFrame> rawFrames;
    for (const CanFrame& frame : frames) {
        const auto raw = socketcan::toRaw(frame);
        if (!raw) {
            return tl::unexpected(raw.error());
        }
        rawFrames.push_back(*raw);
    }
    return rawFrames;
}

}  // namespace

SocketCanLink::SocketCanLink(QString interface, const Clock& clock, QObject* parent)
    : SocketCanLink(interface, std::make_unique<socketcan::KernelCanInterface>(interface), clock, parent)
{}

SocketCanLink::SocketCanLink(QString interface, std::unique_ptr<socketcan::CanInterface> access, const Clock& clock,
                             QObject* parent)
    : CanLink(parent), m_interface(std::move(interface)), m_access(access.release()), m_clock(clock)
{
    m_access->setParent(this);
    connect(m_access, &socketcan::CanInterface::changed, this, &SocketCanLink::checkInterface);
}

SocketCanLink::~SocketCanLink() = default;

QString SocketCanLink::name() const
{
    return QStringLiteral("socketcan:") + m_interface;
}

Result<> SocketCanLink::open()
{
    close();
    auto socket = m_access->openSocket();
    if (!socket) {
        return tl::unexpected(socket.error());
    }
    m_socket = *std::move(socket);
    m_socketDrops = 0;
    m_loadSince = m_clock.now();
    m_loadFrames = 0;
    m_trouble = {};
    m_notifier = std::make_unique<QSocketNotifier>(m_socket.number(), QSocketNotifier::Read);
    connect(m_notifier.get(), &QSocketNotifier::activated, this, &SocketCanLink::readSocket);
    checkInterface();
    if (!m_socket.isOpen()) {  // removed in the meantime
        return failure(ErrorCode::NoDevice, m_status.text);
    }
    return {};
}

void SocketCanLink::close()
{
    closeSocket();
    setStatus(LinkState::Closed, {});
}

// May run inside the signal of the notifier. The next open() may get the same socket number.
void SocketCanLink::closeSocket()
{
    if (m_notifier) {
        m_notifier->setEnabled(false);
        m_notifier.release()->deleteLater();
    }
    m_socket.reset();
}

Result<> SocketCanLink::send(std::span<const CanFrame> frames)
{
    if (!m_socket.isOpen()) {
        const QString text = m_status.text.isEmpty() ? Text::tr("%1 is not open").arg(name()) : m_status.text;
        return failure(ErrorCode::NoDevice, text);
    }
    const auto rawFrames = rawFramesOf(frames);
    if (!rawFrames) {
        return tl::unexpected(rawFrames.error());
    }
    for (const auto& raw : *rawFrames) {
        if (::send(m_socket.number(), &raw.frame, raw.size, MSG_NOSIGNAL) < 0) {
            const int error = errno;
            handleSocketError(error);
            const QString reason = m_status.text.isEmpty() ? systemText(error) : m_status.text;
            return failure(
                ErrorCode::Io,
                Text::tr("%1 (%2 of %3 frames sent)").arg(reason).arg(&raw - rawFrames->data()).arg(frames.size()));
        }
        ++m_status.sent;
    }
    m_trouble.transmitQueueFull = false;
    m_trouble.interfaceDown = false;
    updateStatus();
    return {};
}

void SocketCanLink::readSocket()
{
    for (int i = 0; i < kFramesPerTurn && m_socket.isOpen(); ++i) {
        socketcan::RawFrame raw;
        const ssize_t size = readFrame(raw);
        if (size < 0 && (errno == EAGAIN || errno == EINTR)) {
            return;
        }
        if (size <= 0) {
            handleSocketError(size == 0 ? ENODEV : errno);
            return;
        }
        raw.size = static_cast<std::size_t>(size);
        if (socketcan::isErrorFrame(raw)) {
            handleErrorFrame(raw);
        } else if (const auto frame = socketcan::fromRaw(raw)) {
            handleFrame(*frame);
        }
    }
}

// Reads one frame, and the kernel's count of frames for which it had no room (SO_RXQ_OVFL).
ssize_t SocketCanLink::readFrame(socketcan::RawFrame& raw)
{
    iovec buffer{.iov_base = &raw.frame, .iov_len = sizeof raw.frame};
    alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(std::uint32_t))> control{};
    msghdr message{};
    message.msg_iov = &buffer;
    message.msg_iovlen = 1;
    message.msg_control = control.data();
    message.msg_controllen = control.size();
    const ssize_t size = recvmsg(m_socket.number(), &message, 0);
    if (size < 0) {
        return size;
    }
    for (cmsghdr* item = CMSG_FIRSTHDR(&message); item != nullptr; item = CMSG_NXTHDR(&message, item)) {
        if (item->cmsg_level == SOL_SOCKET && item->cmsg_type == SO_RXQ_OVFL) {
            std::uint32_t drops = 0;
            std::memcpy(&drops, CMSG_DATA(item), sizeof drops);
            m_status.dropped += drops - std::exchange(m_socketDrops, drops);
        }
    }
    return size;
}

// A received frame shows that the bus works again, which the kernel does not always report.
void SocketCanLink::handleFrame(const CanFrame& frame)
{
    CanFrame stamped = frame;
    stamped.received = m_clock.now();
    ++m_status.received;
    m_trouble.busOff = false;
    m_trouble.errorPassive = false;
    m_trouble.noAcknowledge = false;
    countLoad(stamped.received);
    m_trouble.errorFrames = m_trouble.errorFrames && stamped.received - m_lastErrorFrame < kErrorMemory;
    updateStatus();
    Q_EMIT frameReceived(stamped);
}

// Reported above the rate, and cleared below half of it. So the text does not flicker.
void SocketCanLink::countLoad(SteadyTime now)
{
    ++m_loadFrames;
    const Seconds window = now - m_loadSince;
    if (window < kLoadWindow) {
        return;
    }
    const double rate = m_loadFrames / window.count();
    m_trouble.flooded = rate > (m_trouble.flooded ? kFloodRate / 2 : kFloodRate);
    m_loadSince = now;
    m_loadFrames = 0;
}

void SocketCanLink::handleErrorFrame(const socketcan::RawFrame& raw)
{
    const socketcan::ErrorReport report = socketcan::readErrorFrame(raw);
    m_status.dropped += report.receiveOverflow ? 1 : 0;
    if (report.restarted || report.errorActive) {
        m_trouble.busOff = false;
        m_trouble.errorPassive = false;
    } else {
        ++m_status.busErrors;
    }
    m_trouble.busOff = m_trouble.busOff || report.busOff;
    m_trouble.errorPassive = m_trouble.errorPassive || report.errorPassive;
    m_trouble.noAcknowledge = m_trouble.noAcknowledge || report.noAcknowledge;
    if (report.busError) {
        m_trouble.errorFrames = true;
        m_lastErrorFrame = m_clock.now();
    }
    updateStatus();
}

void SocketCanLink::handleSocketError(int error)
{
    switch (error) {
        // A socket keeps this error until it is read, even if the interface is up again.
        case ENETDOWN:
            checkInterface();
            break;
        case ENOBUFS:
        case EAGAIN:
            m_trouble.transmitQueueFull = true;
            updateStatus();
            break;
        case ENODEV:
        case ENXIO:
            lose(Text::tr("the interface was removed. Plug the adapter in again"));
            break;
        default:
            lose(systemText(error));
            break;
    }
}

void SocketCanLink::checkInterface()
{
    if (!m_socket.isOpen()) {
        return;
    }
    const socketcan::InterfaceState state = m_access->state();
    if (state == socketcan::InterfaceState::Absent) {
        handleSocketError(ENODEV);
        return;
    }
    if (state == socketcan::InterfaceState::Down) {
        m_trouble = {};  // these belong to the controller, which restarts with the interface
    }
    m_trouble.interfaceDown = state == socketcan::InterfaceState::Down;
    const std::optional<socketcan::InterfaceReport> report = m_access->report();
    m_isVirtual = report ? report->kind != "can" : socketcan::looksVirtual(m_interface);
    m_timingTrouble = report ? socketcan::timingTrouble(*report) : QString();
    if (report && report->controller) {
        follow(*report->controller);
    }
    updateStatus();
}

// Reads the state of the controller, which may have changed before we opened, or while its error frames were lost.
void SocketCanLink::follow(socketcan::ControllerState controller)
{
    m_trouble.busOff = controller == socketcan::ControllerState::BusOff;
    m_trouble.errorPassive = controller == socketcan::ControllerState::Passive;
}

void SocketCanLink::lose(const QString& reason)
{
    closeSocket();
    setStatus(LinkState::Lost, reason);
}

// The worst trouble first. Wrong bit timing comes last, but together with a trouble that it may have caused.
QString SocketCanLink::troubleText() const
{
    if (m_trouble.interfaceDown) {
        return Text::tr("the interface is down. Bring it up with `%1`")
            .arg(socketcan::bringUpCommand(m_interface, m_isVirtual));
    }
    QStringList troubles;
    if (m_trouble.busOff) {
        troubles
            << Text::tr(
                   "bus-off after too many errors: check the cable, the 120 ohm at both ends and the bit rate. With "
                   "restart-ms set the bus comes back by itself. Otherwise enter `ip link set %1 type can restart`")
                   .arg(m_interface);
    } else if (m_trouble.transmitQueueFull) {
        troubles
            << Text::tr("the transmit queue is full: another program fills the bus, or %1").arg(acknowledgeAdvice());
    } else if (m_trouble.noAcknowledge) {
        troubles << acknowledgeAdvice();
    } else if (m_trouble.errorPassive) {
        troubles << Text::tr("many errors on the bus (error-passive): %1").arg(errorAdvice());
    } else if (m_trouble.errorFrames) {
        troubles << Text::tr("damaged frames on the bus: %1").arg(errorAdvice());
    } else if (m_trouble.flooded) {
        troubles << Text::tr(
                        "more than %1 frames a second on the bus, ten times what two drives need. Another program "
                        "floods the bus. End that program (`candump %2` shows its identifiers)")
                        .arg(kFloodRate)
                        .arg(m_interface);
    }
    if (!m_timingTrouble.isEmpty()) {
        troubles << m_timingTrouble;
    }
    return troubles.join(QLatin1String("; "));
}

void SocketCanLink::updateStatus()
{
    const bool down = m_trouble.interfaceDown || m_trouble.busOff;
    setStatus(down ? LinkState::Down : LinkState::Up, troubleText());
}

void SocketCanLink::setStatus(LinkState state, const QString& trouble)
{
    const QString text = trouble.isEmpty() ? QString() : name() + QStringLiteral(": ") + trouble;
    if (m_status.state != state || m_status.text != text) {
        m_status.state = state;
        m_status.text = text;
        Q_EMIT statusChanged(m_status);
    }
}

}  // namespace boresight

#include "moc_socketcan_link.cpp"
