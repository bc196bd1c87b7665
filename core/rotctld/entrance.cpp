// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotctld/entrance.h"

#include <sys/epoll.h>

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
        if (on == m_watched) {
            return false;
        }
        epoll_event event{};
        event.events = EPOLLIN;
        event.data.u64 = number;
        ::epoll_ctl(epoll.get(), on ? EPOLL_CTL_ADD : EPOLL_CTL_DEL, m_listener.get(), &event);
        m_watched = on;
        return true;
    }

private:
    Descriptor m_listener;
    bool m_watched = false;
};

}  // namespace

Result<std::unique_ptr<Entrance>> openTcp(const std::string& host, std::uint16_t port)
{
    auto listener = listenOn(host, port);
    if (!listener) {
        return tl::unexpected(listener.error());
    }
    return std::make_unique<TcpEntrance>(std::move(*listener));
}

}  // namespace boresight::rotctld
