// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/bus_name.h"
#include "core/rotator_box/box_line.h"

#include <QTcpSocket>
#include <QTimer>

// A box behind a serial server, or with a network connection of its own.
namespace boresight {

class TcpBoxLine final : public BoxLine
{
    Q_OBJECT

public:
    static constexpr std::chrono::seconds kConnectTime{5};

    // `bus`: a bus name of the profile with a host and a port.
    explicit TcpBoxLine(BusName bus, QObject* parent = nullptr);
    ~TcpBoxLine() override;

    [[nodiscard]] QString name() const override;
    void open() override;
    void close() override;
    void write(const QByteArray& bytes) override;

private:
    void read();
    void begin();
    void lose();
    void giveUp();
    [[nodiscard]] QString lost(const QString& reason) const;

    BusName m_bus;
    QTcpSocket m_socket{this};
    QTimer m_patience{this};  // for a host that does not answer
};

}  // namespace boresight
