// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sources/motion_sources.h"

#include "core/sources/azel_follow.h"
#include "core/sources/body_stream.h"
#include "core/sources/client_move.h"
#include "core/sources/client_stream.h"
#include "core/sources/go_to.h"
#include "core/sources/idle_park.h"
#include "core/sources/jog.h"
#include "core/sources/known_places.h"
#include "core/sources/park.h"
#include "core/sources/position_follow.h"
#include "core/sources/rotator_follow.h"
#include "core/sources/step.h"
#include "core/sources/target_track.h"
#include "core/sources/trial_run.h"
#include "core/sources/wind_stow.h"

namespace boresight {
namespace {

template <class Wanted, class... Each>
// NOLINTNEXTLINE(misc-redundant-expression): each operand asks another source
constexpr bool isTaken = (Each::Taken::template has<Wanted> || ...);

template <class... Each, class... Wanted>
constexpr bool takeAll(RequestList<Wanted...> /*requests*/)
{
    return (isTaken<Wanted, Each...> && ...);
}

template <class... Each>
MotionSources listed(Helm& helm)
{
    static_assert(takeAll<Each...>(MotionRequests{}), "no source of motion takes one of the requests");
    MotionSources list;
    (list.push_back(std::make_unique<Each>(helm)), ...);
    return list;
}

}  // namespace

// The list of all sources. A new source needs its own file and one line here.
MotionSources motionSources(Helm& helm)
{
    return listed<sources::GoTo,            //
                  sources::KnownPlaces,     //
                  sources::Park,            //
                  sources::Step,            //
                  sources::Jog,             //
                  sources::ClientMove,      //
                  sources::ClientStream,    //
                  sources::BodyStream,      //
                  sources::TargetTrack,     //
                  sources::AzelFollow,      //
                  sources::PositionFollow,  //
                  sources::RotatorFollow,   //
                  sources::TrialRun,        //
                  sources::IdlePark,        //
                  sources::WindStow         //
                  >(helm);
}

}  // namespace boresight
