// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/datagrams/datagram_inlet.h"
#include "core/rotctld/client_server.h"
#include "core/udp_server/udp_controller.h"

#include <QObject>

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <string>

// A server of one protocol without connections: each datagram is one command. A host is one client, from its first
// datagram until it was silent for kSilence. A client that the operator made read-only stays, because a new client of
// its host could move the mount. Answers go to the port of the host that follows the port of the server. A flood costs
// at most kAtOnce commands in each DatagramInlet::kPause. Station thread.
namespace boresight::udp {

// The operator or the profile permits this client only to read and to stop.
using IsReadOnly = std::function<bool(std::uint64_t client)>;

class DatagramServer final : public QObject, public rotctld::ClientServer
{
    Q_OBJECT

public:
    static constexpr int kAtOnce = 32;
    static constexpr std::chrono::seconds kSilence{60};

    // The rotator and the clock outlive the server. Nothing is opened before listen().
    DatagramServer(rotctld::ServerSettings settings, Parse parse, rotctld::Rotator& rotator, const Clock& clock,
                   IsReadOnly isReadOnly, QObject* parent = nullptr);
    ~DatagramServer() override;

    Result<> listen() override;
    [[nodiscard]] std::string address() const override;  // "UDP 127.0.0.1:12000"
    [[nodiscard]] std::uint16_t port() const { return m_inlet.port(); }
    [[nodiscard]] std::vector<rotctld::ClientInfo> clients() const override;
    // A client that the operator made read-only stays. The log has that.
    bool disconnect(std::uint64_t id, const QString& reason) override;
    void setMaxClients(std::size_t count) override { m_settings.maxClients = count; }
    void tick() override;

private:
    struct Sender
    {
        rotctld::Client client;
        UdpController controller;
        rotctld::ClientHabits habits;
        SteadyTime lastDatagram{};
    };
    using Senders = std::map<std::string, Sender>;  // by host

    void take(const QByteArray& bytes, const QHostAddress& host, std::uint16_t port);
    [[nodiscard]] Sender& welcome(const rotctld::Client& client, const std::string& host);
    void obey(Sender& sender, std::string_view datagram, const QHostAddress& host);
    [[nodiscard]] bool isMarked(const Sender& sender) const;
    Senders::iterator forget(Senders::iterator sender, const QString& reason);

    rotctld::ServerSettings m_settings;
    Parse m_parse;
    rotctld::Rotator& m_rotator;
    const Clock& m_clock;
    IsReadOnly m_isReadOnly;
    rotctld::Admission m_admission;
    rotctld::Settling m_settling;
    datagrams::DatagramInlet m_inlet;
    Senders m_senders;
};

}  // namespace boresight::udp
