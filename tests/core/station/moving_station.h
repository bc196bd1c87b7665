// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/sim_bus/simulated_link.h"
#include "tests/core/station/linked_station.h"
#include "tests/fakes/wait_until.h"

#include <QElapsedTimer>

#include <algorithm>
#include <chrono>
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
    // The answer to the request with this number, once the station has answered. An answer that waits for a thread
    // needs `pace`, the real time between two ticks: else the station may lose its patience before the thread has run.
    std::optional<Answer> answerTo(std::uint64_t id, std::chrono::milliseconds pace = {})
    {
        const auto found = [&] { return std::ranges::find(answers, id, &Answer::requestId); };
        QElapsedTimer sinceTick;
        const bool isAnswered = fakes::waitUntil([&] {
            if (!sinceTick.isValid() || sinceTick.elapsed() >= pace.count()) {
                sinceTick.start();
                run(Seconds(0.02));
            }
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
