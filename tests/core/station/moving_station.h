// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/sim_bus/simulated_link.h"
#include "tests/core/station/linked_station.h"
#include "tests/fakes/wait_until.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

namespace boresight {

// A whole station with a simulated mount that may move.
struct MovingStation
{
    explicit MovingStation(const QString& folder)
    {
        auto owned = std::make_unique<SimulatedLink>(clock);
        link = owned.get();
        station = std::make_unique<Station>(anyPort(), moteusRotator(std::move(owned), {folder, Simulation::Reference}),
                                            folder, clock);
        QObject::connect(station.get(), &Station::updated, [this](const StationUpdate& update) {
            answers.insert(answers.end(), update.answers.begin(), update.answers.end());
        });
        station->openAll();
        run(Seconds(4.0));  // until the drive check is done
    }

    void run(Seconds time)
    {
        for (Seconds left = time; left > Seconds(0.0); left -= Seconds(0.02)) {
            clock.advance(Seconds(0.02));
            link->deliver();
            station->tick();
        }
    }
    // The answer to the request with this number, once the station has answered.
    std::optional<Answer> answerTo(std::uint64_t id)
    {
        const auto found = [&] { return std::ranges::find(answers, id, &Answer::requestId); };
        const bool isAnswered = fakes::waitUntil([&] {
            run(Seconds(0.02));
            station->updateTaken();
            station->publish();
            return found() != answers.end();
        });
        return isAnswered ? std::optional(*found()) : std::nullopt;
    }

    fakes::ManualClock clock;
    SimulatedLink* link = nullptr;
    std::unique_ptr<Station> station;
    std::vector<Answer> answers;
};

}  // namespace boresight
