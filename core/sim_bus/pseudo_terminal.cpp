// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim_bus/pseudo_terminal.h"

#include "core/base/text.h"

#include <QFile>
#include <QFileInfo>

#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <termios.h>

#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

namespace boresight::sim {
namespace {

// Raw: no echo and no translation. The settings apply to both ends.
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

Result<> makeLink(const QString& device, const QString& link)
{
    if (QFileInfo(link).isSymLink()) {
        QFile::remove(link);  // left from an earlier run
    }
    if (QFile::link(device, link)) {
        return {};
    }
    return failure(ErrorCode::Io,
                   QStringLiteral("cannot make the link %1 to %2: choose a name that does not exist in a "
                                  "folder you may write to")
                       .arg(link, device));
}

}  // namespace

Result<PseudoTerminal> PseudoTerminal::create(const QString& link)
{
    FileDescriptor master(::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
    std::array<char, 64> path{};
    if (!master.isOpen() || ::grantpt(master.number()) != 0 || ::unlockpt(master.number()) != 0 ||
        ::ptsname_r(master.number(), path.data(), path.size()) != 0 || !makeRaw(path.data())) {
        return failure(
            ErrorCode::Io,
            QStringLiteral("cannot open a pseudo-terminal: %1").arg(toQString(std::system_category().message(errno))));
    }
    const QString device = QString::fromLocal8Bit(path.data());
    if (const Result<> linked = makeLink(device, link); !linked) {
        return tl::unexpected(linked.error());
    }
    return PseudoTerminal(std::move(master), device, link);
}

PseudoTerminal::PseudoTerminal(FileDescriptor master, QString device, QString link)
    : m_master(std::move(master)), m_device(std::move(device)), m_link(std::move(link))
{}

PseudoTerminal::~PseudoTerminal()
{
    if (m_master.isOpen() && QFile::symLinkTarget(m_link) == m_device) {
        QFile::remove(m_link);
    }
}

bool PseudoTerminal::hasClient() const
{
    pollfd state{.fd = m_master.number(), .events = POLLIN, .revents = 0};
    return ::poll(&state, 1, 0) >= 0 && (state.revents & POLLHUP) == 0;
}

}  // namespace boresight::sim
