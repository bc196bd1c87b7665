// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/rotctld/rotator.h"
#include "tests/fuzz/harness.h"

#include <QString>

#include <algorithm>

// A rotator that refuses every kind of request by default, so that a protocol cannot request what it has no words for.
// A fuzz target allows the requests of its protocol.
namespace boresight::fuzz {

class StrictRotator : public rotctld::Rotator
{
public:
    explicit StrictRotator(const SkyPointing& place) : m_place(place) {}

    [[nodiscard]] std::string info() const override { return "strict rotator"; }
    [[nodiscard]] rotctld::Limits limits() const override { return {-180_deg, 180_deg, 0_deg, 90_deg}; }
    [[nodiscard]] Result<SkyPointing> position(const rotctld::Client&) override { return target(); }
    [[nodiscard]] Result<SkyPointing> target() const override
    {
        if (refuses) {
            return failure(ErrorCode::NoAnswer, QStringLiteral("the drives are silent"));
        }
        return m_place;
    }
    [[nodiscard]] rotctld::MotionFlags motion() const override { return {}; }
    Result<QString> pointTo(const rotctld::Client&, const rotctld::PointRequest& request) override
    {
        require(abs(request.azimuth) <= 3600_deg, "an azimuth is within -3600°…3600°");
        require(request.elevation >= -90_deg && request.elevation <= 180_deg, "an elevation is within -90°…180°");
        return moved().map([] { return QString(); });
    }
    Result<> move(const rotctld::Client&, rotctld::MoveDirection, int) override { return unspoken(); }
    Result<QString> moveAt(const rotctld::Client&, rotctld::MoveDirection, AngularRate) override
    {
        return unspoken().map([] { return QString(); });
    }
    Result<> stop(const rotctld::Client&) override { return outcome(); }
    Result<> park(const rotctld::Client&) override { return unspoken(); }
    Result<> reset(const rotctld::Client&, int) override { return unspoken(); }
    [[nodiscard]] int speedLevel() const override { return 2; }
    Result<> setSpeedLevel(const rotctld::Client&, int) override { return unspoken(); }
    void clientConnected(const rotctld::Client&) override {}
    void clientGone(const rotctld::Client&, const QString&) override {}
    void clientRemark(const rotctld::Client&, const QString& text) override
    {
        require(text.toUtf8().size() < 512, "a remark fits a line of the log");
        require(std::ranges::all_of(text, [](QChar one) { return one.isPrint(); }), "a remark is printable");
    }

    bool refuses = false;
    int motions = 0;

protected:
    [[nodiscard]] Result<> outcome() const
    {
        return refuses ? Result<>(failure(ErrorCode::Refused, QStringLiteral("STOP is latched"))) : Result<>();
    }
    [[nodiscard]] Result<> moved()
    {
        ++motions;
        return outcome();
    }

private:
    static Result<> unspoken()
    {
        require(false, "the protocol has no words for it");
        return {};
    }

    SkyPointing m_place;
};

}  // namespace boresight::fuzz
