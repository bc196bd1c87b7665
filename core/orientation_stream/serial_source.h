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

// The sensor's sentences from a serial port. Reads only: nothing is ever sent to the sensor. A port that is not there,
// or goes, is tried again after 1, 2, 4, 8 s, then each 10 s; an adapter that comes back under another name is found by
// its maker and number. At most kBytesAtOnce are read each kPause, whatever the port sends: some adapters ignore the
// baud rate. Lives on the station thread; whether another program has the port is looked up beside it, for that takes
// as long as the drives wait between two ticks.
namespace boresight::orientation {

struct SerialSettings
{
    QString port;  // "/dev/ttyUSB0"
    qint32 baud = 115200;
    std::chrono::milliseconds firstRetry{1000};
    std::chrono::milliseconds longestRetry{10000};
    // Open for so long without a sentence: then it is said what comes in its place, and looked at again as often.
    std::chrono::milliseconds silence{5000};
};

class SerialSource final : public SensorSource
{
    Q_OBJECT

public:
    static constexpr qint64 kBytesAtOnce = 2048;
    static constexpr std::chrono::milliseconds kPause{10};

    // `clock` outlives the source.
    SerialSource(const SerialSettings& settings, const Clock& clock, QObject* parent = nullptr);
    ~SerialSource() override;

    [[nodiscard]] QString name() const override;
    [[nodiscard]] const SourceStatus& status() const override { return m_status; }
    void open() override;
    void close() override;

private:
    // Whether another program has the device that is being opened.
    struct HolderSearch
    {
        QString device;
        bool looking = false;                           // takeHolder() is still to come
        QFutureWatcher<std::optional<QString>> lookUp;  // nobody waits for it
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
    bool m_heard = false;  // bytes, since the last sentence, or since what came in its place was looked at
    QString m_seen;        // in its place, at the last look
    SourceStatus m_status;
};

}  // namespace boresight::orientation
