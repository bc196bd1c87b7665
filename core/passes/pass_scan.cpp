// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/passes/pass_scan.h"

#include "core/passes/clear_stretches.h"
#include "core/passes/turning_points.h"

#include <algorithm>

namespace boresight::passes {

PassScan::PassScan(const orbit::Sgp4& orbit, const PassSearch& search)
    : m_search(search), m_track(orbit, search), m_span(Seconds(search.to - search.from).count())
{}

PassList PassScan::run(const std::stop_token& stop)
{
    if (m_span <= 0.0) {
        return {};
    }
    const auto first = m_track.at(0.0);
    if (!first) {
        m_found.end = OrbitEnd{.utc = m_search.from, .fault = m_track.fault()};
        return std::move(m_found);
    }
    SkyMoment now = *first;
    if (now.isUp()) {
        m_open = OpenPass{.rise = now, .top = now, .isUpAtStart = true};
    }
    while (now.seconds < m_span && !stop.stop_requested()) {
        const auto next = m_track.at(std::min(m_span, now.seconds + std::max(now.step, now.rest())));
        if (!next || !advance(now, *next)) {
            const SkyMoment last = endOfOrbit(now);
            if (advance(now, last)) {
                now = last;
            }
            m_found.end = OrbitEnd{.utc = m_track.utc(now.seconds), .fault = m_track.fault()};
            break;
        }
        now = *next;
    }
    if (m_open && !stop.stop_requested()) {
        close(now, true);
    }
    return std::move(m_found);
}

bool PassScan::addCrossing(const SkyMoment& a, const SkyMoment& b, std::vector<Event>& events)
{
    if (a.isUp() == b.isUp()) {
        return true;
    }
    const auto edge = crossing(m_track, a, b);
    if (edge) {
        events.push_back({b.isUp() ? Turn::Rise : Turn::Set, *edge});
    }
    return edge.has_value();
}

// The events between two moments that have at most one turning point between them.
bool PassScan::findEvents(const SkyMoment& a, const SkyMoment& b, std::vector<Event>& events)
{
    const bool areUp = a.isUp() && b.isUp();
    const bool hasTop = a.climbs() && !b.climbs() && (a.isUp() || b.isUp() || mayBeUpBetween(a, b));
    const bool hasDip = !a.climbs() && b.climbs() && areUp;
    if (!hasTop && !hasDip) {
        return addCrossing(a, b, events);
    }
    // Unless both ends are up, the turning point must lie between them. Otherwise rise and set could swap.
    const Limits limits = areUp ? Limits{std::max(0.0, a.seconds - a.step), std::min(m_span, b.seconds + b.step)}
                                : Limits{a.seconds, b.seconds};
    const auto turn = turningPoint(m_track, a, b, limits);
    if (!turn || !addCrossing(a, *turn, events)) {
        return false;
    }
    if (hasTop && turn->isUp()) {
        events.push_back({Turn::Top, *turn});
    }
    return addCrossing(*turn, b, events);
}

// If SGP4 has no answer within a step, nothing from that step is used.
bool PassScan::advance(const SkyMoment& a, const SkyMoment& b)
{
    std::vector<Event> events;
    if (!findEvents(a, b, events)) {
        return false;
    }
    std::ranges::for_each(events, [this](const Event& event) { take(event); });
    if (m_open && b.sineElevation > m_open->top.sineElevation) {
        m_open->top = b;
    }
    return true;
}

void PassScan::take(const Event& event)
{
    switch (event.turn) {
        case Turn::Rise:
            m_open = OpenPass{.rise = event.moment, .top = event.moment};
            break;
        case Turn::Top:
            if (m_open) {
                ++m_open->maxima;
                if (event.moment.sineElevation > m_open->top.sineElevation) {
                    m_open->top = event.moment;
                }
            }
            break;
        case Turn::Set:
            close(event.moment, false);
            break;
    }
}

void PassScan::close(const SkyMoment& set, bool isUpAtEnd)
{
    if (!m_open) {
        return;
    }
    Pass pass{.aos = m_track.passMoment(m_open->rise),
              .tca = m_track.passMoment(m_open->top),
              .los = m_track.passMoment(set),
              .isUpAtStart = m_open->isUpAtStart,
              .isUpAtEnd = isUpAtEnd,
              .maxima = m_open->maxima};
    if (m_search.isClear) {
        pass.clear = clearStretches(m_track, m_open->rise.seconds, set.seconds, m_search.isClear);
    }
    m_found.passes.push_back(std::move(pass));
    m_open.reset();
}

// The last moment with an answer of SGP4, to 1 ms. `good` is a moment with an answer.
SkyMoment PassScan::endOfOrbit(SkyMoment good)
{
    constexpr double kOrbitEndWidth = 1e-3;  // s
    double bad = m_track.faultSeconds();
    while (bad - good.seconds > kOrbitEndWidth) {
        const double middle = 0.5 * (good.seconds + bad);
        if (const auto moment = m_track.at(middle)) {
            good = *moment;
        } else {
            bad = middle;
        }
    }
    return good;
}

}  // namespace boresight::passes
