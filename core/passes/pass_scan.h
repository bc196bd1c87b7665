// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/passes/sky_track.h"

#include <optional>
#include <stop_token>
#include <vector>

// One search from its first to its last moment. It samples the orbit in steps that contain at most one maximum of the
// elevation, and skips the time in which the satellite is far below the horizon. Rises, maxima and sets are combined to
// passes. One thread.
namespace boresight::passes {

class PassScan
{
public:
    PassScan(const orbit::Sgp4& orbit, const PassSearch& search);

    [[nodiscard]] PassList run(const std::stop_token& stop);
    // The number of SGP4 calls, which take most of the time.
    [[nodiscard]] long propagations() const { return m_track.propagations(); }

private:
    enum class Turn
    {
        Rise,
        Top,
        Set
    };
    struct Event
    {
        Turn turn;
        SkyMoment moment;
    };
    struct OpenPass
    {
        SkyMoment rise;
        SkyMoment top;
        bool isUpAtStart = false;
        int maxima = 0;
    };

    [[nodiscard]] bool addCrossing(const SkyMoment& a, const SkyMoment& b, std::vector<Event>& events);
    [[nodiscard]] bool findEvents(const SkyMoment& a, const SkyMoment& b, std::vector<Event>& events);
    [[nodiscard]] bool advance(const SkyMoment& a, const SkyMoment& b);
    void take(const Event& event);
    void close(const SkyMoment& set, bool isUpAtEnd);
    [[nodiscard]] SkyMoment endOfOrbit(SkyMoment good);

    const PassSearch& m_search;
    SkyTrack m_track;
    double m_span;  // s
    std::optional<OpenPass> m_open;
    PassList m_found;
};

}  // namespace boresight::passes
