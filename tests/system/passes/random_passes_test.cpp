// SPDX-License-Identifier: GPL-3.0-or-later
// Random passes on the simulated mount with limits, a horizon, a mast and gusts: tracked by plan, and chased by a
// client that sends the direction each second. Prints both as a table. The variable RANDOM_PASSES is the number of
// passes.
#include "core/passes/pass_finder.h"
#include "core/profile/clear_sky.h"
#include "core/units/angle_between.h"
#include "tests/fakes/found_orbit.h"
#include "tests/system/simulated_station.h"

#include <QThreadPool>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <vector>

namespace boresight::system_test {
namespace {

const Site kNightSite{.latitude = 38.757_deg, .longitude = -9.117_deg, .heightMetres = 80.0};
constexpr auto kBefore = std::chrono::seconds(60);  // the mount is sent to the rise

// The reference mount with a cable that ends at the north-west. A hill in the north-east, houses, and a mast.
profile::Profile nightMount()
{
    profile::Profile profile = anyPort();
    profile.control.tickHz = 20;
    profile.control.watchdog = Seconds(0.2);
    profile.supervision.replyAge = Seconds(0.2);
    profile.site = {.known = true,
                    .latitude = kNightSite.latitude,
                    .longitude = kNightSite.longitude,
                    .heightMetres = kNightSite.heightMetres};
    profile.limits.azimuth = {.min = -60_deg, .max = 330_deg};
    profile.limits.horizon = {{0_deg, 5_deg}, {40_deg, 14_deg}, {90_deg, 4_deg}, {200_deg, 3_deg}, {300_deg, 8_deg}};
    profile.limits.keepOuts = {
        {.name = "mast", .azimuthFrom = 205_deg, .azimuthTo = 216_deg, .elevationMin = 0_deg, .elevationMax = 22_deg}};
    profile.clientLock = profile::ClientLock::Never;
    return profile;
}

struct NightPass
{
    fakes::FoundOrbit found;
    UtcTime now{};
};

// Low orbits of all kinds, one pass of each, in the order of time. Each run has the same.
std::vector<NightPass> passesOfANight(int count)
{
    std::mt19937 random(17);
    const auto between = [&random](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    std::vector<NightPass> night;
    UtcTime now = fakes::ManualClock().utc() + std::chrono::minutes(5);
    while (static_cast<int>(night.size()) < count) {
        orbit::ElementSet set =
            fakes::lowOrbit(now, Angle::fromDegrees(between(0, 360)), Angle::fromDegrees(between(0, 360)));
        set.inclination = Angle::fromDegrees(between(50, 99));
        set.revolutionsPerDay = between(13.2, 15.6);
        const auto list = passes::findPasses(
            orbit::Sgp4(set),
            {.site = kNightSite, .from = now + kBefore, .to = now + std::chrono::hours(3), .isClear = nullptr});
        const bool isGood = !list.passes.empty() && !list.passes.front().isUpAtEnd &&
                            list.passes.front().aos.utc > now + 2 * kBefore &&
                            list.passes.front().tca.direction.elevation > 15_deg;
        if (isGood) {
            night.push_back({.found = {.elements = set, .pass = list.passes.front()}, .now = now});
            now = list.passes.front().los.utc + std::chrono::minutes(2);
        }
    }
    return night;
}

// The error of the antenna while the mount can see the satellite.
struct ErrorStatistics
{
    std::vector<double> degrees;
    double squares = 0.0;
    Seconds lost{0.0};  // with an error of more than a degree

    void add(Angle error, Seconds step)
    {
        degrees.push_back(error.degrees());
        squares += error.degrees() * error.degrees();
        lost += error > 1_deg ? step : Seconds(0.0);
    }
    void add(const ErrorStatistics& other)
    {
        degrees.insert(degrees.end(), other.degrees.begin(), other.degrees.end());
        squares += other.squares;
        lost += other.lost;
    }
    [[nodiscard]] double rms() const { return std::sqrt(squares / static_cast<double>(degrees.size())); }
    [[nodiscard]] double percentile(double part) const
    {
        std::vector<double> sorted = degrees;
        std::ranges::sort(sorted);
        return sorted[static_cast<std::size_t>(part * static_cast<double>(sorted.size() - 1))];
    }
};

// The mount a minute before the rise, where the last pass has left it.
class NightMount
{
public:
    NightMount(const fakes::FoundOrbit& found, const AxisPosition& place)
        : m_found(found), m_rig(nightMount(), sim::commissionedPair(place))
    {
        m_rig.onTick = [] { QThreadPool::globalInstance()->waitForDone(); };  // a plan arrives in the next tick
        m_rig.clock.setUtc(found.pass.aos.utc - kBefore);
        m_rig.run(Seconds(1.0));
    }

    ErrorStatistics byPlan()
    {
        EXPECT_EQ(m_rig.ask(request::Track{targets::satelliteTarget(m_found.elements)}), "");
        return follow([] {});
    }

    // A client sends the direction each second, at first the one where the satellite will rise.
    ErrorStatistics byChasing()
    {
        const auto peer = m_rig.connect();
        UtcTime next = m_rig.clock.utc();
        return follow([&] {
            if (m_rig.clock.utc() < next) {
                return;
            }
            next += std::chrono::seconds(1);
            const SkyPointing there =
                fakes::directionOf(m_found, kNightSite, std::max(m_rig.clock.utc(), m_found.pass.aos.utc));
            std::array<char, 64> line{};
            std::snprintf(line.data(), line.size(), "P %.2f %.2f\n", there.azimuth.wrapped360().degrees(),
                          std::max(0.0, there.elevation.degrees()));
            EXPECT_EQ(peer->ask(line.data()), "RPRT 0\n");
        });
    }

    [[nodiscard]] AxisPosition place() const { return m_rig.truth(); }

private:
    template <class Act>
    ErrorStatistics follow(const Act& act)
    {
        const profile::Profile profile = nightMount();
        const auto isClear = profile::clearSky(profile, profile.antenna({}));
        ErrorStatistics errors;
        while (m_rig.clock.utc() < m_found.pass.los.utc - std::chrono::seconds(1)) {
            blow();
            act();
            m_rig.tick();
            const UtcTime utc = m_rig.clock.utc();
            const SkyPointing there = fakes::directionOf(m_found, kNightSite, utc);
            if (utc > m_found.pass.aos.utc && isClear(there)) {
                const AxisPosition truth = m_rig.truth();
                errors.add(angleBetween({.azimuth = truth.azimuth, .elevation = truth.elevation}, there), m_rig.step);
            }
        }
        EXPECT_NE(m_rig.status().state, StationState::Fault);
        return errors;
    }

    // A gust of up to 12 Nm for a second, about every fourth second.
    void blow()
    {
        std::uniform_real_distribution<double> part(0.0, 1.0);
        if (part(m_wind) < m_rig.step / Seconds(4.0)) {
            m_rig.link->inject({.kind = sim::FaultKind::Wind,
                                .axis = part(m_wind) < 0.5 ? Axis::Azimuth : Axis::Elevation,
                                .duration = Seconds(1.0),
                                .value = 24.0 * part(m_wind) - 12.0});
        }
    }

    const fakes::FoundOrbit& m_found;
    SimulatedStation m_rig;
    std::mt19937 m_wind{4};
};

void printRow(const char* name, const ErrorStatistics& errors)
{
    std::printf("| %s | %.3f | %.3f | %.2f | %.2f | %.0f |\n", name, errors.rms(), errors.percentile(0.5),
                errors.percentile(0.99), errors.percentile(1.0), errors.lost.count());
}

}  // namespace

// REQ-TRACK-1826: Over a night of random passes on a mount with limits, horizon, mast and gusts, tracking by plan loses
// less time than chasing the points of a client, and no pass loses more.
TEST(RandomPasses, AreTrackedBetterThanTheyAreChased)
{
    const char* const wanted = std::getenv("RANDOM_PASSES");
    const int count = wanted ? std::max(1, std::atoi(wanted)) : 2;
    AxisPosition planned;  // where each of both mounts stands
    AxisPosition chased;
    ErrorStatistics plans;
    ErrorStatistics chases;
    for (const NightPass& pass : passesOfANight(count)) {
        NightMount plannedMount(pass.found, planned);
        const ErrorStatistics plan = plannedMount.byPlan();
        planned = plannedMount.place();
        NightMount chasedMount(pass.found, chased);
        const ErrorStatistics chase = chasedMount.byChasing();
        chased = chasedMount.place();
        if (plan.degrees.empty()) {
            continue;  // the mount never sees the satellite
        }
        std::printf("%2.0f deg: by plan %.3f rms, %.1f s lost; chased %.3f rms, %.1f s lost\n",
                    pass.found.pass.tca.direction.elevation.degrees(), plan.rms(), plan.lost.count(), chase.rms(),
                    chase.lost.count());
        EXPECT_LE(plan.lost.count(), chase.lost.count() + 2.0);
        plans.add(plan);
        chases.add(chase);
    }
    std::printf("| %d passes | rms ° | median ° | 99 %% ° | peak ° | s beyond 1° |\n|---|---:|---:|---:|---:|---:|\n",
                count);
    printRow("by plan", plans);
    printRow("chased, 1 Hz", chases);
    EXPECT_LT(plans.rms(), chases.rms());
    EXPECT_LT(plans.lost.count(), chases.lost.count());
}

}  // namespace boresight::system_test
