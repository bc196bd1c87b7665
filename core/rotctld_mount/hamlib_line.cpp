// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotctld_mount/hamlib_line.h"

#include "core/base/text.h"

namespace boresight::rotctl {

HamlibLine::HamlibLine(const HamlibRotator& rotator, QObject* parent)
    : BoxLine(parent), m_bus(rotator.bus), m_program(rotator, this)
{
    connect(&m_program, &OwnRotctld::listens, this, &HamlibLine::connectTo);
    connect(&m_program, &OwnRotctld::failed, this, &HamlibLine::lose);
}

HamlibLine::~HamlibLine()
{
    m_program.disconnect(this);
}

QString HamlibLine::name() const
{
    return toQString(toString(m_bus));
}

void HamlibLine::open()
{
    m_program.start();
}

void HamlibLine::close()
{
    if (m_connection) {
        m_connection->disconnect(this);
        m_connection->close();
    }
    m_program.end();
    show(State::Closed);
}

void HamlibLine::write(const QByteArray& bytes)
{
    if (m_connection) {
        m_connection->write(bytes);
    }
}

void HamlibLine::connectTo(quint16 port)
{
    m_connection =
        std::make_unique<TcpBoxLine>(BusName{.kind = BusKind::Rotctld, .target = "127.0.0.1", .port = port}, this);
    connect(m_connection.get(), &BoxLine::received, this, &BoxLine::received);
    connect(m_connection.get(), &BoxLine::stateChanged, this, &HamlibLine::followConnection);
    m_connection->open();
}

// If the program has ended, its own error text is reported, which arrives a moment later.
void HamlibLine::followConnection()
{
    if (m_connection->state() == State::Up) {
        show(State::Up);
    } else if (m_connection->state() == State::Lost) {
        m_program.connectionLost();
    }
}

void HamlibLine::lose(const QString& reason)
{
    if (m_connection) {
        m_connection->disconnect(this);
        m_connection->close();
    }
    show(State::Lost, Text::tr("%1: %2").arg(name(), reason));
}

}  // namespace boresight::rotctl

#include "moc_hamlib_line.cpp"
