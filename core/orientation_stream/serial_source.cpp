// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/orientation_stream/serial_source.h"

#include "core/base/control_characters.h"
#include "core/base/text.h"
#include "core/serial/port_holder.h"
#include "core/serial/serial_port_check.h"

#include <QLoggingCategory>
#include <QPromise>
#include <QThreadPool>

#include <sys/ioctl.h>

#include <algorithm>
#include <memory>

namespace boresight::orientation {
namespace {

Q_LOGGING_CATEGORY(lcSensor, "boresight.sensor")

}  // namespace

SerialSource::SerialSource(const SerialSettings& settings, const Clock& clock, QObject* parent)
    : SensorSource(parent), m_settings(settings), m_clock(clock), m_path(settings.port), m_delay(settings.firstRetry)
{
    m_port.setReadBufferSize(kBytesAtOnce);
    m_retry.setSingleShot(true);
    m_pause.setSingleShot(true);
    m_pause.setInterval(kPause);
    m_silence.setSingleShot(true);
    connect(&m_retry, &QTimer::timeout, this, &SerialSource::open);
    connect(&m_silence, &QTimer::timeout, this, &SerialSource::tellSilence);
    connect(&m_pause, &QTimer::timeout, this, &SerialSource::read);
    connect(&m_port, &QSerialPort::readyRead, this, &SerialSource::read);
    connect(&m_port, &QSerialPort::errorOccurred, this, &SerialSource::lose);
    connect(&m_holder.lookUp, &QFutureWatcherBase::finished, this, &SerialSource::takeHolder);
}

SerialSource::~SerialSource()
{
    m_port.disconnect(this);
}

QString SerialSource::name() const
{
    return QStringLiteral("serial ") + m_path.path();
}

void SerialSource::open()
{
    m_wanted = true;
    m_retry.stop();
    if (m_port.isOpen() || m_holder.looking) {
        return;
    }
    const QString device = m_path.device();
    if (const Result<> check = checkSerialPort(device); !check) {
        tryLater(check.error().text);
    } else {
        lookForHolder(device);
    }
}

// Looks for another program on the port: two programs take bytes from each other, and some programs do not lock the
// port. The look-up owns its promise, so it can end safely after the source was deleted.
void SerialSource::lookForHolder(const QString& device)
{
    m_holder.looking = true;
    m_holder.device = device;
    const auto promise = std::make_shared<QPromise<std::optional<QString>>>();
    m_holder.lookUp.setFuture(promise->future());
    QThreadPool::globalInstance()->start([promise, device] {
        promise->start();
        promise->addResult(portHolder(device));
        promise->finish();
    });
}

void SerialSource::takeHolder()
{
    m_holder.looking = false;
    if (!m_wanted) {
        return;
    }
    if (const std::optional<QString> holder = m_holder.lookUp.result()) {
        tryLater(Text::tr("%1 is in use by %2. End that program first").arg(m_holder.device, *holder));
    } else if (const Result<> opened = openPort(); !opened) {
        tryLater(opened.error().text);
    } else {
        begin();
    }
}

void SerialSource::begin()
{
    m_path.storeName();
    ioctl(m_port.handle(), TIOCNXCL);  // as for the bus: Qt's lock file keeps other programs out
    m_port.clear();                    // drops half of an old sentence
    m_stream.clear();
    m_heard = false;
    m_seen.clear();
    m_silence.start(m_settings.silence);
    show(true, m_status.problem);  // the problem stays until the first good sentence
}

Result<> SerialSource::openPort()
{
    m_port.setPortName(canonicalPort(m_holder.device));
    m_port.setBaudRate(m_settings.baud);
    if (m_port.open(QIODevice::ReadOnly)) {
        return {};
    }
    const QString reason = m_port.errorString();
    const bool held = m_port.error() == QSerialPort::PermissionError;
    m_port.clearError();
    return failure(
        held ? ErrorCode::Busy : ErrorCode::Io,
        held ? Text::tr("%1 is in use by another program (%2). `sudo fuser -v %1` shows which. End that program first")
                   .arg(m_holder.device, reason)
             : Text::tr("%1 cannot be opened: %2").arg(m_holder.device, reason));
}

void SerialSource::close()
{
    m_wanted = false;
    m_retry.stop();
    m_silence.stop();
    m_port.close();
    m_port.clearError();
    m_delay = m_settings.firstRetry;
    show(false, {});
}

// After a full read the source pauses. Meanwhile the rest waits in the system's buffer.
void SerialSource::read()
{
    if (m_pause.isActive() || !m_port.isOpen()) {
        return;
    }
    const QByteArray bytes = m_port.readAll();
    if (bytes.size() >= kBytesAtOnce) {
        m_pause.start();
    }
    m_heard = m_heard || !bytes.isEmpty();
    const auto use = [this](const Orientation& value) {
        if (!m_wanted) {
            return;  // the receiver of the previous value has closed the port
        }
        m_status.counts = m_stream.counts();
        m_heard = false;
        m_seen.clear();
        m_delay = m_settings.firstRetry;
        m_silence.start(m_settings.silence);
        show(true, {});
        Q_EMIT received(value);
    };
    const auto refuse = [](const Refused& refused, std::string_view sentence) {
        qCDebug(lcSensor) << "refused:" << toText(refused).c_str() << printable(std::string(sentence)).c_str();
    };
    m_stream.add({bytes.constData(), static_cast<std::size_t>(bytes.size())}, m_clock.now(), use, refuse);
    m_status.counts = m_stream.counts();
}

void SerialSource::tellSilence()
{
    if (!m_port.isOpen()) {
        return;
    }
    const QString last = toQString(m_stream.lastChatter());
    const QString text =
        !m_heard ? Text::tr("%1: No data. Does the sensor have power and WiFi? Without WiFi it sends nothing")
                       .arg(m_path.path())
        : last.isEmpty() ? Text::tr("%1: The data is damaged or not from the sensor. Is sensor.baud (%2) right?")
                               .arg(m_path.path())
                               .arg(m_settings.baud)
                         : Text::tr("%1: The data is not from the sensor: \"%2\"").arg(m_path.path(), last);
    // Reports the first text at once, and another one only if it repeats. Chatter that contains a number would be a new
    // text each time.
    if (m_seen.isEmpty() || m_seen == text) {
        show(true, text);
    }
    m_seen = text;
    m_heard = false;
    m_silence.start(m_settings.silence);
}

// Called from inside the port's own functions, so the port is closed only after they have returned.
void SerialSource::lose(QSerialPort::SerialPortError error)
{
    const bool gone = error == QSerialPort::ResourceError || error == QSerialPort::ReadError ||
                      error == QSerialPort::DeviceNotFoundError;
    if (!gone || !m_wanted || !m_status.open) {
        return;
    }
    tryLater(m_path.name().isEmpty()
                 ? Text::tr("%1 is gone. Plug the sensor in again").arg(m_path.path())
                 : Text::tr("%1 is gone. Plug the sensor in again, in any socket. Boresight finds it as %2")
                       .arg(m_path.path(), m_path.name()));
    const auto closeLostPort = [this] {
        if (!m_status.open) {
            m_port.close();
            m_port.clearError();
        }
    };
    QMetaObject::invokeMethod(this, closeLostPort, Qt::QueuedConnection);
}

void SerialSource::tryLater(const QString& problem)
{
    m_silence.stop();
    m_retry.start(m_delay);
    m_delay = std::min(2 * m_delay, m_settings.longestRetry);
    show(false, problem);
}

void SerialSource::show(bool open, const QString& problem)
{
    if (m_status.open != open || m_status.problem != problem) {
        m_status.open = open;
        m_status.problem = problem;
        Q_EMIT statusChanged(m_status);
    }
}

}  // namespace boresight::orientation

#include "moc_serial_source.cpp"
