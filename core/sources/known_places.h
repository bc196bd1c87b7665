// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/control/motion_source.h"

// Sends the mount to a place that needs no numbers: home, the horizon, or the same direction with the cable unwrapped.
// Station thread only.
namespace boresight::sources {

class KnownPlaces : public SourceOf<KnownPlaces, request::Home, request::Horizon, request::Unwind>
{
public:
    using SourceOf::SourceOf;

    Result<> ask(const request::Home& wanted, const Source& by);
    Result<> ask(const request::Horizon& wanted, const Source& by);
    Result<> ask(const request::Unwind& wanted, const Source& by);
};

}  // namespace boresight::sources
