// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/moteus/codec.h"

#include <optional>

// The uptime of one drive, asked once a second, tells when it lost power: its millisecond counter (register 0x070)
// begins at 2^31 - 300000 at every power-up and wraps at 2^32, after 49 days. What was seen outlives a lost bus, so
// that a power-up behind our back is noticed too. Pure.
namespace boresight::survey {

class Heartbeat
{
public:
    explicit Heartbeat(int drive) : m_drive(drive) {}

    // Another round of questions; `board` tells a power-up from an exchange of boards.
    void begin(const moteus::Uuid& board);
    // The question when it is due; again soon while unanswered.
    [[nodiscard]] std::optional<CanFrame> frame(SteadyTime now);
    void take(const moteus::Reply& reply);

    // The last question, put since begin().
    [[nodiscard]] bool isAnswered() const { return m_sent && m_silences == 0; }
    [[nodiscard]] int silences() const { return m_silences; }  // questions since the last answer
    [[nodiscard]] int reboots() const { return m_reboots; }
    // Does not move while the drive runs on, also over the end of the counter.
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
    std::optional<Observation> m_doubted;  // does not continue the last one: a power-up if the next one continues it
    SteadyTime m_bootedAt{};
    std::optional<SteadyTime> m_sent;
    int m_silences = 0;
    int m_reboots = 0;
};

}  // namespace boresight::survey
