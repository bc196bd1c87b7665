// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/elements/element_set.h"
#include "core/recognise/sent_points.h"
#include "core/targets/target.h"
#include "core/units/site.h"

#include <QStringList>

#include <memory>
#include <vector>

// Finds the target that a client tracks, by the directions that it sends: a satellite of thousands, the Sun, the Moon,
// a planet or a radio source. Takes up to 50 ms, so it belongs on a thread of its own. Pure.
namespace boresight::recognise {

using SharedSatellites = std::shared_ptr<const std::vector<orbit::ElementSet>>;

struct Sky
{
    SharedSatellites satellites;  // never null
    Site site;
    double oldestDays = 30.0;  // satellites with older elements are left out
};

struct Recognition
{
    std::vector<targets::Target> fits;  // best first. Empty: none. More than one: they fit alike, at different places
    QStringList together;               // other satellites at the place of the first one, as docked ones are
    bool isMoving = false;              // the points move along the target. False: the client waits for a rise
    Angle lead = {};                    // how far ahead of the first one the moving points are
};

// `points` are one to five. One point, or several equal ones, are recognised only at the horizon: the client waits
// there for a rise within the next half hour.
[[nodiscard]] Recognition recognise(const SentPoints& points, const Sky& sky);

}  // namespace boresight::recognise
