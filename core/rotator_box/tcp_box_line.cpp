// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotator_box/tcp_box_line.h"

#include "core/base/text.h"

#include <QNetworkProxy>

#include <linux/tcp.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <utility>

namespace boresight {

TcpBoxLine::TcpBoxLine(BusName bus, QObject* parent) : BoxLine(parent), m_bus(std::move(bus))
{
    m_socket.setProxy(QNetworkProxy::NoProxy);  // a query of the desktop for its proxy would block
    m_socket.setReadBufferSize(kBytesAtOnce);
    m_patience.setSingleShot(true);
    connect(&m_patience, &QTimer::timeout, this, &TcpBoxLine::giveUp);
    connect(&m_socket, &QTcpSocket::connected, this, &TcpBoxLine::begin);
    connect(&m_socket, &QTcpSocket::readyRead, this, &TcpBoxLine::read);
    connect(&m_socket, &QTcpSocket::errorOccurred, this, &TcpBoxLine::lose);
}

TcpBoxLine::~TcpBoxLine()
{
    m_socket.disconnect(this);
}

QString TcpBoxLine::name() const
{
    return toQString(toString(m_bus));
}

QString TcpBoxLine::lost(const QString& reason) const
{
    const QString text =
        m_bus.kind == BusKind::Rotctld
            ? Text::tr("%1: %2. Check that rotctld runs there. Check its address, its port and the network")
            : Text::tr("%1: %2. Check its power, its address and its network");
    return text.arg(name(), reason);
}

void TcpBoxLine::open()
{
    if (state() != State::Up && !m_patience.isActive()) {
        m_socket.abort();  // unwritten data must not delay the closing
        m_patience.start(kConnectTime);
        m_socket.connectToHost(QString::fromStdString(m_bus.target), m_bus.port);
    }
}

void TcpBoxLine::begin()
{
    m_patience.stop();
    m_socket.setSocketOption(QAbstractSocket::LowDelayOption, 1);
    m_socket.setSocketOption(QAbstractSocket::KeepAliveOption, 1);
    // An unacknowledged target must not arrive minutes later. After this time the line is lost together with all
    // waiting data.
    const int milliseconds = 2000;
    setsockopt(static_cast<int>(m_socket.socketDescriptor()), IPPROTO_TCP, TCP_USER_TIMEOUT, &milliseconds,
               sizeof milliseconds);
    show(State::Up);
}

void TcpBoxLine::close()
{
    m_patience.stop();
    show(State::Closed);
    m_socket.flush();
    m_socket.disconnectFromHost();
    m_socket.abort();
}

void TcpBoxLine::write(const QByteArray& bytes)
{
    if (state() == State::Up && m_socket.bytesToWrite() < kMostUnwritten) {
        m_socket.write(bytes);
        m_socket.flush();
    }
}

void TcpBoxLine::read()
{
    const QByteArray bytes = m_socket.readAll();
    if (state() == State::Up && !bytes.isEmpty()) {
        Q_EMIT received(bytes);
    }
}

void TcpBoxLine::lose()
{
    m_patience.stop();
    const bool closed = m_socket.error() == QAbstractSocket::RemoteHostClosedError;
    const QString reason = closed ? Text::tr("the other end closed the connection") : m_socket.errorString();
    show(State::Lost, lost(reason));
}

void TcpBoxLine::giveUp()
{
    m_socket.abort();
    show(State::Lost, lost(Text::tr("no answer")));
}

}  // namespace boresight

#include "moc_tcp_box_line.cpp"
