// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim/pty_server.h"

#include <QFile>
#include <QFileInfo>

#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <termios.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <system_error>

namespace boresight::sim {
namespace {

using namespace std::chrono_literals;

constexpr qsizetype kMostUnsent = 65536;  // a client that does not read loses lines

Error systemError(const std::string& what)
{
    return {ErrorCode::Io, what + ": " + std::system_category().message(errno)};
}

// Raw, so that nothing is echoed or translated; the settings stay with the pair of terminals.
bool makeRaw(const char* path)
{
    const FileDescriptor slave(::open(path, O_RDWR | O_NOCTTY | O_CLOEXEC));
    termios settings{};
    if (!slave.isOpen() || ::tcgetattr(slave.number(), &settings) != 0) {
        return false;
    }
    ::cfmakeraw(&settings);
    return ::tcsetattr(slave.number(), TCSANOW, &settings) == 0;
}

Result<> makeLink(const QString& terminal, const QString& link)
{
    if (QFileInfo(link).isSymLink()) {
        QFile::remove(link);  // left behind by an earlier run
    }
    if (QFile::link(terminal, link)) {
        return {};
    }
    return failure(ErrorCode::Io, "cannot make the link " + link.toStdString() + " to " + terminal.toStdString() +
                                      ": choose a name that does not exist in a folder you may write to");
}

}  // namespace

Result<std::unique_ptr<PtyServer>> PtyServer::create(const QString& link, SimulatedPair& pair, const Clock& clock)
{
    FileDescriptor master(::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
    std::array<char, 64> path{};
    if (!master.isOpen() || ::grantpt(master.number()) != 0 || ::unlockpt(master.number()) != 0 ||
        ::ptsname_r(master.number(), path.data(), path.size()) != 0 || !makeRaw(path.data())) {
        return tl::unexpected(systemError("cannot open a pseudo-terminal"));
    }
    const QString terminal = QString::fromLocal8Bit(path.data());
    if (const Result<> linked = makeLink(terminal, link); !linked) {
        return tl::unexpected(linked.error());
    }
    return std::unique_ptr<PtyServer>(new PtyServer(std::move(master), terminal, link, pair, clock));
}

PtyServer::PtyServer(FileDescriptor master, QString terminal, QString link, SimulatedPair& pair, const Clock& clock)
    : m_master(std::move(master)),
      m_terminal(std::move(terminal)),
      m_link(std::move(link)),
      m_pair(pair),
      m_clock(clock),
      m_epoch(clock.now()),
      m_begin(pair.now()),
      m_server(pair),
      m_readable(m_master.number(), QSocketNotifier::Read),
      m_writable(m_master.number(), QSocketNotifier::Write)
{
    m_writable.setEnabled(false);
    m_due.setSingleShot(true);
    m_due.setTimerType(Qt::PreciseTimer);
    m_absent.setInterval(20ms);
    connect(&m_readable, &QSocketNotifier::activated, this, &PtyServer::read);
    connect(&m_writable, &QSocketNotifier::activated, this, &PtyServer::flush);
    connect(&m_due, &QTimer::timeout, this, &PtyServer::answerDue);
    connect(&m_absent, &QTimer::timeout, this, &PtyServer::watchForClient);
    connect(&m_present, &QTimer::timeout, this, [this] { m_pair.advanceTo(now()); });
    m_present.start(100ms);
}

PtyServer::~PtyServer()
{
    if (QFile::symLinkTarget(m_link) == m_terminal) {
        QFile::remove(m_link);
    }
}

void PtyServer::read()
{
    std::array<char, 4096> buffer{};
    const ssize_t size = ::read(m_master.number(), buffer.data(), buffer.size());
    if (size > 0) {
        write(m_server.receive({buffer.data(), static_cast<std::size_t>(size)}, now()));
        answerDue();
    } else if (size < 0 && errno != EAGAIN && errno != EINTR) {
        // EIO: the client has closed. The terminal would be "readable" for ever: look again from time to time.
        m_server.clientGone();
        m_unsent.clear();
        m_writable.setEnabled(false);
        m_readable.setEnabled(false);
        m_absent.start();
    }
}

void PtyServer::watchForClient()
{
    pollfd state{.fd = m_master.number(), .events = POLLIN, .revents = 0};
    if (::poll(&state, 1, 0) >= 0 && (state.revents & POLLHUP) == 0) {
        m_absent.stop();
        m_readable.setEnabled(true);
    }
}

void PtyServer::write(const std::string& bytes)
{
    if (m_unsent.size() < kMostUnsent) {
        m_unsent.append(bytes.data(), static_cast<qsizetype>(bytes.size()));
    }
    flush();
}

void PtyServer::flush()
{
    if (!m_unsent.isEmpty()) {
        const ssize_t size =
            ::write(m_master.number(), m_unsent.constData(), static_cast<std::size_t>(m_unsent.size()));
        m_unsent.remove(0, std::max<ssize_t>(size, 0));
    }
    m_writable.setEnabled(!m_unsent.isEmpty());
}

void PtyServer::answerDue()
{
    write(m_server.takeDue(now()));
    if (const std::optional<Seconds> next = m_server.nextDue()) {
        m_due.start(static_cast<int>(std::ceil(std::max((*next - now()).count(), 0.0) * 1000.0)));
    }
}

}  // namespace boresight::sim
