// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus_mount/crash_stop_proof.h"

#include "tests/fakes/text_of.h"

#include <gtest/gtest.h>

#include <cmath>

namespace boresight {
namespace {

using ProofAction = CrashStopProof::Action;

constexpr TravelRange kAzimuthTravel{-90_deg, 450_deg};
constexpr TravelRange kElevationTravel{0_deg, 90_deg};
constexpr Seconds kCrashStopProofTick{0.02};

// Both axes run when commanded. Without commands they run on for `watchdog` and then brake at `deceleration`.
class Mount
{
public:
    explicit Mount(double watchdog = 0.1, double deceleration = 20.0)
        : m_watchdog(watchdog), m_deceleration(deceleration)
    {}

    // The stops measured until the test is over, for at most a minute.
    std::vector<CrashStopProof::Stop> run(CrashStopProof proof)
    {
        std::vector<CrashStopProof::Stop> stops;
        for (int i = 0; i < 3000 && !over; ++i) {
            obey(proof, stops);
            move();
        }
        failure = proof.failure();
        return stops;
    }

    bool over = false;
    QString failure;

private:
    void obey(CrashStopProof& proof, std::vector<CrashStopProof::Stop>& stops)
    {
        m_now += std::chrono::duration_cast<SteadyTime::duration>(kCrashStopProofTick);
        const ProofAction action = proof.step(m_now, {.received = m_now, .angle = m_angle, .settled = m_starved < 0.0});
        if (action == ProofAction::Run) {
            m_rate = proof.rate();
        } else if (action == ProofAction::Starve) {
            m_starved = 0.0;
        } else if (action == ProofAction::Recover) {
            m_starved = -1.0;
            m_rate = {};
            if (const auto stop = proof.takeStop()) {
                stops.push_back(*stop);
            }
            m_angle = 45_deg;  // the other axis
        }
        over = action == ProofAction::Finish;
    }

    void move()
    {
        if (m_starved >= 0.0) {
            m_starved += kCrashStopProofTick.count();
            if (m_starved > m_watchdog) {
                const double slower = abs(m_rate).degrees() - m_deceleration * kCrashStopProofTick.count();
                m_rate = AngularRate::fromDegrees(std::copysign(std::max(slower, 0.0), m_rate.degrees()));
            }
        }
        m_angle += m_rate * kCrashStopProofTick;
    }

    double m_watchdog;
    double m_deceleration;
    SteadyTime m_now{};
    Angle m_angle = 100_deg;
    AngularRate m_rate;
    double m_starved = -1.0;
};

CrashStopProof proofAt(AngularRate rate)
{
    auto proof = CrashStopProof::prepare(rate, {100_deg, 45_deg}, kAzimuthTravel, kElevationTravel);
    EXPECT_TRUE(proof);
    return *proof;
}

// REQ-AXES-20 (CrashStopProof.*): The crash-stop test measures how each axis stops when its drive really receives no
// commands.
TEST(CrashStopProof, MeasuresWhereAndWhenBothAxesStand)
{
    Mount mount;
    const auto stops = mount.run(proofAt(2_deg_s));
    ASSERT_TRUE(mount.over);
    EXPECT_TRUE(mount.failure.isEmpty()) << mount.failure.toStdString();
    ASSERT_EQ(stops.size(), 2U);
    for (const CrashStopProof::Stop& stop : stops) {
        // 0.1 s at 2°/s, then 2²/(2·20) = 0.1° in 0.1 s, both within one tick.
        EXPECT_NEAR(stop.angle.degrees(), 0.3, 0.06);
        EXPECT_NEAR(static_cast<double>(stop.time.count()), 200.0, 40.0);
        EXPECT_EQ(stop.rate, 2_deg_s);
    }
}

TEST(CrashStopProof, IsOfTheAxesThatTheMountHas)
{
    const TravelRange none{0_deg, 0_deg};
    for (const Axis axis : kAxes) {
        const bool azimuth = axis == Axis::Azimuth;
        const auto proof = CrashStopProof::prepare(2_deg_s, {100_deg, 45_deg}, azimuth ? kAzimuthTravel : none,
                                                   azimuth ? none : kElevationTravel, axesIf(azimuth, !azimuth));
        ASSERT_TRUE(proof) << "the axis that is missing needs no room";
        EXPECT_EQ(proof->axis(), axis);
        Mount mount;
        EXPECT_EQ(mount.run(*proof).size(), 1U);
        EXPECT_TRUE(mount.over);
        EXPECT_TRUE(mount.failure.isEmpty()) << mount.failure.toStdString();
    }
}

TEST(CrashStopProof, ADriveThatRunsOnIsAFailureAndIsTakenBack)
{
    Mount mount(1000.0);
    const auto stops = mount.run(proofAt(2_deg_s));
    EXPECT_TRUE(mount.over);
    EXPECT_TRUE(stops.empty());
    EXPECT_TRUE(mount.failure.contains(QStringLiteral("azimuth did not stop"))) << mount.failure.toStdString();
}

TEST(CrashStopProof, NeedsRoomOnOneSide)
{
    const TravelRange narrow{0_deg, 15_deg};
    EXPECT_TRUE(CrashStopProof::prepare(2_deg_s, {0_deg, 1_deg}, kAzimuthTravel, narrow));
    const auto refused = CrashStopProof::prepare(5_deg_s, {0_deg, 7_deg}, kAzimuthTravel, narrow);
    ASSERT_FALSE(refused);
    EXPECT_NE(textOf(refused.error()).find("elevation"), std::string::npos);
}

TEST(CrashStopProof, MovesAwayFromTheNearerEnd)
{
    const auto high = CrashStopProof::prepare(2_deg_s, {440_deg, 45_deg}, kAzimuthTravel, kElevationTravel);
    EXPECT_EQ(high->rate(), -2_deg_s);
    const auto low = CrashStopProof::prepare(2_deg_s, {-80_deg, 45_deg}, kAzimuthTravel, kElevationTravel);
    EXPECT_EQ(low->rate(), 2_deg_s);
}

}  // namespace
}  // namespace boresight
