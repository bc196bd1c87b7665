// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/orientation/sentence_stream.h"
#include "core/orientation_stream/sensor_source.h"
#include "core/serial/stable_port.h"

#include <QFutureWatcher>
#include <QSerialPort>
#include <QTimer>

#include <optional>

// The sensor's sentences from a serial port. Read-only: nothing is ever sent to the sensor. A port that is missing or
// disappears is tried again after 1, 2, 4 and 8 s, then every 10 s. An adapter that comes back under another name is
// found by its manufacturer and serial number. At most kBytesAtOnce are read every kPause, because some adapters ignore
// the baud rate and flood the program. Lives on the station thread. Another thread finds out whether another program
// has the port, because that takes as long as the pause between two ticks.
namespace boresight::orientation {

struct SerialSettings
{
    QString port;  // "/dev/ttyUSB0"
    qint32 baud = 115200;
    std::chrono::milliseconds firstRetry{1000};
    std::chrono::milliseconds longestRetry{10000};
    // Open for this long without a sentence: then the received text is reported, and checked again at this interval.
    std::chrono::milliseconds silence{5000};
};

class SerialSource final : public SensorSource
{
    Q_OBJECT

public:
    static constexpr qint64 kBytesAtOnce = 2048;
    static constexpr std::chrono::milliseconds kPause{10};

    // `clock` must outlive the source.
    SerialSource(const SerialSettings& settings, const Clock& clock, QObject* parent = nullptr);
    ~SerialSource() override;

    [[nodiscard]] QString name() const override;
    [[nodiscard]] const SourceStatus& status() const override { return m_status; }
    void open() override;
    void close() override;

private:
    // The search for another program that has the device.
    struct HolderSearch
    {
        QString device;
        bool looking = false;                           // takeHolder() is still to be called
        QFutureWatcher<std::optional<QString>> lookUp;  // the result is reported by a signal
    };

    void lookForHolder(const QString& device);
    void takeHolder();
    void begin();
    [[nodiscard]] Result<> openPort();
    void read();
    void tellSilence();
    void lose(QSerialPort::SerialPortError error);
    void tryLater(const QString& problem);
    void show(bool open, const QString& problem);

    SerialSettings m_settings;
    const Clock& m_clock;
    StablePort m_path;
    QSerialPort m_port{this};
    SentenceStream m_stream;
    QTimer m_retry{this};
    QTimer m_pause{this};
    QTimer m_silence{this};
    std::chrono::milliseconds m_delay;
    bool m_wanted = false;
    HolderSearch m_holder;
    bool m_heard = false;  // bytes arrived since the last sentence or the last report
    QString m_seen;        // the text that arrived instead of sentences, at the last check
    SourceStatus m_status;
};

}  // namespace boresight::orientation
