// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text.h"
#include "core/rotctld/entrance.h"

#include <QLoggingCategory>

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <utility>

namespace boresight::rotctld {
namespace {

Q_LOGGING_CATEGORY(lcTerminal, "boresight.terminal")

tl::unexpected<Error> cannotServe(const std::string& path, ErrorCode code, const QString& reason)
{
    return failure(code, Text::tr("cannot serve the pseudo-terminal %1: %2").arg(toQString(path), reason));
}

QString systemReason()
{
    return toQString(std::strerror(errno));
}

// The target of a link. Empty if `path` is no link.
std::string targetOf(const std::string& path)
{
    std::array<char, 128> target{};
    const ssize_t length = ::readlink(path.c_str(), target.data(), target.size());
    return {target.data(), length > 0 ? static_cast<std::size_t>(length) : 0U};
}

class TerminalEntrance final : public Entrance
{
public:
    explicit TerminalEntrance(std::string path) : m_path(std::move(path)) {}
    TerminalEntrance(const TerminalEntrance&) = delete;
    TerminalEntrance& operator=(const TerminalEntrance&) = delete;
    ~TerminalEntrance() override;

    [[nodiscard]] Result<> open();

    [[nodiscard]] std::string address() const override { return m_path; }
    [[nodiscard]] tl::expected<Accepted, AcceptFailure> accept() override;
    void left(bool byItself) override;

private:
    [[nodiscard]] Result<> make();
    [[nodiscard]] Result<> link(const char* terminal) const;
    [[nodiscard]] bool linksHere() const;
    [[nodiscard]] static bool prepare(const char* terminal);

    std::string m_path;
    ProgramLock m_lock;
    Descriptor m_master;
    std::string m_terminal;  // "/dev/pts/7"; empty: there is no terminal now
    bool m_taken = false;
};

TerminalEntrance::~TerminalEntrance()
{
    if (linksHere()) {
        ::unlink(m_path.c_str());
    }
}

Result<> TerminalEntrance::open()
{
    Result<ProgramLock> lock = lockPlace(m_path);
    if (!lock) {
        return cannotServe(m_path, lock.error().code, lock.error().text);
    }
    m_lock = std::move(*lock);
    return make();
}

// Makes terminal and link. If one of them fails, there is neither.
Result<> TerminalEntrance::make()
{
    Descriptor master(::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
    std::array<char, 128> name{};
    const bool opened = master.valid() && ::grantpt(master.get()) == 0 && ::unlockpt(master.get()) == 0 &&
                        ::ptsname_r(master.get(), name.data(), name.size()) == 0 && prepare(name.data());
    const Result<> made = opened ? link(name.data()) : Result<>(cannotServe(m_path, ErrorCode::Io, systemReason()));
    if (!made && linksHere()) {
        // The link would lead to a terminal that is gone. Another terminal may get its name soon.
        ::unlink(m_path.c_str());
    }
    m_master = made ? std::move(master) : Descriptor();
    m_terminal = made ? name.data() : "";
    return made;
}

// Other programs find the terminal by this link at any time, because the link is replaced in one step. A file that is
// no link to a terminal is not replaced.
Result<> TerminalEntrance::link(const char* terminal) const
{
    const std::string fresh = m_path + ".new";
    for (const std::string& path : {m_path, fresh}) {
        struct stat found
        {};
        if (::lstat(path.c_str(), &found) == 0 && !targetOf(path).starts_with("/dev/pts/")) {
            return cannotServe(m_path, ErrorCode::Busy,
                               Text::tr("%1 exists and is not a link to a terminal").arg(toQString(path)));
        }
    }
    ::unlink(fresh.c_str());
    if (::symlink(terminal, fresh.c_str()) != 0 || ::rename(fresh.c_str(), m_path.c_str()) != 0) {
        const auto failed = cannotServe(m_path, ErrorCode::Io, systemReason());
        ::unlink(fresh.c_str());
        return failed;
    }
    return {};
}

bool TerminalEntrance::linksHere() const
{
    return !m_terminal.empty() && targetOf(m_path) == m_terminal;
}

// Makes the terminal raw without echo, and clears what the last client left. A terminal that was opened and closed once
// shows whether a client has it open.
bool TerminalEntrance::prepare(const char* terminal)
{
    constexpr mode_t kOfTheUser = 0600;
    const Descriptor line(::open(terminal, O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
    termios settings{};
    if (!line.valid() || ::tcgetattr(line.get(), &settings) != 0) {
        return false;
    }
    ::cfmakeraw(&settings);
    return ::fchmod(line.get(), kOfTheUser) == 0 && ::tcsetattr(line.get(), TCSANOW, &settings) == 0 &&
           ::tcflush(line.get(), TCIFLUSH) == 0;
}

tl::expected<Accepted, AcceptFailure> TerminalEntrance::accept()
{
    if (!m_master.valid() && !make()) {
        return tl::unexpected(AcceptFailure::NoneWaiting);
    }
    pollfd state{.fd = m_master.get(), .events = POLLIN, .revents = 0};
    if (m_taken || ::poll(&state, 1, 0) < 0) {
        return tl::unexpected(AcceptFailure::NoneWaiting);
    }
    // A program that wrote something and has closed again counts, too: "echo S" to the terminal.
    const bool nobody = (state.revents & POLLHUP) != 0 && (state.revents & POLLIN) == 0;
    Descriptor end(nobody ? -1 : ::fcntl(m_master.get(), F_DUPFD_CLOEXEC, 0));
    if (!end.valid()) {
        return tl::unexpected(AcceptFailure::NoneWaiting);
    }
    m_taken = true;
    return Accepted{.socket = std::move(end), .address = m_path};
}

// A dropped client loses its terminal. The next client opens another terminal by the same link.
void TerminalEntrance::left(bool byItself)
{
    m_taken = false;
    if (byItself && prepare(m_terminal.c_str())) {
        return;
    }
    if (const Result<> made = make(); !made) {
        qCWarning(lcTerminal, "%s", qUtf8Printable(made.error().text));
    }
}

}  // namespace

Result<std::unique_ptr<Entrance>> openTerminal(const std::string& path)
{
    auto entrance = std::make_unique<TerminalEntrance>(path);
    return entrance->open().map([&]() -> std::unique_ptr<Entrance> { return std::move(entrance); });
}

}  // namespace boresight::rotctld
