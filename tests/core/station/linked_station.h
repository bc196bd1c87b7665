// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/moteus_mount/moteus_connection.h"
#include "core/station/station.h"
#include "tests/fakes/fake_can_link.h"
#include "tests/fakes/ideal_drive.h"
#include "tests/fakes/manual_clock.h"

#include <QTemporaryDir>

#include <memory>
#include <utility>
#include <vector>

// A whole Station on a link that the test controls, with two ideal drives behind it.
namespace boresight {

inline profile::Profile anyPort()
{
    profile::Profile profile;
    profile.rotctld.listen.port = 0;
    return profile;
}

struct LinkedStation
{
    explicit LinkedStation(const profile::Profile& profile = anyPort())
    {
        auto owned = std::make_unique<fakes::FakeCanLink>();
        link = owned.get();
        station = std::make_unique<Station>(profile, moteusRotator(std::move(owned), {stateDir.path()}),
                                            stateDir.path(), clock);
        QObject::connect(station.get(), &Station::updated,
                         [this](const StationUpdate& update) { updates.push_back(update); });
    }

    void tick()
    {
        clock.advance(Seconds(0.02));
        link->sent.clear();
        station->tick();
        answerAll();
    }

    void answerAll()
    {
        for (const CanFrame& frame : std::exchange(link->sent, {})) {
            for (fakes::IdealDrive* const drive : {&azimuth, &elevation}) {
                if (const auto reply = drive->answer(frame, clock.now())) {
                    Q_EMIT link->frameReceived(*reply);
                }
            }
        }
    }

    void run(int ticks)
    {
        for (int i = 0; i < ticks; ++i) {
            tick();
        }
    }

    QTemporaryDir stateDir;
    fakes::ManualClock clock;
    fakes::FakeCanLink* link = nullptr;
    std::unique_ptr<Station> station;
    std::vector<StationUpdate> updates;
    fakes::IdealDrive azimuth{1, 0.0};
    fakes::IdealDrive elevation{2, -0.25};
};

}  // namespace boresight
