// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/bus_name.h"
#include "core/rotator_box/box_line.h"
#include "core/rotator_box/tcp_box_line.h"
#include "core/rotctld_mount/own_rotctld.h"

#include <memory>

// A rotator of Hamlib by a rotctld of our own: that program, and the connection to it. Whenever the connection is
// closed or lost, the program ends. open() starts the next one.
namespace boresight::rotctl {

class HamlibLine final : public BoxLine
{
    Q_OBJECT

public:
    // As OwnRotctld.
    HamlibLine(const BusName& bus, int baud, QObject* parent = nullptr);
    ~HamlibLine() override;

    [[nodiscard]] QString name() const override;
    void open() override;
    void close() override;
    void write(const QByteArray& bytes) override;

private:
    void connectTo(quint16 port);
    void followConnection();
    void lose(const QString& reason);

    const BusName m_bus;
    OwnRotctld m_program;
    std::unique_ptr<TcpBoxLine> m_connection;  // to the program that listens
};

}  // namespace boresight::rotctl
