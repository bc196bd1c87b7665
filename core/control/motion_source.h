// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/azel/azel_feed.h"
#include "core/control/helm.h"
#include "core/messages/request.h"
#include "core/messages/rotator_report.h"
#include "core/position/position_text.h"
#include "core/recognise/recognise.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <type_traits>
#include <variant>
#include <vector>

// A source of motion takes requests, and asks the helm for a motion at once or in a later tick. The helm passes the
// gates, so a source contains none. Station thread only. All sources are in core/sources.
namespace boresight {

template <class... Wanted>
struct RequestList
{
    template <class One>
    static constexpr bool has = (std::is_same_v<One, Wanted> || ...);
};

// The requests that the control passes to the sources. The control answers all other requests itself. A request that
// nobody answers does not compile.
using MotionRequests =
    RequestList<request::PointSky, request::PointAxes, request::PointAxis, request::Jog, request::Move, request::Step,
                request::Follow, request::Track, request::Nudge, request::Horizon, request::Park, request::Home,
                request::Unwind, request::Trial, request::FollowAzel, request::FollowPosition, request::FollowRotator,
                request::TrackForClient>;

// What a source receives from outside: the content of azel.dat, a position report of a vehicle, the direction of
// another rotator, or the satellites with known elements.
using SourceReport =
    std::variant<azel::AzelReading, Result<position::PositionText>, RotatorReport, recognise::SharedSatellites>;

class MotionSource
{
public:
    explicit MotionSource(Helm& helm) : m_helm(helm) {}
    virtual ~MotionSource() = default;
    MotionSource(const MotionSource&) = delete;
    MotionSource& operator=(const MotionSource&) = delete;

    // The answer to a request for this source. Empty: the request is for another source.
    [[nodiscard]] virtual std::optional<Result<>> take(const Request& request, const Source& by) = 0;
    // Adds to the status what the source knows of its motion.
    virtual void describe(StationStatus& /*status*/) const {}
    // Once in a tick, before the set-points move on.
    virtual void step(SteadyTime /*now*/) {}
    // A report, which may be for another source. The error explains why the report is not accepted.
    virtual Result<> receive(const SourceReport& /*report*/) { return {}; }
    // Where the target that it tracks by the time is at this time. Empty: it tracks none, or the direction is unknown.
    [[nodiscard]] virtual std::optional<SkyPointing> targetAt(UtcTime /*utc*/) { return std::nullopt; }
    virtual void profileChanged(const profile::Profile& /*before*/, const profile::Profile& /*after*/) {}
    // This client has disconnected for good.
    virtual void gone(const Source& /*client*/) {}
    // This client has read the measured position.
    virtual void positionRead(std::uint64_t /*clientId*/) {}

protected:
    [[nodiscard]] Helm& helm() const { return m_helm; }

private:
    Helm& m_helm;
};

using MotionSources = std::vector<std::unique_ptr<MotionSource>>;
using MakeSources = std::function<MotionSources(Helm&)>;

// A source that takes requests of these types, each with a function `Result<> ask(const Wanted&, const Source&)`.
template <class Derived, class... Wanted>
class SourceOf : public MotionSource
{
    static_assert((MotionRequests::has<Wanted> && ...), "the control does not hand this request to the sources");

public:
    using MotionSource::MotionSource;
    using Taken = RequestList<Wanted...>;

    [[nodiscard]] std::optional<Result<>> take(const Request& request, const Source& by) final
    {
        std::optional<Result<>> answer;
        (answerIf<Wanted>(request, by, answer), ...);
        return answer;
    }

protected:
    // False leaves this request to another source that takes the same type from other askers.
    [[nodiscard]] virtual bool serves(const Request& /*request*/, const Source& /*by*/) const { return true; }

private:
    template <class One>
    void answerIf(const Request& request, const Source& by, std::optional<Result<>>& answer)
    {
        if (const One* const wanted = std::get_if<One>(&request); wanted && serves(request, by)) {
            answer = static_cast<Derived&>(*this).ask(*wanted, by);
        }
    }
};

}  // namespace boresight
