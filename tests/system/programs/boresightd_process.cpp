// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/system/programs/boresightd_process.h"

#include "tests/fakes/wait_until.h"

#include <QProcessEnvironment>
#include <QRegularExpression>
#include <QTest>

namespace boresight::system_test {

BoresightdProcess::BoresightdProcess(const QStringList& arguments)
{
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("HOME"), m_home.path());
    environment.insert(QStringLiteral("XDG_CONFIG_HOME"), m_home.path());
    m_process.setProcessEnvironment(environment);
    QObject::connect(&m_process, &QProcess::readyReadStandardOutput, [this] { readAddress(); });
    m_process.start(QStringLiteral(BORESIGHTD), QStringList{QStringLiteral("--listen"), QStringLiteral("127.0.0.1:0"),
                                                            QStringLiteral("--state-dir"), m_home.path()} +
                                                    arguments);
    [[maybe_unused]] const bool ready =
        fakes::waitUntil([this] { return listens() || m_process.state() == QProcess::NotRunning; });
}

BoresightdProcess::~BoresightdProcess()
{
    m_process.disconnect();
    m_process.kill();
    [[maybe_unused]] const bool ended = fakes::waitUntil([this] { return m_process.state() == QProcess::NotRunning; });
}

void BoresightdProcess::readAddress()
{
    static const QRegularExpression line(QStringLiteral("^rotctld listening on 127\\.0\\.0\\.1:(\\d+)\n"));
    m_output += m_process.readAllStandardOutput();
    m_port = line.match(QString::fromUtf8(m_output)).captured(1).toUShort();
}

std::unique_ptr<fakes::TcpPeer> BoresightdProcess::connect() const
{
    return std::make_unique<fakes::TcpPeer>("127.0.0.1", m_port, [] { QTest::qWait(1); });
}

std::string BoresightdProcess::complaints()
{
    return m_process.readAllStandardError().toStdString();
}

std::optional<int> BoresightdProcess::terminate()
{
    m_process.terminate();
    if (!fakes::waitUntil([this] { return m_process.state() == QProcess::NotRunning; }) ||
        m_process.exitStatus() != QProcess::NormalExit) {
        return std::nullopt;
    }
    return m_process.exitCode();
}

}  // namespace boresight::system_test
