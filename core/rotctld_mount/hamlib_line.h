// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/bus_name.h"
#include "core/rotator_box/box_line.h"
#include "core/rotator_box/tcp_box_line.h"
#include "core/rotctld_mount/own_rotctld.h"

#include <memory>

// A rotator of Hamlib through a rotctld of our own: the program and the connection to it. Whenever the connection is
// closed or lost, the program is ended. open() starts a new one.
namespace boresight::rotctl {

class HamlibLine final : public BoxLine
{
    Q_OBJECT

public:
    explicit HamlibLine(const HamlibRotator& rotator, QObject* parent = nullptr);
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
    std::unique_ptr<TcpBoxLine> m_connection;  // empty until the program listens
};

}  // namespace boresight::rotctl
