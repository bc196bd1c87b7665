// SPDX-License-Identifier: GPL-3.0-or-later
// A position that is called certain must be true. After a record was made, a mount, its drive and a computer go through
// random events: motion by hand, power cuts, restarts, clock steps, a position set by other tools, other
// encoder settings, another drive, another profile. Then the reports of the drive and the clocks are judged, and
// compared with the true position of the axis.
#include "core/journal/reconcile.h"
#include "tests/core/journal/example_journal.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace boresight::journal {
namespace {

using moteus::HomeState;
using pointing::AxisGeometry;
using pointing::GearIn;

constexpr double kUptimePeriod = 4294967.296;  // s
constexpr double kDay = 86400.0;

class World
{
public:
    explicit World(std::uint64_t seed) : m_random(seed)
    {
        m_axis.sign = chance(0.5) ? 1 : -1;
        m_axis.offset = Angle::fromDegrees(uniform(-180.0, 180.0));
        m_axis.travel.min = Angle::fromDegrees(uniform(-400.0, 0.0));
        m_axis.travel.max = m_axis.travel.min + Angle::fromDegrees(uniform(30.0, 800.0));
        m_outputEncoder = chance(0.4);
        double ratio = m_outputEncoder || chance(0.2) ? 1.0 : chance(0.5) ? 0.2 : 0.01;
        if (!m_outputEncoder && chance(0.3)) {  // the host applies the gear ratio, and the drive counts its rotor
            m_axis.gearIn = GearIn::Host;
            m_axis.gearRatio = 1.0 / ratio;
            ratio = 1.0;
        }
        m_placeTurns = ratio;
        m_period = ambiguity(m_axis, ratio, m_outputEncoder);
        m_driveRate = uniform(0.98, 1.015);
        m_batteryClock = chance(0.5);
        m_switchedTogether = chance(0.3);
        moveByHand();
        bootHost();
        bootDrive();
        if (!m_switchedTogether) {
            pass(anyTime());
            chance(0.5) ? bootHost() : bootDrive();
        }
        pass(anyTime());
        if (chance(0.5)) {
            setNearest();
        }
        if (chance(0.5)) {
            syncToTimeServer();
        }
    }

    [[nodiscard]] TurnRecord record() { return recordOf(frame(), truth(), m_axis, chance(0.3), utc(), host()); }

    void misfortune()
    {
        switch (static_cast<int>(uniform(0.0, 11.0))) {
            case 0:
            case 1:
                moveByHand();
                break;
            case 2:
                powerCycle();
                break;
            case 3:
                bootHost();
                break;
            case 4:
                m_utcOffset += (chance(0.5) ? 1.0 : -1.0) * anyTime();
                m_exact = false;
                break;
            case 5:
                syncToTimeServer();
                break;
            case 6:
                setNearest();
                break;
            case 7:
                chance(0.5) ? setExact() : chance(0.5) ? changeEncoderSettings() : moveAndSetBack();
                break;
            case 8:
                chance(0.3) ? swapDrive() : moveByHand();
                break;
            default:
                chance(0.3) ? changeZeroOfProfile() : moveByHand();
                break;
        }
        pass(anyTime());
    }

    [[nodiscard]] DriveFrame frame() const
    {
        return {.drive = m_drive,
                .reported = reported(),
                .homeState = m_home,
                .uptime = uptime(),
                .origin = moteus::CountOrigin{.beginning = m_beginning,
                                              .offset = MotorTurns::fromTurns(m_shift + m_countedFrom)},
                .outputEncoder = m_outputEncoder,
                .period = m_period};
    }

    [[nodiscard]] Angle truth() const { return m_axis.toAxis(MotorTurns::fromTurns(m_motor)); }
    [[nodiscard]] const AxisGeometry& axis() const { return m_axis; }
    [[nodiscard]] bool driveSwapped() const { return m_drive != kAzimuthDrive; }
    [[nodiscard]] UtcTime utc() const
    {
        return kWhen + std::chrono::duration_cast<UtcTime::duration>(Seconds(m_now + m_utcOffset));
    }
    [[nodiscard]] HostTime host() const
    {
        return {
            .boot = QString::number(m_hostBoots), .sinceBoot = Seconds(m_now - m_hostBooted), .utcIsExact = m_exact};
    }

    [[nodiscard]] bool chance(double probability) { return uniform(0.0, 1.0) < probability; }
    [[nodiscard]] double uniform(double from, double to)
    {
        return std::uniform_real_distribution<double>(from, to)(m_random);
    }

private:
    // From 10 ms to 60 days, each order of magnitude equally likely.
    [[nodiscard]] double anyTime() { return 0.01 * std::pow(60.0 * kDay / 0.01, uniform(0.0, 1.0)); }

    void pass(double seconds) { m_now += seconds; }

    // The mechanical stops keep the axis near its travel. Some moves are multiples of what the drive can distinguish.
    void moveByHand()
    {
        const Angle margin = Angle::fromDegrees(14.9);
        const TravelRange reach{m_axis.travel.min - margin, m_axis.travel.max + margin};
        Angle to = Angle::fromDegrees(uniform(reach.min.degrees(), reach.max.degrees()));
        if (chance(0.4)) {
            const Angle turned = truth() + m_period * std::round(uniform(-3.0, 3.0));
            to = reach.contains(turned) ? turned : truth();
        }
        m_motor = m_axis.toMotor(reach.clamped(to)).turns();
    }

