// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotctld/entrance.h"

#include "core/base/text.h"

#include <sys/epoll.h>

#include <utility>

namespace boresight::rotctld {
namespace {

class TcpEntrance final : public Entrance
{
public:
    explicit TcpEntrance(Descriptor listener) : m_listener(std::move(listener)) {}

    [[nodiscard]] std::string address() const override { return localAddress(m_listener); }
    [[nodiscard]] std::uint16_t port() const override { return localPort(m_listener); }
    [[nodiscard]] tl::expected<Accepted, AcceptFailure> accept() override { return acceptOne(m_listener); }
    [[nodiscard]] bool isWatched() const override { return m_watched; }

    bool watch(const Descriptor& epoll, std::uint64_t number, bool on) override
    {
        return watchListener(epoll, m_listener, number, std::exchange(m_watched, on), on);
    }

private:
    Descriptor m_listener;
    bool m_watched = false;
};

}  // namespace

Result<ProgramLock> lockPlace(const std::string& path)
{
    return ProgramLock::take(QString::fromStdString(path) + QStringLiteral(".lock")).map_error([](const Error& error) {
        return Error{.code = error.code,
                     .text = error.code == ErrorCode::Busy ? Text::tr("%1 serves this path already").arg(error.text)
                                                           : Text::tr("its folder is missing or cannot be written")};
    });
}

bool watchListener(const Descriptor& epoll, const Descriptor& listener, std::uint64_t number, bool was, bool on)
{
    if (on == was) {
        return false;
    }
    epoll_event event{};
    event.events = EPOLLIN;
    event.data.u64 = number;
    ::epoll_ctl(epoll.get(), on ? EPOLL_CTL_ADD : EPOLL_CTL_DEL, listener.get(), &event);
    return true;
}

Result<std::unique_ptr<Entrance>> openTcp(const std::string& host, std::uint16_t port)
{
    auto listener = listenOn(host, port);
    if (!listener) {
        return tl::unexpected(listener.error());
    }
    return std::make_unique<TcpEntrance>(std::move(*listener));
}

}  // namespace boresight::rotctld
