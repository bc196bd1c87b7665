// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fakes/program.h"

#include "tests/fakes/wait_until.h"

#include <algorithm>

namespace boresight::fakes {

Program::Program(const QString& path, const QStringList& arguments)
{
    QObject::connect(&m_process, &QProcess::readyReadStandardOutput, &m_process,
                     [this] { m_output += m_process.readAllStandardOutput(); });
    QObject::connect(&m_process, &QProcess::readyReadStandardError, &m_process,
                     [this] { m_errors += m_process.readAllStandardError(); });
    m_process.start(path, arguments);
}

Program::~Program()
{
    m_process.kill();
    (void)waitForEnd();
}

bool Program::waitForLine(const QString& text)
{
    return waitUntil([&] {
        const QStringList all = lines();
        return std::ranges::any_of(all, [&](const QString& line) { return line.startsWith(text); });
    });
}

bool Program::waitForError(const QString& text)
{
    return waitUntil([&] { return errors().contains(text); });
}

int Program::waitForEnd()
{
    const bool ended = waitUntil([this] { return m_process.state() == QProcess::NotRunning; });
    return ended && m_process.exitStatus() == QProcess::NormalExit ? m_process.exitCode() : -1;
}

void Program::type(const QByteArray& text)
{
    m_process.write(text);
    m_process.closeWriteChannel();
}

QStringList Program::lines() const
{
    QStringList all = output().split(QLatin1Char('\n'));
    all.removeLast();  // an incomplete or empty line
    return all;
}

}  // namespace boresight::fakes