    void bootDrive()
    {
        m_driveBooted = m_now;
        m_beginning = 1;
        latch();
    }

    void latch()
    {
        m_countedFrom = m_motor;
        m_shift = -std::round((m_motor + m_encoderZero) / m_placeTurns) * m_placeTurns + m_encoderZero;
        m_home = m_outputEncoder ? HomeState::Output : HomeState::Rotor;
    }

    void bootHost()
    {
        ++m_hostBoots;
        m_hostBooted = m_now;
        m_exact = false;
        if (!m_batteryClock) {
            m_utcOffset = -m_now;
        }
    }

    void powerCycle()
    {
        if (chance(0.7)) {
            moveByHand();
        }
        pass(anyTime());
        bootDrive();
        if (m_switchedTogether) {
            bootHost();
        }
    }

    void syncToTimeServer()
    {
        m_utcOffset = uniform(-2.0, 2.0);
        m_exact = true;
    }

    // Other tools do this too, at any time and without a report.
    void setNearest()
    {
        m_shift += std::round(uniform(-5.0, 5.0)) * m_placeTurns;
        m_home = HomeState::Output;
    }

    // A smaller difference counts as the same position.
    void setExact()
    {
        m_shift += chance(0.5) ? m_placeTurns : (chance(0.5) ? 1.0 : -1.0) * uniform(0.00011, 1.0);
        m_home = HomeState::Output;
    }

    // Moves the axis and sets the count, so that the drive reports the same position as before.
    void moveAndSetBack()
    {
        const double reported = m_motor + m_shift;
        const double from = m_motor;
        moveByHand();
        m_shift = std::abs(m_motor - from) < 0.00011 ? m_shift : reported - m_motor;
        m_home = HomeState::Output;
    }

    // The drive counts from zero again. Then another tool may even set the position that was reported before, wherever
    // the axis is.
    void changeEncoderSettings()
    {
        const double offset = m_shift + m_countedFrom;
        moveByHand();
        ++m_beginning;
        latch();
        if (chance(0.5)) {
            m_shift = offset - m_countedFrom;
            m_home = HomeState::Output;
        }
    }

    void swapDrive()
    {
        m_drive = kElevationDrive;
        m_encoderZero = uniform(-0.5, 0.5) * m_placeTurns;
        pass(anyTime());
        bootDrive();
    }

    // The axis does not move, but from now on the profile gives its positions other angles.
    void changeZeroOfProfile()
    {
        const Angle by = chance(0.5) ? m_period : Angle::fromDegrees(uniform(-20.0, 20.0));
        m_axis.offset += by;
        m_axis.travel.min -= by;
        m_axis.travel.max -= by;
    }

    [[nodiscard]] MotorTurns reported() const { return MotorTurns::fromTurns(m_motor + m_shift); }
    [[nodiscard]] Seconds uptime() const
    {
        return Seconds(std::fmod((m_now - m_driveBooted) * m_driveRate, kUptimePeriod));
    }

    std::mt19937_64 m_random;
    AxisGeometry m_axis;
    Angle m_period;
    bool m_outputEncoder = false;
    double m_placeTurns = 1.0;  // turns of the drive between two positions that look the same to the drive
    double m_motor = 0.0;       // the true position of the axis, in turns of the drive
    double m_encoderZero = 0.0;
    double m_shift = 0.0;        // from there to the reported position
    double m_countedFrom = 0.0;  // the position where the drive began to count
    std::uint32_t m_beginning = 1;
    HomeState m_home = HomeState::Rotor;
    QString m_drive = kAzimuthDrive;
    double m_driveRate = 1.0;
    bool m_batteryClock = true;
    bool m_switchedTogether = false;
    bool m_exact = false;
    int m_hostBoots = 0;
    double m_now = 0.0;  // s, true time
    double m_driveBooted = 0.0;
    double m_hostBooted = 0.0;
    double m_utcOffset = 0.0;
};

// REQ-MEMORY-10: A position that is called certain is true, whatever happened to drive, computer, clocks and profile.
TEST(ReconcileProperty, WhatIsCertainIsTrue)
{
    constexpr int kCases = 100000;
    int counted = 0;
    int proposed = 0;
    for (int i = 0; i < kCases; ++i) {
        World world(static_cast<std::uint64_t>(i));
        Evidence evidence{.record = world.record()};
        const int misfortunes = static_cast<int>(world.uniform(0.0, 5.0));
        for (int k = 0; k < misfortunes; ++k) {
            world.misfortune();
        }
        if (!world.driveSwapped() && world.chance(0.1)) {
            evidence.record.reset();
        }
        evidence.now = world.utc();
        evidence.host = world.host();
        const Judgement judgement = reconcile(world.frame(), evidence, world.axis());
        if (const auto* certain = std::get_if<Certain>(&judgement)) {
            ASSERT_NEAR(certain->angle.degrees(), world.truth().degrees(), 1e-6)
                << "case " << i << ": " << certain->why.toStdString();
            ++counted;
        } else {
            proposed += std::get<TurnQuestion>(judgement).proposed ? 1 : 0;
        }
    }
    RecordProperty("counted", counted);
    RecordProperty("proposed", proposed);
    EXPECT_GT(counted, kCases / 10);
    EXPECT_GT(proposed, kCases / 20);
}

}  // namespace
}  // namespace boresight::journal
