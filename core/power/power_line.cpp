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

}  // namespace

QString nameOf(const LineSettings& settings)
{
    const bool isV6 = settings.host.contains(QLatin1Char(':'));
    return QStringLiteral("%1 %2:%3")
        .arg(settings.transport == Transport::Udp ? QStringLiteral("UDP") : QStringLiteral("TCP"),
             isV6 ? QStringLiteral("[%1]").arg(settings.host) : settings.host)
        .arg(settings.port);
}

QString problemOf(const LineSettings& settings, const LineState& state, SteadyTime now)
{
    const SteadyTime heard = state.last ? std::max(state.last->arrival, state.opened) : state.opened;
    const bool isSilent = state.open && Seconds(now - heard) > settings.silence;
    if (!isSilent) {
        return state.trouble;
    }
    return state.rubbish.isEmpty()
               ? Text::tr("%1: No data. Is the program of the receiver running? Does it send to this address?")
                     .arg(nameOf(settings))
               : Text::tr("%1: The data is not a power in dB: %2").arg(nameOf(settings), state.rubbish);
}

PowerLine::PowerLine(const LineSettings& settings, const Clock& clock, QObject* parent)
    : QObject(parent), m_settings(settings), m_clock(clock), m_delay(settings.firstRetry)
{
    // No proxy is used, because asking the desktop for its proxy would block.
    m_udp.setProxy(QNetworkProxy::NoProxy);
    m_tcp.setProxy(QNetworkProxy::NoProxy);
    m_tcp.setReadBufferSize(kBytesAtOnce);
    m_retry.setSingleShot(true);
    m_pause.setSingleShot(true);
    m_pause.setInterval(kPause);
    connect(&m_retry, &QTimer::timeout, this, &PowerLine::open);
    connect(&m_pause, &QTimer::timeout, this, &PowerLine::readSome);
    connect(&m_udp, &QUdpSocket::readyRead, this, &PowerLine::readSome);
    connect(&m_tcp, &QTcpSocket::connected, this, &PowerLine::begin);
    connect(&m_tcp, &QTcpSocket::readyRead, this, &PowerLine::readSome);
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
    m_state.open = true;
    m_state.opened = m_clock.now();
    m_state.rubbish.clear();
    m_lines.clear();  // drops an unfinished line of the previous connection
    Q_EMIT stateChanged();
}

void PowerLine::lose(const QString& reason)
{
    m_state.open = false;
    m_state.trouble =
        m_settings.transport == Transport::Udp
            ? Text::tr("Boresight cannot listen on %1: %2").arg(nameOf(m_settings), reason)
            : Text::tr("%1: No connection to the program of the receiver: %2").arg(nameOf(m_settings), reason);
    if (!m_retry.isActive()) {
        m_retry.start(m_delay);
        m_delay = std::min(2 * m_delay, m_settings.longestRetry);
    }
    Q_EMIT stateChanged();
}

// Reads a limited amount at once. If more may be waiting, the next read is after a pause, so a flood does not keep the
// thread busy.
void PowerLine::readSome()
{
    if (m_pause.isActive()) {
        return;
    }
    if (m_settings.transport == Transport::Udp ? readDatagrams() : readStream()) {
        m_pause.start();
    }
    m_state.refused = m_refused + m_lines.overlongLines();
    Q_EMIT stateChanged();
}

// True: kDatagramsAtOnce were read, so more may be waiting.
bool PowerLine::readDatagrams()
{
    int count = 0;
    for (; count < kDatagramsAtOnce && m_udp.hasPendingDatagrams(); ++count) {
        m_lines.clear();
        read(m_udp.receiveDatagram(kLongestDatagram).data() + '\n');  // the end of a datagram also ends a line
    }
    return count == kDatagramsAtOnce;
}

// True: kBytesAtOnce were read, so more may be waiting.
bool PowerLine::readStream()
{
    const QByteArray bytes = m_tcp.readAll();
    read(bytes);
    return bytes.size() >= kBytesAtOnce;
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
        if (m_state.rubbish.isEmpty()) {
            m_state.rubbish =
                QStringLiteral("\"%1\": %2")
                    .arg(toQString(printable(std::string(line.substr(0, kLongestQuote)))), power.error().text);
        }
        return;
    }
    ++m_state.values;
    m_state.last = Value{.decibels = *power, .arrival = m_clock.now()};
    m_state.trouble.clear();
    m_state.rubbish.clear();
    m_delay = m_settings.firstRetry;
    Q_EMIT received(*m_state.last);
}

}  // namespace boresight::power

#include "moc_power_line.cpp"
