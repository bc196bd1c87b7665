// SPDX-License-Identifier: GPL-3.0-or-later
// Each kind of mount tracks the same pass of a satellite. Prints the table of core/mount/README.md.
#include "core/units/angle_between.h"
#include "tests/core/gs232_mount/esp32_bench.h"
#include "tests/core/gs232_mount/gs232_bench.h"
#include "tests/core/mount/mount_bench.h"
#include "tests/core/rotctld_mount/rotctld_bench.h"
#include "tests/fakes/found_orbit.h"
#include "tests/system/simulated_station.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <iostream>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace boresight::system_test {
namespace {

const char* const kTableHead =
    "| mount | beam ° | rms error ° | peak error ° | within half the beam % | motor starts/min | commands/s |\n"
    "|---|---:|---:|---:|---:|---:|---:|\n";

const Site kPassSite{.latitude = 38.757_deg, .longitude = -9.117_deg, .heightMetres = 80.0};
constexpr Seconds kSettledBy{5.0};  // after the rise

profile::Profile inLisbon(profile::Profile profile, Angle beamWidth)
{
    profile.site = {.known = true,
                    .latitude = kPassSite.latitude,
                    .longitude = kPassSite.longitude,
                    .heightMetres = kPassSite.heightMetres};
    profile.mount.beamWidth = beamWidth;
    return profile;
}

// A mount with all that is between a request and its axes.
class PassMount
{
public:
    virtual ~PassMount() = default;

    virtual void tick() = 0;
    [[nodiscard]] virtual bool track(const targets::Target& target) = 0;
    [[nodiscard]] virtual UtcTime utc() = 0;
    [[nodiscard]] virtual AxisPosition truth() = 0;
    [[nodiscard]] virtual std::uint64_t commands() = 0;  // and queries, sent so far
    [[nodiscard]] virtual bool hasFault() = 0;
};

std::uint64_t sentBy(SimpleBench& bench)
{
    return static_cast<std::uint64_t>(bench.box().orders());
}

template <class BoxBench>
std::uint64_t sentBy(BoxBench& bench)
{
    return bench.mount().talk().counts().sent;
}

// A simulated rotator of the other tests.
template <class AnyBench>
class PassBench final : public PassMount
{
public:
    template <class... Arguments>
    explicit PassBench(const Arguments&... arguments) : m_bench(arguments...)
    {}

    void tick() override { m_bench.tick(); }
    bool track(const targets::Target& target) override { return m_bench.ask(request::Track{target}).has_value(); }
    UtcTime utc() override { return m_bench.clock().utc(); }
    AxisPosition truth() override { return m_bench.truth(); }
    std::uint64_t commands() override { return sentBy(m_bench); }
    bool hasFault() override { return m_bench.control().faultLatched(); }

private:
    AnyBench m_bench;
};

// Two moteus with all their physics. Their motors follow each set-point.
class PassStation final : public PassMount
{
public:
    explicit PassStation(Angle beamWidth) : m_station(inLisbon(anyPort(), beamWidth)) {}

    void tick() override { m_station.tick(); }
    bool track(const targets::Target& target) override { return m_station.ask(request::Track{target}).empty(); }
    UtcTime utc() override { return m_station.clock.utc(); }
    AxisPosition truth() override { return m_station.truth(); }
    std::uint64_t commands() override { return m_station.link->status().sent; }
    bool hasFault() override { return m_station.status().state == StationState::Fault; }

private:
    SimulatedStation m_station;
};

struct PassFigures
{
    double rms = 0.0;       // ° on the sky
    double peak = 0.0;      // °
    double inBeam = 0.0;    // % of the time within half the beam width
    double starts = 0.0;    // a minute, of both motors
    double commands = 0.0;  // a second, with the queries
};

struct PassRow
{
    std::string name;
    Angle beam;
    std::function<std::unique_ptr<PassMount>(Angle beam)> make;
    PassFigures allowed;  // `inBeam`: at least
    bool countsStarts = true;
};

// The satellite rises when each of these mounts has had the time to go anywhere.
const fakes::FoundOrbit& thePass()
{
    static const fakes::FoundOrbit found = [] {
        const UtcTime now = fakes::ManualClock().utc();
        return fakes::orbitWith(kPassSite, now, [now](const passes::Pass& pass) {
            const Seconds wait = pass.aos.utc - now;
            const Angle highest = pass.tca.direction.elevation;
            return Seconds(110.0) < wait && wait < Seconds(300.0) && pass.duration() > Seconds(570.0) &&
                   45_deg < highest && highest < 60_deg && !pass.isUpAtEnd;
        });
    }();
    return found;
}

// Counts how often an axis that stood begins to move.
class StartCounter
{
public:
    explicit StartCounter(const AxisPosition& place) : m_last(place) {}

