// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim_bus/pty_server.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <utility>

namespace boresight::sim {
namespace {

using namespace std::chrono_literals;

constexpr qsizetype kMostUnsent = 65536;  // if the client does not read, further lines are lost

}  // namespace

Result<std::unique_ptr<PtyServer>> PtyServer::create(const QString& link, SimulatedPair& pair, const Clock& clock)
{
    return PseudoTerminal::create(link).map([&](PseudoTerminal&& terminal) {
        return std::unique_ptr<PtyServer>(new PtyServer(std::move(terminal), pair, clock));
    });
}

PtyServer::PtyServer(PseudoTerminal terminal, SimulatedPair& pair, const Clock& clock)
    : m_terminal(std::move(terminal)),
      m_pair(pair),
      m_clock(clock),
      m_epoch(clock.now()),
      m_begin(pair.now()),
      m_server(pair),
      m_readable(m_terminal.number(), QSocketNotifier::Read),
      m_writable(m_terminal.number(), QSocketNotifier::Write)
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

void PtyServer::read()
{
    std::array<char, 4096> buffer{};
    const ssize_t size = ::read(m_terminal.number(), buffer.data(), buffer.size());
    if (size > 0) {
        write(m_server.receive({buffer.data(), static_cast<std::size_t>(size)}, now()));
        answerDue();
    } else if (size < 0 && errno != EAGAIN && errno != EINTR) {
        // EIO: the client has closed. The terminal would now be "readable" all the time, so a timer looks for the next
        // client.
        m_server.clientGone();
        m_unsent.clear();
        m_writable.setEnabled(false);
        m_readable.setEnabled(false);
        m_absent.start();
    }
}

void PtyServer::watchForClient()
{
    if (m_terminal.hasClient()) {
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
            ::write(m_terminal.number(), m_unsent.constData(), static_cast<std::size_t>(m_unsent.size()));
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

#include "moc_pty_server.cpp"
