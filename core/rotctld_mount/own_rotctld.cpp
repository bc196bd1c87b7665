// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotctld_mount/own_rotctld.h"

#include "core/base/control_characters.h"
#include "core/base/text.h"
#include "core/rotctld_mount/hamlib_models.h"

#include <QDir>
#include <QFile>
#include <QHostAddress>
#include <QStandardPaths>
#include <QTcpServer>

#include <sys/prctl.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <utility>

namespace boresight::rotctl {
namespace {

constexpr qsizetype kMostErrors = 1000;  // bytes of error output that are kept
constexpr std::chrono::milliseconds kBetweenLooks{50};

// rotctld accepts no open socket, so another program may take this port first. look() detects that.
quint16 freePort()
{
    QTcpServer server;
    return server.listen(QHostAddress::LocalHost) ? server.serverPort() : quint16{0};
}

// The inode of the socket that listens on the port, as "socket:[123]". Empty if no socket does.
QString listenerOn(quint16 port)
{
    constexpr int kLocal = 1;  // columns of proc(5), /proc/net/tcp
    constexpr int kState = 3;
    constexpr int kInode = 9;
    QFile table(QStringLiteral("/proc/net/tcp"));
    if (!table.open(QIODevice::ReadOnly)) {
        return {};
    }
    const QString address = QStringLiteral("0100007F:%1").arg(port, 4, 16, QLatin1Char('0')).toUpper();  // 127.0.0.1
    for (const QString& line : QString::fromLatin1(table.readAll()).split(QLatin1Char('\n'))) {
        const QStringList fields = line.simplified().split(QLatin1Char(' '));
        if (fields.value(kLocal) == address && fields.value(kState) == QLatin1String("0A")) {
            return QStringLiteral("socket:[%1]").arg(fields.value(kInode));
        }
    }
    return {};
}

bool hasOpen(qint64 process, const QString& socket)
{
    const QDir files(QStringLiteral("/proc/%1/fd").arg(process));
    // The links point to no files, so they need QDir::System.
    for (const QString& name : files.entryList(QDir::AllEntries | QDir::System | QDir::NoDotAndDotDot)) {
        const QByteArray path = files.filePath(name).toLocal8Bit();
        QByteArray target(64, '\0');
        const auto length = ::readlink(path.constData(), target.data(), static_cast<std::size_t>(target.size()));
        if (length > 0 && QString::fromLatin1(target.left(length)) == socket) {
            return true;
        }
    }
    return false;
}

QStringList argumentsOf(const HamlibRotator& rotator, quint16 port)
{
    QStringList all{QStringLiteral("-m"), QString::number(rotator.bus.model)};
    if (!rotator.bus.target.empty()) {
        all << QStringLiteral("-r") << QString::fromStdString(rotator.bus.target) << QStringLiteral("-s")
            << QString::number(rotator.baud);
    }
    for (const std::string& setting : rotator.settings) {
        all << QStringLiteral("-C") << QString::fromStdString(setting);
    }
    return all << QStringLiteral("-T") << QStringLiteral("127.0.0.1") << QStringLiteral("-t") << QString::number(port);
}

}  // namespace

OwnRotctld::OwnRotctld(HamlibRotator rotator, QObject* parent) : QObject(parent), m_rotator(std::move(rotator))
{
    m_process.setStandardInputFile(QProcess::nullDevice());
    m_process.setStandardOutputFile(QProcess::nullDevice());
    m_process.setChildProcessModifier([parent = ::getpid()] {
        // Ctrl+C in the terminal of Boresight, or a signal to all processes of its service, must not end rotctld before
        // its last command. Boresight kills it afterwards.
        ::setpgid(0, 0);
        sigset_t ends;
        ::sigemptyset(&ends);
        ::sigaddset(&ends, SIGTERM);
        ::sigaddset(&ends, SIGHUP);
        ::sigprocmask(SIG_BLOCK, &ends, nullptr);
        ::prctl(PR_SET_PDEATHSIG, SIGKILL);
        if (::getppid() != parent) {
            ::_exit(1);  // Boresight ended in the meantime
        }
    });
    m_limit.setSingleShot(true);
    connect(&m_limit, &QTimer::timeout, this, &OwnRotctld::limitReached);
    connect(&m_look, &QTimer::timeout, this, &OwnRotctld::look);
    connect(&m_process, &QProcess::readyReadStandardError, this, &OwnRotctld::keepErrors);
    connect(&m_process, &QProcess::finished, this, &OwnRotctld::finish);
    connect(&m_process, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
        if (error == QProcess::FailedToStart) {
            fail(Text::tr("rotctld could not be started: %1").arg(m_process.errorString()));
        }
    });
}

