// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text.h"
#include "core/rotctld/entrance.h"

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

namespace boresight::rotctld {
namespace {

constexpr mode_t kOfTheUser = 0600;
constexpr int kUnixBacklog = 16;

tl::unexpected<Error> cannotListen(const std::string& path, ErrorCode code, const QString& reason)
{
    return failure(code, Text::tr("cannot serve the socket %1: %2").arg(toQString(path), reason));
}

tl::unexpected<Error> systemFailure(const std::string& path)
{
    return cannotListen(path, ErrorCode::Io, toQString(std::strerror(errno)));
}

sockaddr_un addressOf(const std::string& path)
{
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::ranges::copy(path, std::begin(address.sun_path));
    return address;
}

Descriptor newSocket()
{
    return Descriptor(::socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
}

bool isServed(const std::string& path)
{
    const sockaddr_un address = addressOf(path);
    const void* const untyped = &address;
    return ::connect(newSocket().get(), static_cast<const sockaddr*>(untyped), sizeof address) == 0 ||
           errno != ECONNREFUSED;
}

class UnixEntrance final : public Entrance
{
public:
    explicit UnixEntrance(std::string path) : m_path(std::move(path)) {}
    UnixEntrance(const UnixEntrance&) = delete;
    UnixEntrance& operator=(const UnixEntrance&) = delete;
    ~UnixEntrance() override;

    [[nodiscard]] Result<> open();

    [[nodiscard]] std::string address() const override { return m_path; }
    [[nodiscard]] tl::expected<Accepted, AcceptFailure> accept() override;
    [[nodiscard]] bool isWatched() const override { return m_watched; }
    bool watch(const Descriptor& epoll, std::uint64_t number, bool on) override;

private:
    [[nodiscard]] Result<> removeStale() const;
    [[nodiscard]] bool isOurs() const;

    std::string m_path;
    ProgramLock m_lock;
    Descriptor m_listener;
    ino_t m_file = 0;  // inode of the socket; 0: there is none yet
    bool m_watched = false;
};

UnixEntrance::~UnixEntrance()
{
    if (isOurs()) {
        ::unlink(m_path.c_str());
    }
}

bool UnixEntrance::isOurs() const
{
    struct stat found
    {};
    return m_file != 0 && ::lstat(m_path.c_str(), &found) == 0 && found.st_ino == m_file;
}

// The socket of a killed program has no listener, so it is removed. Other files stay.
Result<> UnixEntrance::removeStale() const
{
    struct stat found
    {};
    if (::lstat(m_path.c_str(), &found) != 0) {
        return {};
    }
    if (!S_ISSOCK(found.st_mode)) {
        return cannotListen(m_path, ErrorCode::Busy, Text::tr("%1 exists and is not a socket").arg(toQString(m_path)));
    }
    if (isServed(m_path)) {
        return cannotListen(m_path, ErrorCode::Busy, Text::tr("another program listens there"));
    }
    return ::unlink(m_path.c_str()) == 0 ? Result<>() : systemFailure(m_path);
}

// The mode of the socket becomes the mode of its file, so other users can never open it.
Result<> UnixEntrance::open()
{
    if (m_path.size() >= sizeof(sockaddr_un::sun_path)) {
        return cannotListen(m_path, ErrorCode::InvalidInput,
                            Text::tr("a path has at most %1 bytes").arg(sizeof(sockaddr_un::sun_path) - 1));
    }
    Result<ProgramLock> lock = lockPlace(m_path);
    if (!lock) {
        return cannotListen(m_path, lock.error().code, lock.error().text);
    }
    m_lock = std::move(*lock);
    if (Result<> cleared = removeStale(); !cleared) {
        return cleared;
    }
    m_listener = newSocket();
    const sockaddr_un address = addressOf(m_path);
    const void* const untyped = &address;
    struct stat made
    {};
    if (!m_listener.valid() || ::fchmod(m_listener.get(), kOfTheUser) != 0 ||
        ::bind(m_listener.get(), static_cast<const sockaddr*>(untyped), sizeof address) != 0 ||
        ::lstat(m_path.c_str(), &made) != 0) {
        return systemFailure(m_path);
    }
    m_file = made.st_ino;
    return ::listen(m_listener.get(), kUnixBacklog) == 0 ? Result<>() : systemFailure(m_path);
}

bool UnixEntrance::watch(const Descriptor& epoll, std::uint64_t number, bool on)
{
    return watchListener(epoll, m_listener, number, std::exchange(m_watched, on), on);
}

tl::expected<Accepted, AcceptFailure> UnixEntrance::accept()
{
    return acceptOne(m_listener).map([this](Accepted client) {
        ucred program{};
        socklen_t length = sizeof program;
        ::getsockopt(client.socket.get(), SOL_SOCKET, SO_PEERCRED, &program, &length);
        client.address = m_path + ":" + std::to_string(program.pid);
        return client;
    });
}

}  // namespace

Result<std::unique_ptr<Entrance>> openUnix(const std::string& path)
{
    auto entrance = std::make_unique<UnixEntrance>(path);
    return entrance->open().map([&]() -> std::unique_ptr<Entrance> { return std::move(entrance); });
}

}  // namespace boresight::rotctld