    void see(const AxisPosition& place)
    {
        for (const Axis axis : kAxes) {
            const bool moves = of(axis, place) != of(axis, m_last);
            m_starts += moves && !m_moved[index(axis)] ? 1 : 0;
            m_moved[index(axis)] = moves;
        }
        m_last = place;
    }
    [[nodiscard]] int starts() const { return m_starts; }

private:
    AxisPosition m_last;
    std::array<bool, 2> m_moved{true, true};
    int m_starts = 0;
};

PassFigures followThePass(PassMount& mount, Angle halfBeam)
{
    const fakes::FoundOrbit& found = thePass();
    const auto runTo = [&mount](UtcTime utc) {
        while (mount.utc() < utc) {
            mount.tick();
        }
    };
    runTo(fakes::ManualClock().utc() + std::chrono::seconds(20));
    EXPECT_TRUE(mount.track(targets::satelliteTarget(found.elements)));
    runTo(found.pass.aos.utc + std::chrono::duration_cast<UtcTime::duration>(kSettledBy));

    const UtcTime began = mount.utc();
    const std::uint64_t commands = mount.commands();
    StartCounter counter(mount.truth());
    PassFigures figures;
    int looks = 0;
    for (; mount.utc() < found.pass.los.utc - std::chrono::seconds(1); ++looks) {
        mount.tick();
        const AxisPosition place = mount.truth();
        counter.see(place);
        const Angle error = angleBetween({.azimuth = place.azimuth, .elevation = place.elevation},
                                         fakes::directionOf(found, kPassSite, mount.utc()));
        figures.rms += error.degrees() * error.degrees();
        figures.peak = std::max(figures.peak, error.degrees());
        figures.inBeam += error <= halfBeam ? 1.0 : 0.0;
    }
    const Seconds time = mount.utc() - began;
    figures.rms = std::sqrt(figures.rms / looks);
    figures.inBeam *= 100.0 / looks;
    figures.starts = counter.starts() * 60.0 / time.count();
    figures.commands = static_cast<double>(mount.commands() - commands) / time.count();
    return figures;
}

std::string rounded(double value, int decimals)
{
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
    return text.data();
}

std::string keyOf(const PassRow& row)
{
    return "| " + row.name + " | " + rounded(row.beam.degrees(), 0) + " |";
}

std::string lineOf(const PassRow& row, const PassFigures& figures)
{
    return keyOf(row) + " " + rounded(figures.rms, 3) + " | " + rounded(figures.peak, 3) + " | " +
           rounded(figures.inBeam, 1) + " | " + (row.countsStarts ? rounded(figures.starts, 1) : "-") + " | " +
           rounded(figures.commands, 1) + " |\n";
}

gs232::Gs232Box::Habits boxOf(gs232::Dialect dialect)
{
    return {.dialect = dialect,
            .acknowledge =
                dialect == gs232::Dialect::A ? gs232::Gs232Box::Acknowledge::Cr : gs232::Gs232Box::Acknowledge::Prompt};
}

std::function<std::unique_ptr<PassMount>(Angle)> gs232Box(gs232::Dialect dialect, const profile::Profile& profile)
{
    return [dialect, profile](Angle beam) {
        return std::make_unique<PassBench<gs232::Gs232Bench>>(inLisbon(profile, beam), boxOf(dialect));
    };
}

profile::Profile seldom(profile::Profile profile)
{
    profile.rotator.rareStarts = profile::RareStarts::On;
    return profile;
}

std::function<std::unique_ptr<PassMount>(Angle)> rotctldBox(const profile::Profile& profile)
{
    return [profile](Angle beam) { return std::make_unique<PassBench<rotctl::RotctldBench>>(inLisbon(profile, beam)); };
}

std::unique_ptr<PassMount> esp32Box(Angle beam)
{
    return std::make_unique<PassBench<gs232::Esp32Bench>>(inLisbon(gs232::esp32Profile(), beam));
}

std::unique_ptr<PassMount> simpleMount(Angle beam)
{
    return std::make_unique<PassBench<SimpleBench>>(SimpleMount::Axes{}, inLisbon(slowProfile(), beam));
}

// The figures allowed are a fifth to a third above those that were measured.
std::vector<PassRow> passRows()
{
    const auto eachStep = gs232Box(gs232::Dialect::B, gs232::gs232Profile());
    const auto rareStarts = gs232Box(gs232::Dialect::B, gs232::switchedProfile());
    return {
        {.name = "two moteus",
         .beam = 2_deg,
         .make = [](Angle beam) { return std::make_unique<PassStation>(beam); },
         .allowed = {.rms = 0.018, .peak = 0.022, .inBeam = 99.9, .commands = 130.0},
         .countsStarts = false},
        {.name = "simple",
         .beam = 2_deg,
         .make = simpleMount,
         .allowed = {.rms = 0.46, .peak = 0.85, .inBeam = 99.9, .starts = 30.0, .commands = 0.5}},
        {.name = "GS-232A, each step",
         .beam = 2_deg,
         .make = gs232Box(gs232::Dialect::A, gs232::gs232Profile()),
         .allowed = {.rms = 0.46, .peak = 1.2, .inBeam = 99.9, .starts = 30.0, .commands = 5.0}},
        {.name = "GS-232B, each step",
         .beam = 2_deg,
         .make = eachStep,
         .allowed = {.rms = 0.46, .peak = 1.2, .inBeam = 99.9, .starts = 30.0, .commands = 5.0}},
        {.name = "GS-232B, rare starts",
         .beam = 2_deg,
         .make = rareStarts,
         .allowed = {.rms = 0.95, .peak = 1.75, .inBeam = 75.0, .starts = 15.5, .commands = 5.0}},
        {.name = "GS-232B, rare starts",
         .beam = 10_deg,
         .make = rareStarts,
         .allowed = {.rms = 1.4, .peak = 2.6, .inBeam = 99.9, .starts = 10.5, .commands = 5.0}},
        {.name = "GS-232B, rare starts",
         .beam = 20_deg,
         .make = rareStarts,
         .allowed = {.rms = 2.6, .peak = 4.8, .inBeam = 99.9, .starts = 5.0, .commands = 5.0}},
        {.name = "ESP32, each step",
         .beam = 10_deg,
         .make = esp32Box,
         .allowed = {.rms = 2.3, .peak = 4.0, .inBeam = 99.9, .starts = 16.0, .commands = 5.5}},
        {.name = "rotctld, each step",
         .beam = 2_deg,
         .make = rotctldBox(rotctl::rotctldProfile()),
         .allowed = {.rms = 0.11, .peak = 0.4, .inBeam = 99.9, .starts = 180.0, .commands = 6.5}},
        {.name = "rotctld, rare starts",
         .beam = 10_deg,
         .make = rotctldBox(seldom(rotctl::rotctldProfile())),
         .allowed = {.rms = 1.4, .peak = 2.6, .inBeam = 99.9, .starts = 10.5, .commands = 5.0}},
    };
}

void PrintTo(const PassRow& row, std::ostream* out)
{
    *out << keyOf(row);
}

class PassTable : public testing::TestWithParam<PassRow>
{
public:
    static void SetUpTestSuite() { std::cout << kTableHead; }
};

// REQ-MOUNT-19 (PassTable.*): Each kind of mount tracks the same pass of a satellite, from 5 s after its rise. The page
// of core/mount has the error on the sky, the time within half the beam width, the motor starts and the commands.
TEST_P(PassTable, IsTrackedWithinItsFigures)
{
    const PassRow& row = GetParam();
    const auto mount = row.make(row.beam);
    const PassFigures figures = followThePass(*mount, 0.5 * row.beam);
    const std::string line = lineOf(row, figures);
    std::cout << line;
    RecordProperty("row", line);
    EXPECT_FALSE(mount->hasFault());
    EXPECT_LE(figures.rms, row.allowed.rms);
    EXPECT_LE(figures.peak, row.allowed.peak);
    EXPECT_GE(figures.inBeam, row.allowed.inBeam);
    if (row.countsStarts) {
        EXPECT_LE(figures.starts, row.allowed.starts);
    }
    EXPECT_LE(figures.commands, row.allowed.commands);
}

// The figures on the page may be older. Its rows must be the rows of this test.
TEST(PassTablePage, HasTheRowsOfThisTest)
{
    std::multiset<std::string> expected;
    for (const PassRow& row : passRows()) {
        expected.insert(keyOf(row));
    }
    std::multiset<std::string> written;
    std::ifstream page(MOUNT_PAGE);
    for (std::string line; std::getline(page, line);) {
        const std::string key = line.substr(0, line.find('|', line.find('|', 1) + 1) + 1);
        if (expected.contains(key)) {
            written.insert(key);
        }
    }
    EXPECT_EQ(written, expected);
}

std::string nameOf(const testing::TestParamInfo<PassRow>& info)
{
    std::string name;
    for (const char letter : keyOf(info.param)) {
        name += std::isalnum(static_cast<unsigned char>(letter)) != 0 ? std::string(1, letter) : std::string();
    }
    return name;
}

INSTANTIATE_TEST_SUITE_P(Row, PassTable, testing::ValuesIn(passRows()), nameOf);

}  // namespace
}  // namespace boresight::system_test
