// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/journal/reconcile.h"
#include "tests/core/journal/example_journal.h"

#include <gmock/gmock.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

// One axis with its journal for the tests of reconcile(), and the result of reconcile().
namespace boresight::journal {

// The mount of scenario S10, with three kinds of drive. The drive counts in turns of the axis, from -0.5 to 0.5 of its
// ambiguity at power-up.
enum class Kind
{
    OutputEncoder,  // 360°
    FiveToOne,      // 72°
    HundredToOne    // 3.6°
};

inline double ratioOf(Kind kind)
{
    return kind == Kind::OutputEncoder ? 1.0 : kind == Kind::FiveToOne ? 0.2 : 0.01;
}

// The home state until the position is set.
inline moteus::HomeState homeStateOf(Kind kind)
{
    return kind == Kind::OutputEncoder ? moteus::HomeState::Output : moteus::HomeState::Rotor;
}

inline pointing::AxisGeometry axisOf()
{
    return {.travel = {Angle::fromDegrees(-360.0), Angle::fromDegrees(450.0)}};
}

inline MotorTurns turnsAt(double degrees)
{
    return MotorTurns::fromTurns(degrees / 360.0);
}

// A journal of 12 minutes ago, and a drive that has been on for an hour and counted all that time. The axis has not
// moved from 405°.
struct Scene
{
    explicit Scene(Kind kind = Kind::OutputEncoder)
        : frame{.drive = kAzimuthDrive,
                .reported = turnsAt(405.0),
                .homeState = homeStateOf(kind),
                .uptime = std::chrono::hours(1),
                .origin = moteus::CountOrigin{.beginning = 65793, .offset = turnsAt(7.0)},
                .outputEncoder = kind == Kind::OutputEncoder,
                .period = ambiguity(axisOf(), ratioOf(kind), kind == Kind::OutputEncoder)},
          evidence{.record = TurnRecord{.drive = kAzimuthDrive,
                                        .angle = 405_deg,
                                        .reported = turnsAt(405.0),
                                        .counted = 405_deg,
                                        .uptime = std::chrono::hours(1) - std::chrono::minutes(12),
                                        .homeState = homeStateOf(kind),
                                        .origin = moteus::CountOrigin{.beginning = 65793, .offset = turnsAt(7.0)},
                                        .when = kWhen - std::chrono::minutes(12),
                                        .host = {.boot = kBoot,
                                                 .sinceBoot = std::chrono::hours(20) - std::chrono::minutes(12)}},
                   .now = kWhen,
                   .host = {.boot = kBoot, .sinceBoot = std::chrono::hours(20)}}
    {}

    // Power came back 34 s ago, and the axis stands at `degrees`. The count of the drive is within half its ambiguity
    // of zero.
    Scene& powerCycledAt(double degrees)
    {
        const double places = std::round(degrees / frame.period.degrees());
        frame.reported = turnsAt(degrees - places * frame.period.degrees());
        frame.uptime = std::chrono::seconds(34);
        return *this;
    }

    // Another tool has set the position value to `degrees` of the axis. The axis did not move.
    Scene& setTo(double degrees)
    {
        frame.origin->offset = frame.origin->offset + (turnsAt(degrees) - frame.reported);
        frame.reported = turnsAt(degrees);
        frame.homeState = moteus::HomeState::Output;
        return *this;
    }

    Scene& dirty()
    {
        evidence.record->moving = true;
        return *this;
    }

    Scene& clockStepped(Seconds step)
    {
        evidence.now += std::chrono::duration_cast<UtcTime::duration>(step);
        return *this;
    }

    // The computer was restarted 5 min ago.
    Scene& hostRestarted(bool thenExact, bool nowExact)
    {
        evidence.record->host.utcIsExact = thenExact;
        evidence.host = {.boot = kElevationDrive, .sinceBoot = std::chrono::minutes(5), .utcIsExact = nowExact};
        return *this;
    }

    [[nodiscard]] Judgement judged() const { return reconcile(frame, evidence, axis); }

    [[nodiscard]] TurnQuestion question() const
    {
        const Judgement judgement = judged();
        const auto* asked = std::get_if<TurnQuestion>(&judgement);
        if (asked == nullptr) {
            ADD_FAILURE() << "certain: " << std::get<Certain>(judgement).why.toStdString();
            return {};
        }
        EXPECT_EQ(asked->period, frame.period);
        EXPECT_EQ(asked->movedSince, Angle());
        return *asked;
    }

    // In degrees, or nothing if the operator must be asked.
    [[nodiscard]] std::optional<double> certain() const
    {
        const Judgement judgement = judged();
        const auto* known = std::get_if<Certain>(&judgement);
        return known != nullptr ? std::optional(known->angle.degrees()) : std::nullopt;
    }

    [[nodiscard]] std::vector<std::string> sentences() const
    {
        std::vector<std::string> all;
        for (const QString& sentence : question().evidence) {
            all.push_back(sentence.toStdString());
        }
        return all;
    }

    pointing::AxisGeometry axis = axisOf();
    DriveFrame frame;
    Evidence evidence;
};

inline std::vector<double> inDegrees(const std::vector<Angle>& angles)
{
    std::vector<double> all;
    for (const Angle angle : angles) {
        all.push_back(std::round(angle.degrees() * 1e6) / 1e6);
    }
    return all;
}

inline testing::Matcher<std::optional<double>> isAt(double degrees)
{
    return testing::Optional(testing::DoubleNear(degrees, 1e-6));
}

inline testing::Matcher<std::optional<Angle>> proposes(double degrees)
{
    return testing::Optional(
        testing::ResultOf([](Angle angle) { return angle.degrees(); }, testing::DoubleNear(degrees, 1e-6)));
}

}  // namespace boresight::journal
