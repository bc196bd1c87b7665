// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotator_box/serial_box_line.h"

#include "core/base/text.h"
#include "core/serial/port_claim.h"
#include "core/serial/port_holder.h"
#include "core/serial/serial_port_check.h"

namespace boresight {
namespace {

QString inUse(const QString& device, const QString& holder)
{
    return Text::tr("%1 is in use by %2. End that program first").arg(device, holder);
}

}  // namespace

SerialBoxLine::SerialBoxLine(const QString& path, int baud, QObject* parent)
    : BoxLine(parent), m_path(path), m_baud(baud)
{
    connect(&m_port, &QSerialPort::readyRead, this, &SerialBoxLine::read);
    connect(&m_port, &QSerialPort::errorOccurred, this, &SerialBoxLine::lose);
}

SerialBoxLine::~SerialBoxLine()
{
    m_port.disconnect(this);
}

QString SerialBoxLine::name() const
{
    return QStringLiteral("serial:") + m_path.path();
}

void SerialBoxLine::open()
{
    if (m_port.isOpen()) {
        return;
    }
    const QString device = m_path.device();
    const auto claim = [this, &device] {
        const Result<> claimed = claimPort(m_port.handle());
        return claimed ? claimed : failure(ErrorCode::Busy, inUse(device, claimed.error().text));
    };
    const Result<> opened = openPort(device).and_then(claim);
    if (!opened) {
        m_port.close();
        m_port.clearError();
        show(State::Lost, opened.error().text);
        return;
    }
    m_path.storeName();
    m_port.clear();  // drops data from before the port was opened
    show(State::Up);
}

// Two programs on one port take each other's answers. Looking for the other program takes some milliseconds. No
// set-point is late because of this, because no axis follows while the line is being opened.
Result<> SerialBoxLine::openPort(const QString& device)
{
    if (const Result<> check = checkSerialPort(device); !check) {
        return check;
    }
    const auto identity = portIdentity(device);
    // The program behind a pseudo-terminal often has this end open, too.
    const bool isTerminal = identity && isPseudoTerminal(identity->device);
    if (const auto holder = portHolder(device); holder && !isTerminal) {
        return failure(ErrorCode::Busy, inUse(device, *holder));
    }
    m_port.setPortName(canonicalPort(device));
    m_port.setBaudRate(m_baud);
    if (m_port.open(QIODevice::ReadWrite)) {
        return {};
    }
    const QString reason = m_port.errorString();
    return m_port.error() == QSerialPort::PermissionError
               ? failure(ErrorCode::Busy, Text::tr("%1 is in use by another program (%2). `sudo fuser -v %1` shows "
                                                   "which. End that program first")
                                              .arg(device, reason))
               : failure(ErrorCode::Io, Text::tr("%1 cannot be opened: %2").arg(device, reason));
}

void SerialBoxLine::close()
{
    if (m_port.isOpen()) {
        m_port.flush();
        m_port.close();
    }
    m_port.clearError();
    show(State::Closed);
}

void SerialBoxLine::write(const QByteArray& bytes)
{
    if (state() == State::Up && m_port.bytesToWrite() < kMostUnwritten) {
        m_port.write(bytes);
        m_port.flush();
    }
}

void SerialBoxLine::read()
{
    const QByteArray bytes = m_port.read(kBytesAtOnce);
    if (m_port.bytesAvailable() > 0) {
        m_port.clear(QSerialPort::Input);  // a flood: some adapters ignore the configured speed
    }
    if (state() == State::Up && !bytes.isEmpty()) {
        Q_EMIT received(bytes);
    }
}

// The functions of the port call this, so the port is closed after they have returned.
void SerialBoxLine::lose(QSerialPort::SerialPortError error)
{
    const bool gone = error == QSerialPort::ResourceError || error == QSerialPort::ReadError ||
                      error == QSerialPort::WriteError || error == QSerialPort::DeviceNotFoundError;
    if (!gone || state() != State::Up) {
        return;
    }
    const auto closeLostPort = [this] {
        if (state() == State::Lost) {
            m_port.close();
            m_port.clearError();
        }
    };
    QMetaObject::invokeMethod(this, closeLostPort, Qt::QueuedConnection);
    show(State::Lost, m_path.name().isEmpty()
                          ? Text::tr("%1 is gone. Plug its cable in again").arg(m_path.path())
                          : Text::tr("%1 is gone. Plug its cable in again, in any socket. Boresight finds it as %2")
                                .arg(m_path.path(), m_path.name()));
}

}  // namespace boresight

#include "moc_serial_box_line.cpp"
