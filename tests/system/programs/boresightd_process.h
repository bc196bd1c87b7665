// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/fakes/tcp_peer.h"

#include <QProcess>
#include <QStringList>
#include <QTemporaryDir>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

// The program boresightd as a separate process on a free port, with its own state folder and the built-in profile,
// whatever the user's home contains. The event loop of the test runs while it waits.
namespace boresight::system_test {

class BoresightdProcess
{
public:
    explicit BoresightdProcess(const QStringList& arguments);
    ~BoresightdProcess();

    [[nodiscard]] bool listens() const { return m_port != 0; }
    [[nodiscard]] std::string address() const { return "127.0.0.1:" + std::to_string(m_port); }
    [[nodiscard]] std::unique_ptr<fakes::TcpPeer> connect() const;
    [[nodiscard]] qint64 process() const { return m_process.processId(); }
    [[nodiscard]] QString stateFolder() const { return m_home.path(); }
    [[nodiscard]] std::string complaints();  // its standard error

    void kill() { m_process.kill(); }  // SIGKILL
    // SIGTERM. Returns its exit code, or empty if it did not end.
    [[nodiscard]] std::optional<int> terminate();

private:
    void readAddress();

    QTemporaryDir m_home;
    QProcess m_process;
    QByteArray m_output;
    std::uint16_t m_port = 0;
};

}  // namespace boresight::system_test
