// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/clients/protocol_log.h"
#include "core/rotctld/rotator.h"

// The mount of all clients, with the protocol log. Every protocol uses the mount through this class, so the log reads
// here what a line means: a new protocol needs no words of its own. While the log is off each call only goes on to the
// rotator. Station thread.
namespace boresight {

class LoggedRotator final : public rotctld::Rotator
{
public:
    // Both outlive this.
    LoggedRotator(rotctld::Rotator& rotator, ProtocolLog& log) : m_rotator(rotator), m_log(log) {}

    [[nodiscard]] std::string info() const override { return m_rotator.info(); }
    [[nodiscard]] rotctld::Limits limits() const override { return m_rotator.limits(); }
    [[nodiscard]] Result<SkyPointing> position(const rotctld::Client& client) override;
    [[nodiscard]] Result<SkyPointing> target() const override;
    [[nodiscard]] rotctld::MotionFlags motion() const override;

    Result<QString> pointTo(const rotctld::Client& client, const rotctld::PointRequest& request) override;
    Result<> move(const rotctld::Client& client, rotctld::MoveDirection direction, int speed) override;
    Result<QString> moveAt(const rotctld::Client& client, rotctld::MoveDirection direction, AngularRate rate) override;
    Result<> stop(const rotctld::Client& client) override;
    Result<> park(const rotctld::Client& client) override;
    Result<> reset(const rotctld::Client& client, int kind) override;

    [[nodiscard]] int speedLevel() const override { return m_rotator.speedLevel(); }
    Result<> setSpeedLevel(const rotctld::Client& client, int level) override;

    void clientConnected(const rotctld::Client& client) override { m_rotator.clientConnected(client); }
    void clientGone(const rotctld::Client& client, const QString& reason) override
    {
        m_rotator.clientGone(client, reason);
    }
    void clientRemark(const rotctld::Client& client, const QString& text) override
    {
        m_rotator.clientRemark(client, text);
    }

    [[nodiscard]] bool isLoggingExchanges() const override { return m_log.isOn(); }
    void logExchange(const rotctld::Client& client, const rotctld::Exchange& exchange) override
    {
        m_log.add(client, exchange);
    }

private:
    void note(const ProtocolAct& act) const;

    rotctld::Rotator& m_rotator;
    ProtocolLog& m_log;
};

}  // namespace boresight
