// SPDX-License-Identifier: GPL-3.0-or-later
// How the true direction of the beam differs from what the axes show.
#include "core/base/text.h"
#include "core/profile/setting_groups.h"
#include "core/profile/setting_makers.h"

namespace boresight::profile {

using namespace makers;

namespace {

// A mount that needs more is not to be corrected but to be put right.
constexpr Range kSmall{-10.0, 10.0};

template <class Access>
Setting term(const std::string& name, Range range, const std::string& text, Access access)
{
    return number("pointing." + name + "_deg", "°", range, Applies::Now, text, access);
}

}  // namespace

void addPointing(std::vector<Setting>& list)
{
    list.push_back(term(
        "azimuth_offset", {-360.0, 360.0},
        QT_TRANSLATE_NOOP("Text",
                          "True azimuth of the beam where the azimuth axis shows 0°: how the mount finds north."),
        [](auto& p) -> auto& { return p.pointing.azimuthOffset; }));
    list.push_back(term(
        "elevation_offset", kSmall,
        QT_TRANSLATE_NOOP("Text", "True elevation of the beam where the elevation axis shows 0°."),
        [](auto& p) -> auto& { return p.pointing.elevationOffset; }));
    list.push_back(term(
        "tilt_north", kSmall,
        QT_TRANSLATE_NOOP("Text", "How far the azimuth axis leans to the north; negative to the south."),
        [](auto& p) -> auto& { return p.pointing.tiltNorth; }));
    list.push_back(term(
        "tilt_east", kSmall,
        QT_TRANSLATE_NOOP("Text", "How far the azimuth axis leans to the east; negative to the west."),
        [](auto& p) -> auto& { return p.pointing.tiltEast; }));
    list.push_back(term(
        "collimation", kSmall,
        QT_TRANSLATE_NOOP(
            "Text", "How far the beam looks clockwise of the right angle to the elevation axis, at any elevation."),
        [](auto& p) -> auto& { return p.pointing.collimation; }));
    list.push_back(term(
        "non_perpendicularity", kSmall,
        QT_TRANSLATE_NOOP("Text",
                          "How far the elevation axis is off the right angle to the azimuth axis: a raised beam then "
                          "looks clockwise."),
        [](auto& p) -> auto& { return p.pointing.nonPerpendicularity; }));
    list.push_back(term(
        "elevation_sag", kSmall,
        QT_TRANSLATE_NOOP("Text", "How much lower the beam hangs at the horizon than at the zenith."),
        [](auto& p) -> auto& { return p.pointing.elevationSag; }));
}

}  // namespace boresight::profile
