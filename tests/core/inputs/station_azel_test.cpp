// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/inputs/station_azel.h"

#include "core/azel_file/azel_file.h"
#include "core/base/text.h"
#include "core/sim_bus/simulated_link.h"
#include "tests/core/station/linked_station.h"
#include "tests/fakes/azel_writer.h"
#include "tests/fakes/wait_until.h"

#include <QFile>
#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <optional>

namespace boresight {
namespace {

const QByteArray kAzelText =
    "22:30:04,105.3, 59.9,Moon\n22:30:04,298.4,-59.7,Sun\n22:30:04,  0.0,  0.0,Source\n"
    " 1296,  2189.0,   -4.41,  1625.0,   -9.79,Doppler, R\n";

SkyPointing readMoon(const QString& path)
{
    const auto text = azel::readAzelFile(path).text;
    EXPECT_TRUE(text);
    return text ? text->moon : SkyPointing{};
}

// REQ-AZEL-919: From its start the station reads the file of the profile four times a second, outside its own thread.
// After a change of the profile it reads the new file.
TEST(StationAzelTest, LooksAtTheFileOfTheProfile)
{
    const QTemporaryDir folder;
    const auto naming = [&](const char* name) {
        profile::Profile profile;
        profile.azel.file = folder.filePath(QLatin1String(name)).toStdString();
        return profile;
    };
    QFile out(folder.filePath(QStringLiteral("azel.dat")));
    ASSERT_TRUE(out.open(QIODevice::WriteOnly));
    out.write(kAzelText);
    out.close();

    profile::InForce profile(naming("azel.dat"));
    StationAzel azel(profile, nullptr);
    std::optional<azel::AzelReading> last;
    int looks = 0;
    QObject::connect(&azel, &StationAzel::looked, [&](const azel::AzelReading& reading) {
        last = reading;
        ++looks;
    });
    azel.open();
    ASSERT_TRUE(fakes::waitUntil([&] { return looks > 1; }));
    ASSERT_TRUE(last->text);
    EXPECT_EQ(last->text->moon, (SkyPointing{105.3_deg, 59.9_deg}));
    profile.apply(naming("none.dat"));
    ASSERT_TRUE(fakes::waitUntil([&] { return !last->text; }));
    EXPECT_EQ(last->path, folder.filePath(QStringLiteral("none.dat")));
}

// REQ-AZEL-920: The whole way from the file to the mount: the status shows what WSJT-X writes, and FollowAzel moves the
// mount.
TEST(StationAzelTest, TheStationFollowsTheFile)
{
    const QTemporaryDir folder;
    profile::Profile profile = anyPort();
    profile.site = {.known = true, .latitude = 38.757_deg, .longitude = -9.117_deg, .heightMetres = 80.0};
    profile.azel.file = folder.filePath(QStringLiteral("azel.dat")).toStdString();
    fakes::ManualClock clock;
    auto owned = std::make_unique<SimulatedLink>(clock);
    SimulatedLink& link = *owned;
    Station station(profile, moteusRotator(std::move(owned), {folder.path(), Simulation::Reference}), folder.path(),
                    clock);
    station.openAll();
    const auto run = [&](Seconds time) {
        for (Seconds left = time; left > Seconds(0.0); left -= Seconds(0.02)) {
            clock.advance(Seconds(0.02));
            link.deliver();
            station.tick();
        }
    };
    run(Seconds(4.0));  // until the drive check is done
    fakes::AzelWriter writer(
        {.latitude = profile.site.latitude, .longitude = profile.site.longitude, .heightMetres = 80.0});
    for (int i = 0; i < 2; ++i) {
        run(Seconds(1.0));
        QFile out(toQString(profile.azel.file));
        ASSERT_TRUE(out.open(QIODevice::WriteOnly));
        out.write(writer.textAt(clock.utc()));
        out.close();
        const SkyPointing moon = readMoon(out.fileName());
        // The file is read in real time. The turned clock stands still meanwhile, so that the file does not get old.
        ASSERT_TRUE(fakes::waitUntil([&] {
            station.tick();
            const AzelStatus azel = station.status().azel;
            return azel.moon == moon && azel.age && (i == 0 || azel.problem.isEmpty());
        }));
    }
    station.request({.id = 1, .request = request::FollowAzel{}});
    run(Seconds(1.0));
    EXPECT_NE(station.status().azel.phase, AzelPhase::Off);
    EXPECT_EQ(station.status().commander.name.toStdString(), "azel.dat");
}

}  // namespace
}  // namespace boresight
