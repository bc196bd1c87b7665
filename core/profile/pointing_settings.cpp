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
Setting term(const std::string& name, Range range, const Words& words, Access access)
{
    return number("pointing." + name + "_deg", "°", range, Applies::Now, words, access);
}

}  // namespace

void addPointing(std::vector<Setting>& list)
{
    list.push_back(term(
        "azimuth_offset", {-360.0, 360.0},
        {QT_TRANSLATE_NOOP("Text", "North offset"),
         QT_TRANSLATE_NOOP("Text",
                           "True azimuth of the beam when the azimuth axis shows 0°. The North panel finds it.")},
        [](auto& p) -> auto& { return p.pointing.azimuthOffset; }));
    list.push_back(term(
        "elevation_offset", kSmall,
        {QT_TRANSLATE_NOOP("Text", "Elevation offset"),
         QT_TRANSLATE_NOOP("Text", "True elevation of the beam when the elevation axis shows 0°.")},
        [](auto& p) -> auto& { return p.pointing.elevationOffset; }));
    list.push_back(term(
        "tilt_north", kSmall,
        {QT_TRANSLATE_NOOP("Text", "Tilt to the north"),
         QT_TRANSLATE_NOOP("Text",
                           "How far the azimuth axis leans to the north. A negative value leans to the south.")},
        [](auto& p) -> auto& { return p.pointing.tiltNorth; }));
    list.push_back(term(
        "tilt_east", kSmall,
        {QT_TRANSLATE_NOOP("Text", "Tilt to the east"),
         QT_TRANSLATE_NOOP("Text", "How far the azimuth axis leans to the east. A negative value leans to the west.")},
        [](auto& p) -> auto& { return p.pointing.tiltEast; }));
    list.push_back(term(
        "collimation", kSmall,
        {QT_TRANSLATE_NOOP("Text", "Collimation"),
         QT_TRANSLATE_NOOP("Text",
                           "Angle by which the beam is not perpendicular to the elevation axis. Clockwise is positive, "
                           "at any elevation.")},
        [](auto& p) -> auto& { return p.pointing.collimation; }));
    list.push_back(term(
        "non_perpendicularity", kSmall,
        {QT_TRANSLATE_NOOP("Text", "Axes not perpendicular"),
         QT_TRANSLATE_NOOP("Text",
                           "Angle by which the two axes are not perpendicular. With a positive angle a raised beam "
                           "points clockwise.")},
        [](auto& p) -> auto& { return p.pointing.nonPerpendicularity; }));
    list.push_back(term(
        "elevation_sag", kSmall,
        {QT_TRANSLATE_NOOP("Text", "Sag"),
         QT_TRANSLATE_NOOP("Text", "How much lower the beam hangs at the horizon than at the zenith.")},
        [](auto& p) -> auto& { return p.pointing.elevationSag; }));
}

}  // namespace boresight::profile
