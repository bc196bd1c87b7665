// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/fakes/tcp_peer.h"

#include <QJsonObject>

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

// Plays one recorded exchange of tests/data/rotctld_cases.json against a rotctld server, and compares the replies by
// its `compare` rule. Everything goes over TCP, also the motion to the starting position of a case. So the same runner
// serves a server in this process with a hand-turned clock, and another program.
namespace boresight::fakes {

struct CaseTarget
{
    std::string host;
    std::uint16_t port = 0;
    TcpPeer::Pump pump;                                                   // see TcpPeer
    std::function<void(std::chrono::milliseconds)> elapse;                // advances the mount's time
    std::chrono::milliseconds patience = std::chrono::milliseconds(500);  // for a reply that does not come as expected
};

class RotctldCaseRunner
{
public:
    explicit RotctldCaseRunner(CaseTarget target) : m_target(std::move(target)) {}

    // Empty when the case passed, else the text of what was sent, expected and received.
    [[nodiscard]] std::string run(const QJsonObject& exchange);

private:
    struct Position
    {
        double azimuth = 0.0;
        double elevation = 0.0;
    };

    TcpPeer& connection(int number);
    std::string play(const QJsonObject& step, const TcpPeer::Enough& fits);
    std::string playToTheEnd(const QJsonObject& step);
    std::string converse(const QJsonObject& step, const TcpPeer::Enough& fits);
    Position position();
    bool reach(Position goal);
    bool settle(Position goal);
    bool moves(const QString& axis, const QString& sign);
    bool stays(double seconds);

    CaseTarget m_target;
    std::map<int, std::unique_ptr<TcpPeer>> m_connections;
    int m_lastConnection = 0;
    std::unique_ptr<TcpPeer> m_observer;
};

[[nodiscard]] std::vector<QJsonObject> loadRotctldCases(const std::string& path);

}  // namespace boresight::fakes
