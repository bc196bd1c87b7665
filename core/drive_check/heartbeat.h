// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/moteus/codec.h"

#include <optional>

// Detects from the uptime of one drive, asked once a second, that the drive lost its power. The millisecond counter
// (register 0x070) begins at 2^31 - 300000 at every power-up and overflows at 2^32, after 25 days. The last uptime is
// kept while the bus is lost, so that a power-up in that time is detected, too. Pure.
namespace boresight::drive_check {

class Heartbeat
{
public:
    explicit Heartbeat(int drive) : m_drive(drive) {}

    // Starts another round of queries. `board`: the board that answers now. An exchange of boards is no power-up.
    void begin(const moteus::Uuid& board);
    // The query when it is due. An unanswered query is repeated soon.
    [[nodiscard]] std::optional<CanFrame> frame(SteadyTime now);
    void take(const moteus::Reply& reply);

    // The last query since begin() was answered.
    [[nodiscard]] bool isAnswered() const { return m_sent && m_silences == 0; }
    [[nodiscard]] int silences() const { return m_silences; }  // queries since the last answer
    [[nodiscard]] int reboots() const { return m_reboots; }
    // Stays the same while the drive runs on, also when the counter overflows.
    [[nodiscard]] SteadyTime bootedAt() const { return m_bootedAt; }

private:
    struct Observation
    {
        moteus::Uuid board{};
        std::chrono::milliseconds uptime{0};
        SteadyTime at;
    };

    [[nodiscard]] static bool wentOn(const Observation& before, const Observation& after);

    int m_drive;
    moteus::Uuid m_board{};
    std::optional<Observation> m_last;
    // An observation that does not continue m_last. If the next observation continues this one, there was a power-up.
    std::optional<Observation> m_doubted;
    SteadyTime m_bootedAt{};
    std::optional<SteadyTime> m_sent;
    int m_silences = 0;
    int m_reboots = 0;
};

}  // namespace boresight::drive_check