// The last command, usually a stop, reaches the rotator first. The next rotctld needs the serial port.
OwnRotctld::~OwnRotctld()
{
    m_process.disconnect(this);
    if (runs()) {
        m_process.waitForFinished(m_ending ? std::max(0, m_limit.remainingTime()) : 0);
        m_process.kill();
        m_process.waitForFinished();
    }
}

void OwnRotctld::start()
{
    if (runs()) {
        return;
    }
    m_ending = false;
    m_errors.clear();
    const QString path = QStandardPaths::findExecutable(QStringLiteral("rotctld"));
    if (path.isEmpty()) {
        fail(hamlibIsMissing());
        return;
    }
    m_port = freePort();
    m_limit.start(kStartTime);
    m_look.start(kBetweenLooks);
    m_process.start(path, argumentsOf(m_rotator, m_port), QIODevice::ReadOnly);
}

void OwnRotctld::end()
{
    m_look.stop();
    if (runs() && !m_ending) {
        m_ending = true;
        m_limit.start(kLastOrder);
    }
}

// If another program has taken the port, rotctld ends by itself.
void OwnRotctld::look()
{
    const QString socket = listenerOn(m_port);
    if (!socket.isEmpty() && m_process.state() == QProcess::Running && hasOpen(m_process.processId(), socket)) {
        m_look.stop();
        m_limit.stop();
        Q_EMIT listens(m_port);
    }
}

void OwnRotctld::keepErrors()
{
    m_errors = (m_errors + m_process.readAllStandardError()).right(kMostErrors);
}

void OwnRotctld::finish()
{
    keepErrors();
    m_limit.stop();
    if (std::exchange(m_ending, false)) {
        return;
    }
    fail(howItEnded());
}

// Hamlib does not print which of its settings it refuses.
QString OwnRotctld::howItEnded() const
{
    if (m_process.exitStatus() == QProcess::CrashExit) {
        return Text::tr("rotctld was killed or crashed") + lastWords();
    }
    if (!m_rotator.settings.empty() && m_errors.contains("Config parameter error")) {
        return Text::tr(
                   "Hamlib refuses a setting of bus.hamlib_settings. \"rotctl -m %1 -L\" lists the settings of "
                   "this model")
            .arg(m_rotator.bus.model);
    }
    return Text::tr("rotctld ended with status %1").arg(m_process.exitCode()) + lastWords();
}

void OwnRotctld::limitReached()
{
    m_process.kill();
    if (!m_ending) {
        const QString how = m_look.isActive() ? Text::tr("rotctld did not start within %1 s").arg(kStartTime.count())
                                              : Text::tr("rotctld closed the connection");
        fail(how + lastWords());
    }
}

void OwnRotctld::fail(const QString& reason)
{
    m_look.stop();
    m_limit.stop();
    m_ending = true;  // its end needs no further report
    Q_EMIT failed(reason);
}

// The last line contains the kind of error, and the line before it the port: "serial_open: Unable to open /dev/ttyUSB0
// - No such file or directory", "IO error".
QString OwnRotctld::lastWords() const
{
    constexpr qsizetype kLines = 2;
    QStringList lines;
    for (const QString& line : QString::fromUtf8(m_errors).split(QLatin1Char('\n'))) {
        if (const QString words = line.trimmed(); !words.isEmpty()) {
            lines << printable(words);
        }
    }
    const QString last = lines.mid(std::max<qsizetype>(0, lines.size() - kLines)).join(QStringLiteral("; "));
    return last.isEmpty() ? QString() : QStringLiteral(": ") + last;
}

}  // namespace boresight::rotctl

#include "moc_own_rotctld.cpp"
