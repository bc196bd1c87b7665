// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/rotctld/rotator.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <vector>

// A rotator like Hamlib's dummy: azimuth -180…450°, elevation 0…90°, 6°/s on both axes without ramps, park at 0/0,
// positions by the given clock. `fault` makes every request fail. It counts the requests that move or stop it.
namespace boresight::fakes {

class DummyRotator final : public rotctld::Rotator
{
public:
    explicit DummyRotator(const Clock& clock) : m_clock(clock) {}

    [[nodiscard]] std::string info() const override { return "Dummy rotator"; }
    [[nodiscard]] rotctld::Limits limits() const override { return m_limits; }
    [[nodiscard]] Result<SkyPointing> position(const rotctld::Client&) override
    {
        ++questions;
        if (fault) {
            return tl::unexpected(*fault);
        }
        return SkyPointing{.azimuth = m_azimuth.at(m_clock.now()), .elevation = m_elevation.at(m_clock.now()) - sag};
    }
    [[nodiscard]] Result<SkyPointing> target() const override
    {
        const auto goal = [this](const Axis& axis) { return mover == 0 ? axis.target : axis.at(m_clock.now()); };
        return outcome().map([&] { return SkyPointing{.azimuth = goal(m_azimuth), .elevation = goal(m_elevation)}; });
    }
    [[nodiscard]] rotctld::MotionFlags motion() const override
    {
        const auto azimuth = m_azimuth.target - m_azimuth.at(m_clock.now());
        const auto elevation = m_elevation.target - m_elevation.at(m_clock.now());
        return {.movingLeft = azimuth<0.0_deg, .movingRight = azimuth> 0.0_deg,
                .movingUp = elevation > 0.0_deg,
                .movingDown = elevation < 0.0_deg};
    }

    Result<QString> pointTo(const rotctld::Client& /*client*/, const rotctld::PointRequest& request) override
    {
        lastRequest = request;
        if (request.azimuth < m_limits.minAzimuth || request.azimuth > m_limits.maxAzimuth ||
            request.elevation < m_limits.minElevation || request.elevation > m_limits.maxElevation) {
            return failure(ErrorCode::OutOfRange, QStringLiteral("outside the limits"));
        }
        mover = 0;
        return drive(request.azimuth, request.elevation).map([&] { return became; });
    }
    Result<> move(const rotctld::Client& client, rotctld::MoveDirection direction, int speed) override
    {
        lastSpeed = speed;
        mover = client.id;
        switch (direction) {
            case rotctld::MoveDirection::Up:
                return drive(m_azimuth.at(m_clock.now()), m_limits.maxElevation);
            case rotctld::MoveDirection::Down:
                return drive(m_azimuth.at(m_clock.now()), m_limits.minElevation);
            case rotctld::MoveDirection::Left:
                return drive(m_limits.minAzimuth, m_elevation.at(m_clock.now()));
            case rotctld::MoveDirection::Right:
                break;
        }
        return drive(m_limits.maxAzimuth, m_elevation.at(m_clock.now()));
    }
    Result<QString> moveAt(const rotctld::Client& client, rotctld::MoveDirection direction, AngularRate rate) override
    {
        lastRate = rate;
        return move(client, direction, -1).map([this] { return became; });
    }
    Result<> stop(const rotctld::Client& /*client*/) override
    {
        mover = 0;
        ++stops;
        return drive(m_azimuth.at(m_clock.now()), m_elevation.at(m_clock.now()));
    }
    Result<> park(const rotctld::Client& /*client*/) override
    {
        mover = 0;
        return drive(0_deg, 0_deg);
    }
    Result<> reset(const rotctld::Client& /*client*/, int /*kind*/) override { return outcome(); }

    [[nodiscard]] int speedLevel() const override { return m_speedLevel; }
    Result<> setSpeedLevel(const rotctld::Client& /*client*/, int level) override
    {
        m_speedLevel = level;
        return outcome();
    }

    void clientConnected(const rotctld::Client& client) override { connected[client.id] = client.address; }
    void clientGone(const rotctld::Client& client, const QString& reason) override
    {
        gone[client.id] = reason.toStdString();
        if (mover == client.id) {
            static_cast<void>(stop(client));
        }
    }
    void clientRemark(const rotctld::Client& /*client*/, const QString& text) override
    {
        remarks.push_back(text.toStdString());
    }

    std::optional<Error> fault;
    Angle sag{};     // how far it stands below its target
    QString became;  // in words: what became of an accepted target
    std::optional<rotctld::PointRequest> lastRequest;
    int lastSpeed = 0;
    std::optional<AngularRate> lastRate;  // of the last moveAt
    int actions = 0;                      // calls that would move or stop a mount, accepted or refused
    int questions = 0;                    // queries of the position
    int stops = 0;
    std::uint64_t mover = 0;
    std::map<std::uint64_t, std::string> connected;
    std::map<std::uint64_t, std::string> gone;
    std::vector<std::string> remarks;

private:
    struct Axis
    {
        Angle start;
        Angle target;
        SteadyTime since;

        [[nodiscard]] Angle at(SteadyTime now) const
        {
            const Angle reach = 6.0_deg_s * Seconds(now - since);
            return std::clamp(target, start - reach, start + reach);
        }
    };

    Result<> outcome() const { return fault ? Result<>(tl::unexpected(*fault)) : Result<>(); }
    Result<> drive(Angle azimuth, Angle elevation)
    {
        ++actions;
        if (!fault) {
            const SteadyTime now = m_clock.now();
            m_azimuth = {.start = m_azimuth.at(now), .target = azimuth, .since = now};
            m_elevation = {.start = m_elevation.at(now), .target = elevation, .since = now};
        }
        return outcome();
    }

    const Clock& m_clock;
    rotctld::Limits m_limits{
        .minAzimuth = -180_deg, .maxAzimuth = 450_deg, .minElevation = 0_deg, .maxElevation = 90_deg};
    Axis m_azimuth;
    Axis m_elevation;
    int m_speedLevel = 0;
};

}  // namespace boresight::fakes
