// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/can/fdcanusb_link.h"

#include "core/base/control_characters.h"
#include "core/base/text.h"
#include "core/can/adapter_port.h"
#include "core/can/bus_advice.h"
#include "core/can/line_checksum.h"
#include "core/serial/port_claim.h"
#include "core/serial/port_holder.h"
#include "core/serial/serial_port_check.h"

#include <QLoggingCategory>

#include <poll.h>
#include <sys/ioctl.h>

#include <string>
#include <utility>
#include <vector>

namespace boresight {
namespace {

Q_LOGGING_CATEGORY(lcFdcanusb, "boresight.can.fdcanusb")

// Has no effect on USB. The UART of a moteus has this speed.
constexpr qint32 kBaudRate = 921600;
// The data of twenty exchanges with two axes. An adapter that accepts no data for that long is stuck.
constexpr qint64 kMaxUnwritten = 8192;

// QSerialPort::flush() treats a full device as a broken one (EAGAIN becomes ResourceError), so check before.
bool isWritable(int descriptor)
{
    pollfd request{.fd = descriptor, .events = POLLOUT, .revents = 0};
    return poll(&request, 1, 0) == 1 && (request.revents & POLLOUT) != 0;
}

// Unread data exists: a stall of this program must not count as silence of the adapter.
bool hasUnread(int descriptor)
{
    int waiting = 0;
    return ioctl(descriptor, FIONREAD, &waiting) == 0 && waiting > 0;
}

QString inUse(const QString& device, const QString& holder)
{
    const bool ours = holder.startsWith(QStringLiteral("boresight"));
    return (ours ? Text::tr("%1 is in use by %2. End that program, or press \"Release bus\" on its Drives page")
                 : Text::tr("%1 is in use by %2. End that program first"))
        .arg(device, holder);
}

// All or nothing: with one impossible frame the whole batch is refused.
Result<std::vector<std::string>> linesOf(std::span<const CanFrame> frames)
{
    std::vector<std::string> lines;
    for (const CanFrame& frame : frames) {
        auto line = fdcanusb::sendLine(frame);
        if (!line) {
            return tl::unexpected(line.error());
        }
        lines.push_back(*std::move(line));
    }
    return lines;
}

}  // namespace

FdcanusbLink::FdcanusbLink(const QString& path, const Clock& clock, LineChecksum checksum, QObject* parent)
    : FdcanusbLink(adapterPort(path), clock, checksum, parent)
{}

FdcanusbLink::FdcanusbLink(StablePort path, const Clock& clock, LineChecksum checksum, QObject* parent)
    : CanLink(parent), m_path(std::move(path)), m_clock(clock), m_checksum(checksum)
{
    m_deadlineTimer.setSingleShot(true);
    connect(&m_deadlineTimer, &QTimer::timeout, this, &FdcanusbLink::checkDeadlines);
    connect(&m_port, &QSerialPort::readyRead, this, &FdcanusbLink::readPort);
    connect(&m_port, &QSerialPort::errorOccurred, this, &FdcanusbLink::handlePortError);
}

FdcanusbLink::~FdcanusbLink()
{
    m_port.disconnect(this);
}

QString FdcanusbLink::name() const
{
    return QStringLiteral("fdcanusb:") + m_path.path();
}

Result<> FdcanusbLink::open()
{
    if (m_probe.foreign && m_probe.foreign == portIdentity(m_path.device())) {
        return failure(ErrorCode::Refused, m_status.text);
    }
    close();
    if (const auto opened = openPort(m_path.device()); !opened) {
        return opened;
    }
    if (const auto claimed = claimPort(m_port.handle()); !claimed) {
        m_port.close();
        return failure(ErrorCode::Busy, inUse(m_path.device(), claimed.error().text));
    }
    m_path.storeName();
    if (!m_port.setBaudRate(kBaudRate)) {
        qCDebug(lcFdcanusb) << m_port.portName() << "keeps its speed:" << m_port.errorString();
        m_port.clearError();
    }
    m_port.clear();  // drops data from before the link was opened
    m_lastCheck = m_clock.now();
    m_lastRestart = m_lastCheck - kRestartPeriod;
    m_probe = {.begun = m_lastCheck};
    updateStatus(LinkState::Up);
    QByteArray probe;
    appendLine(probe, fdcanusb::kBusStatusLine, Command::Status);
    return writeLines(probe);
}

// The maker's tools use no lock that would keep Boresight out, and two programs on one adapter take each other's
// answers. So Boresight looks for such programs first, which takes this thread 5 to 20 ms. No set-point is late because
// of this: no drive is fed while the bus is being opened, and a missing adapter is detected before.
Result<> FdcanusbLink::openPort(const QString& device)
{
    if (const auto check = checkAdapterPort(device); !check) {
        return check;
    }
    if (const std::optional<QString> holder = portHolder(device)) {
        return failure(ErrorCode::Busy, inUse(device, *holder));
    }
    m_port.setPortName(canonicalPort(device));
    if (m_port.open(QIODevice::ReadWrite)) {
        return {};
    }
    const QString reason = m_port.errorString();
    if (m_port.error() == QSerialPort::PermissionError) {
        return failure(
            ErrorCode::Busy,
            Text::tr("%1 is in use by another program (%2). `sudo fuser -v %1` shows which. End that program first")
                .arg(device, reason));
    }
    return failure(ErrorCode::Io, Text::tr("%1 cannot be opened: %2").arg(device, reason));
}

void FdcanusbLink::close()
{
    m_deadlineTimer.stop();
    m_pending.clear();
    m_splitter.clear();
    if (m_port.isOpen()) {
        m_port.close();
    }
    m_port.clearError();
    m_adapterTrouble.clear();
    m_busOff = false;
    m_probe.foreign.reset();
    m_status.leftAlone = false;
    reportBus(LinkState::Closed, {});
}

Result<> FdcanusbLink::send(std::span<const CanFrame> frames)
{
    checkDeadlines();
    if (m_status.state == LinkState::Closed || m_status.state == LinkState::Lost) {
        const QString text = m_status.text.isEmpty() ? Text::tr("%1 is not open").arg(name()) : m_status.text;
        return failure(ErrorCode::NoDevice, text);
    }
    if (m_port.bytesToWrite() > kMaxUnwritten) {
        return failure(ErrorCode::NoAnswer,
                       Text::tr("%1: the adapter accepts no more data. Plug it in again").arg(name()));
    }
    const auto sendLines = linesOf(frames);
    if (!sendLines) {
        return tl::unexpected(sendLines.error());
    }
    if (!m_probe.proven) {
        return {};  // lost, as any frame may be
    }
    QByteArray lines;
    for (const std::string& line : *sendLines) {
        appendLine(lines, line, Command::Frame);
    }
    checkBus(lines);
    const auto written = writeLines(lines);
    m_status.sent += written ? frames.size() : 0;
    return written;
}

void FdcanusbLink::appendLine(QByteArray& lines, std::string_view line, Command command)
{
    lines += m_checksum == LineChecksum::On ? fdcanusb::withChecksum(line) : std::string(line);
    lines += '\n';
    m_pending.push_back({command, m_clock.now() + kOkDeadline});
}

// One write for all lines, flushed at once, so that the frames of both axes leave in the same USB frame.
Result<> FdcanusbLink::writeLines(const QByteArray& lines)
{
    const bool written = m_port.write(lines) == lines.size();
    if (isWritable(m_port.handle())) {
        m_port.flush();
    }
    if (!written || m_status.state == LinkState::Lost) {
        return failure(ErrorCode::Io, QStringLiteral("%1: %2").arg(name(), m_port.errorString()));
    }
    if (!m_deadlineTimer.isActive()) {
        m_deadlineTimer.start(kOkDeadline);
    }
    return {};
}

void FdcanusbLink::readPort()
{
    const QByteArray bytes = m_port.readAll();
    m_splitter.add({bytes.constData(), static_cast<std::size_t>(bytes.size())},
                   [this](std::string_view line) { handleLine(line); });
    m_status.dropped = m_unreadableLines + m_splitter.overlongLines();
}

void FdcanusbLink::handleLine(std::string_view line)
{
    if (m_status.state == LinkState::Closed || m_status.state == LinkState::Lost) {
        return;  // a receiver has closed the link, or the adapter is lost
    }
    const auto rule =
        m_checksum == LineChecksum::On ? fdcanusb::ChecksumRule::Require : fdcanusb::ChecksumRule::VerifyIfPresent;
    const fdcanusb::Answer parsed = fdcanusb::parseAnswer(line, rule);
    m_probe.proven = m_probe.proven || !std::holds_alternative<fdcanusb::Unreadable>(parsed);
    std::visit([this](const auto& answer) { handle(answer); }, parsed);
}

void FdcanusbLink::handle(const CanFrame& frame)
{
    CanFrame stamped = frame;
    stamped.received = m_clock.now();
    m_lastCheck = stamped.received;
    ++m_status.received;
    m_busOff = false;
    reportBus(LinkState::Up, {});
    Q_EMIT frameReceived(stamped);
}

FdcanusbLink::Command FdcanusbLink::takePending()
{
    if (m_pending.empty()) {
        return Command::Frame;
    }
    const Command command = m_pending.front().command;
    m_pending.pop_front();
    return command;
}

void FdcanusbLink::handle(const fdcanusb::Accepted&)
{
    if (takePending() == Command::Frame) {
        m_adapterTrouble.clear();
        updateStatus(m_status.state);
    }
}

void FdcanusbLink::handle(const fdcanusb::Refusal& refusal)
{
    const Command command = takePending();
    if (refusal.notOnBus()) {
        ++m_status.busErrors;
        if (!m_busOff) {  // otherwise the reason is known, and this refusal is its result
            reportBus(LinkState::Down, Text::tr("the adapter is not on the bus (\"not in BusOn state\"). Boresight "
                                                "restarts it once a second. If that does not help, plug it in again"));
        }
        restartController();
    } else if (command == Command::Frame) {
        ++m_status.busErrors;
        constexpr int kShown = 80;
        m_adapterTrouble = Text::tr("the adapter refuses a frame: %1. Check its firmware and its can.* settings")
                               .arg(toQString(printable(refusal.text)).left(kShown));
        updateStatus(m_status.state);
    }  // otherwise: a moteus UART does not know "can status", and "can off" is refused if the bus is off already
}

void FdcanusbLink::handle(const fdcanusb::BusStatus& bus)
{
    takePending();
    m_busOff = bus.busOff;
    if (bus.busOff) {
        ++m_status.busErrors;
        reportBus(LinkState::Down, Text::tr("bus-off after too many errors: check the cable, the 120 ohm at both ends "
                                            "and the bit rate. Boresight restarts the adapter once a second"));
        restartController();
    } else if (bus.errorPassive) {
        reportBus(LinkState::Up, acknowledgeAdvice());
    } else {
        reportBus(LinkState::Up, {});
    }
}

// Runs at every send() and at each timeout of the timer. The clock decides.
void FdcanusbLink::checkDeadlines()
{
    const SteadyTime now = m_clock.now();
    std::uint64_t missing = 0;
    while (!m_pending.empty() && m_pending.front().deadline <= now) {
        missing += takePending() == Command::Frame ? 1 : 0;
    }
    if (missing > 0) {
        m_status.busErrors += missing;
        m_adapterTrouble = Text::tr(
                               "the adapter does not confirm our frames (no OK within %1 ms). Is this port an "
                               "fdcanusb? If so, plug it in again")
                               .arg(kOkDeadline.count());
        updateStatus(m_status.state);
    }
    checkProbe();
    if (!m_pending.empty() || isProbing()) {
        m_deadlineTimer.start(kOkDeadline);
    }
}

void FdcanusbLink::checkProbe()
{
    if (!isProbing() || m_clock.now() - m_probe.begun < kProbeTime || hasUnread(m_port.handle())) {
        return;
    }
    m_probe.foreign = portIdentity(m_path.device());
    m_status.leftAlone = true;
    m_pending.clear();
    m_port.close();
    reportBus(LinkState::Lost,
              Text::tr("no fdcanusb answers on this port. Choose the right port. If this is the right one, plug the "
                       "adapter in again, or press \"Release bus\" and \"Take bus back\" on the Drives page"));
}

// Asks for the bus status if no frame came for some time. A healthy bus is never asked.
void FdcanusbLink::checkBus(QByteArray& lines)
{
    const SteadyTime now = m_clock.now();
    if (now - m_lastCheck >= kCheckPeriod) {
        m_lastCheck = now;
        appendLine(lines, fdcanusb::kBusStatusLine, Command::Status);
    }
}

void FdcanusbLink::restartController()
{
    const SteadyTime now = m_clock.now();
    if (now - m_lastRestart < kRestartPeriod) {
        return;
    }
    m_lastRestart = now;
    m_lastCheck = now;
    QByteArray lines;
    appendLine(lines, fdcanusb::kBusOffLine, Command::Restart);
    appendLine(lines, fdcanusb::kBusOnLine, Command::Restart);
    if (const auto written = writeLines(lines); !written) {
        qCWarning(lcFdcanusb) << qUtf8Printable(written.error().text);
    }
}

void FdcanusbLink::reportBus(LinkState state, const QString& trouble)
{
    m_busTrouble = trouble;
    updateStatus(state);
}

void FdcanusbLink::updateStatus(LinkState state)
{
    const QString& trouble = m_busTrouble.isEmpty() ? m_adapterTrouble : m_busTrouble;
    const QString text = trouble.isEmpty() ? QString() : name() + QStringLiteral(": ") + trouble;
    if (m_status.state != state || m_status.text != text) {
        m_status.state = state;
        m_status.text = text;
        Q_EMIT statusChanged(m_status);
    }
}

void FdcanusbLink::handlePortError(QSerialPort::SerialPortError error)
{
    const bool gone = error == QSerialPort::ResourceError || error == QSerialPort::ReadError ||
                      error == QSerialPort::WriteError || error == QSerialPort::DeviceNotFoundError;
    if (gone && m_status.state != LinkState::Closed && m_status.state != LinkState::Lost) {
        lose();
    }
}

// The functions of the port call this, so the port is closed after they have returned. The error text of the port is
// not shown: for a closed terminal Qt makes it from the errno of an earlier call ("Address already in use").
void FdcanusbLink::lose()
{
    m_deadlineTimer.stop();
    m_pending.clear();
    const auto closeLostPort = [this] {
        if (m_status.state == LinkState::Lost) {
            m_port.close();
        }
    };
    QMetaObject::invokeMethod(this, closeLostPort, Qt::QueuedConnection);
    reportBus(LinkState::Lost,
              m_path.name().isEmpty()
                  ? Text::tr("the adapter is gone. Plug it in again")
                  : Text::tr("the adapter is gone. Plug it in again, in any socket. Boresight finds it as %1")
                        .arg(m_path.name()));
}

}  // namespace boresight

#include "moc_fdcanusb_link.cpp"
