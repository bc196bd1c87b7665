// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/log_output.h"

#include <QByteArray>
#include <QtGlobal>

#include <poll.h>
#include <unistd.h>

#include <csignal>
#include <cstddef>
#include <cstdio>
#include <cstdlib>

namespace boresight::app {
namespace {

// A pipe that poll() reports as writable takes at least this much at once (PIPE_BUF: 512 by POSIX, 4096 on Linux).
constexpr qsizetype kLongestLine = 4096;

void writeLine(QtMsgType type, const QMessageLogContext& context, const QString& message)
{
    const QByteArray line = qFormatLogMessage(type, context, message).toUtf8().left(kLongestLine - 1) + '\n';
    pollfd target{.fd = STDERR_FILENO, .events = POLLOUT, .revents = 0};
    if (::poll(&target, 1, 0) == 1 && (target.revents & POLLOUT) != 0) {
        [[maybe_unused]] const auto written =
            ::write(STDERR_FILENO, line.constData(), static_cast<std::size_t>(line.size()));
    }
    if (type == QtFatalMsg) {
        std::abort();
    }
}

}  // namespace

void logToStandardError()
{
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
    qInstallMessageHandler(writeLine);
}

void printError(const QString& line)
{
    std::fputs((line.toUtf8() + '\n').constData(), stderr);
}

}  // namespace boresight::app
