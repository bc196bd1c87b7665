// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/catalogue.h"
#include "core/units/angle_between.h"
#include "tests/core/control/station_rig.h"
#include "tests/fakes/found_orbit.h"
#include "tests/fakes/text_of.h"

#include <QThreadPool>

#include <gmock/gmock.h>

#include <algorithm>
#include <functional>

// A station with a client that sends the direction of a satellite each second, and reads the position.
namespace boresight {

inline const Site kLockSite{.latitude = 38.757_deg, .longitude = -9.117_deg, .heightMetres = 80.0};

inline profile::Profile lockProfile(profile::ClientLock lock)
{
    profile::Profile profile;
    profile.site = {.known = true,
                    .latitude = kLockSite.latitude,
                    .longitude = kLockSite.longitude,
                    .heightMetres = kLockSite.heightMetres};
    profile.control.tickHz = 20;  // the lowest
    profile.control.watchdog = Seconds(0.2);
    profile.clientLock = lock;
    return profile;
}

class StationLock : public ::testing::Test
{
protected:
    explicit StationLock(profile::ClientLock lock = profile::ClientLock::Always) : rig(lockProfile(lock))
    {
        rig.onTick = [] { QThreadPool::globalInstance()->waitForDone(); };  // a recognition arrives in the next tick
        rig.control.clientCame(kClient, "127.0.0.1");
        rig.run(Seconds(0.5));
        found = fakes::orbitWith(kLockSite, now(), [&](const passes::Pass& pass) {
            const Seconds wait = pass.aos.utc - now();
            const Angle highest = pass.tca.direction.elevation;
            return Seconds(60.0) < wait && wait < Seconds(200.0) && 40_deg < highest && highest < 60_deg &&
                   !pass.isUpAtEnd;
        });
        know({found.elements});
    }

    void know(const std::vector<orbit::ElementSet>& sets)
    {
        EXPECT_TRUE(rig.control.receive(std::make_shared<const std::vector<orbit::ElementSet>>(sets)));
    }
    [[nodiscard]] UtcTime now() const { return rig.clock.utc(); }
    [[nodiscard]] SkyPointing direction() const
    {
        SkyPointing there = fakes::directionOf(found, kLockSite, now());
        there.elevation = std::max(there.elevation, 0_deg);
        return there;
    }
    // The point of the client, away from the satellite by this angle in azimuth.
    Result<> send(Angle away = {}, const Source& client = kClient)
    {
        SkyPointing there = direction();
        there.azimuth = there.azimuth + away;
        return rig.ask(request::PointSky{there}, client);
    }
    // Where the satellite will be after this way along its path.
    [[nodiscard]] SkyPointing ahead(Angle way) const
    {
        UtcTime utc = now();
        while (angleBetween(fakes::directionOf(found, kLockSite, utc), direction()) < way) {
            utc += std::chrono::milliseconds(100);
        }
        return fakes::directionOf(found, kLockSite, utc);
    }
    // The point where Gpredict waits for the rise.
    [[nodiscard]] SkyPointing rise() const { return {.azimuth = found.pass.aos.direction.azimuth, .elevation = {}}; }
    // The same satellite, behind itself by this part of its orbit: 0.1° is 1.5 s.
    [[nodiscard]] orbit::ElementSet behind(std::int64_t number, const std::string& name, Angle by) const
    {
        orbit::ElementSet other = found.elements;
        other.number = number;
        other.name = name;
        other.meanAnomaly = other.meanAnomaly - by;
        return other;
    }
    // A train of 20 satellites.
    [[nodiscard]] std::vector<orbit::ElementSet> train() const
    {
        std::vector<orbit::ElementSet> all{found.elements};
        for (int i = 1; i < 20; ++i) {
            all.push_back(behind(90'000 + i, "TRAIN " + std::to_string(100 + i), i * 0.02_deg));
        }
        return all;
    }
    // The client sends its point each second.
    void track(Seconds time, Angle away = {})
    {
        for (Seconds left = time; left > Seconds(0.0); left -= Seconds(1.0)) {
            EXPECT_TRUE(send(away));
            rig.control.positionRead(kClient.clientId);
            rig.run(Seconds(1.0));
        }
    }
    // The client only reads.
    void read(Seconds time)
    {
        for (Seconds left = time; left > Seconds(0.0); left -= Seconds(1.0)) {
            rig.control.positionRead(kClient.clientId);
            rig.run(Seconds(1.0));
        }
    }
    void runUntil(UtcTime utc)
    {
        while (now() < utc) {
            rig.tick();
        }
    }
    // The way to the satellite takes 30 s.
    void beginInThePass()
    {
        runUntil(found.pass.aos.utc + std::chrono::seconds(60));
        track(Seconds(40.0));
    }
    [[nodiscard]] std::optional<RecognisedTarget> shown() const { return rig.control.status().clientTarget; }
    [[nodiscard]] bool isLocked() const { return shown() && shown()->isLocked; }
    Result<> accept(const QString& target = QStringLiteral("TEST ONE"), std::uint64_t clientId = kClient.clientId)
    {
        return rig.ask(request::TrackForClient{.clientId = clientId, .target = target});
    }
    void apply(const std::function<void(profile::Profile&)>& change)
    {
        profile::Profile changed = rig.profile;
        change(changed);
        rig.setProfile(changed);
    }
    [[nodiscard]] bool hasNotice() const { return rig.alarms.active(alarmEntry("client.lock-ended")); }
    // What happened and what Boresight did, by the notice about the end of a lock.
    [[nodiscard]] std::string notice() const
    {
        for (const Alarm& alarm : rig.alarms.list()) {
            if (alarm.name == QLatin1String("client.lock-ended") && alarm.active) {
                return (alarm.what + QLatin1Char(' ') + alarm.action).toStdString();
            }
        }
        return {};
    }
    [[nodiscard]] Angle off() const { return angleBetween(*rig.control.status().commanded, direction()); }
    [[nodiscard]] bool stands()
    {
        rig.run(Seconds(3.0));
        const SkyPointing before = *rig.control.status().actual;
        rig.run(Seconds(5.0));
        return angleBetween(before, *rig.control.status().actual) < 0.02_deg;
    }
    [[nodiscard]] int lines(const char* words) const
    {
        const auto all = rig.log.since(0, EventLog::kCapacity);
        return static_cast<int>(
            std::ranges::count_if(all, [&](const LogEntry& line) { return line.text.contains(QLatin1String(words)); }));
    }

    StationRig rig;
    fakes::FoundOrbit found;
};

class StationLockAsk : public StationLock
{
protected:
    StationLockAsk() : StationLock(profile::ClientLock::Ask) {}
};

class StationLockNever : public StationLock
{
protected:
    StationLockNever() : StationLock(profile::ClientLock::Never) {}
};

}  // namespace boresight
