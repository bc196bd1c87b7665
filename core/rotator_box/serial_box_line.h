// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/rotator_box/box_line.h"
#include "core/serial/stable_port.h"

#include <QSerialPort>

// A box on a serial port, 8N1 without handshake. A port that another program has open is left alone, and the error
// names that program. After a replug the port is found again by the maker and serial number of its adapter.
namespace boresight {

class SerialBoxLine final : public BoxLine
{
    Q_OBJECT

public:
    SerialBoxLine(const QString& path, int baud, QObject* parent = nullptr);
    ~SerialBoxLine() override;

    [[nodiscard]] QString name() const override;
    void open() override;
    void close() override;
    void write(const QByteArray& bytes) override;

private:
    [[nodiscard]] Result<> openPort(const QString& device);
    void read();
    void lose(QSerialPort::SerialPortError error);

    StablePort m_path;
    int m_baud;
    QSerialPort m_port{this};
};

}  // namespace boresight
