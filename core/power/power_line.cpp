// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/power/power_line.h"

#include "core/base/control_characters.h"
#include "core/base/text.h"
#include "core/power/power_text.h"

#include <QNetworkDatagram>
#include <QNetworkProxy>

#include <algorithm>

namespace boresight::power {
namespace {

constexpr std::size_t kLongestQuote = 40;
constexpr qint64 kLongestDatagram = 2048;
// Then everybody else has a turn before the rest is read.
constexpr int kDatagramsAtOnce = 100;

QString nameOf(const LineSettings& settings)
{
    const bool isV6 = settings.host.contains(QLatin1Char(':'));
    return QStringLiteral("%1 %2:%3")
        .arg(settings.transport == Transport::Udp ? QStringLiteral("UDP") : QStringLiteral("TCP"),
             isV6 ? QStringLiteral("[%1]").arg(settings.host) : settings.host)
        .arg(settings.port);
}

}  // namespace

PowerLine::PowerLine(const LineSettings& settings, const Clock& clock, QObject* parent)
    : QObject(parent), m_settings(settings), m_clock(clock), m_name(nameOf(settings)), m_delay(settings.firstRetry)
{
    // Never by a proxy: to ask the desktop for one blocks.
    m_udp.setProxy(QNetworkProxy::NoProxy);
    m_tcp.setProxy(QNetworkProxy::NoProxy);
    m_retry.setSingleShot(true);
    connect(&m_retry, &QTimer::timeout, this, &PowerLine::open);
    connect(&m_udp, &QUdpSocket::readyRead, this, &PowerLine::readDatagrams);
    connect(&m_tcp, &QTcpSocket::connected, this, &PowerLine::begin);
    connect(&m_tcp, &QTcpSocket::readyRead, this, [this] { read(m_tcp.readAll()); });
    connect(&m_tcp, &QTcpSocket::errorOccurred, this, [this] { lose(m_tcp.errorString()); });
}

PowerLine::~PowerLine()
{
    m_udp.disconnect(this);
    m_tcp.disconnect(this);
}

void PowerLine::open()
{
    m_settings.transport == Transport::Udp ? listen() : connectToHost();
}

void PowerLine::listen()
{
    if (m_udp.bind(QHostAddress(m_settings.host), m_settings.port, QAbstractSocket::DontShareAddress)) {
        begin();
    } else {
        lose(m_udp.errorString());
    }
}

void PowerLine::connectToHost()
{
    m_tcp.abort();
    m_tcp.connectToHost(m_settings.host, m_settings.port, QIODevice::ReadOnly);
}

void PowerLine::begin()
{
    m_open = true;
    m_opened = m_clock.now();
    m_rubbish.clear();
    m_lines.clear();  // half a line from before
}

void PowerLine::lose(const QString& reason)
{
    m_open = false;
    m_trouble = m_settings.transport == Transport::Udp
                    ? Text::tr("%1 cannot be listened at: %2").arg(m_name, reason)
                    : Text::tr("%1: no connection to the receiver's program: %2").arg(m_name, reason);
    if (!m_retry.isActive()) {
        m_retry.start(m_delay);
        m_delay = std::min(2 * m_delay, m_settings.longestRetry);
    }
}

void PowerLine::readDatagrams()
{
    for (int i = 0; i < kDatagramsAtOnce && m_udp.hasPendingDatagrams(); ++i) {
        m_lines.clear();
        read(m_udp.receiveDatagram(kLongestDatagram).data() + '\n');  // its end ends a line, too
    }
    if (m_udp.hasPendingDatagrams()) {
        QMetaObject::invokeMethod(this, &PowerLine::readDatagrams, Qt::QueuedConnection);
    }
}

void PowerLine::read(const QByteArray& bytes)
{
    m_lines.add({bytes.constData(), static_cast<std::size_t>(bytes.size())},
                [this](std::string_view line) { take(line); });
}

void PowerLine::take(std::string_view line)
{
    if (line.find_first_not_of(" \t") == std::string_view::npos) {
        return;
    }
    const auto power = parsePower(line);
    if (!power) {
        ++m_refused;
        if (m_rubbish.isEmpty()) {
            m_rubbish = QStringLiteral("\"%1\": %2")
                            .arg(toQString(printable(std::string(line.substr(0, kLongestQuote)))),
                                 toQString(power.error().text));
        }
        return;
    }
    ++m_values;
    m_last = Value{.decibels = *power, .arrival = m_clock.now()};
    m_trouble.clear();
    m_rubbish.clear();
    m_delay = m_settings.firstRetry;
    Q_EMIT received(*m_last);
}

QString PowerLine::problem() const
{
    const SteadyTime heard = m_last ? std::max(m_last->arrival, m_opened) : m_opened;
    const bool isSilent = m_open && Seconds(m_clock.now() - heard) > m_settings.silence;
    if (!isSilent) {
        return m_trouble;
    }
    return m_rubbish.isEmpty()
               ? Text::tr("%1: nothing comes: is the receiver's program running, and does it send here?").arg(m_name)
               : Text::tr("%1: what comes is no power in dB: %2").arg(m_name, m_rubbish);
}

LineStatus PowerLine::status() const
{
    LineStatus status{
        .name = m_name, .problem = problem(), .values = m_values, .refused = m_refused + m_lines.overlongLines()};
    if (m_last) {
        status.decibels = m_last->decibels;
        status.age = m_clock.now() - m_last->arrival;
    }
    return status;
}

}  // namespace boresight::power
