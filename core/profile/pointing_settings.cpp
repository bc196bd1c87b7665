// SPDX-License-Identifier: GPL-3.0-or-later
// How the true direction of the beam differs from what the axes show.
#include "core/base/text.h"
#include "core/profile/setting_groups.h"
#include "core/profile/setting_makers.h"
#include "core/units/degrees_text.h"

#include <set>

namespace boresight::profile {

using namespace makers;

namespace {

// A mount with larger errors needs mechanical adjustment instead of a correction.
constexpr Range kSmall{-10.0, 10.0};
// For an antenna that is tilted on the boom.
constexpr Range kAbove{-30.0, 30.0};

template <class Access>
Setting term(const std::string& name, Range range, const Words& words, Access access)
{
    return number("pointing." + name + "_deg", "°", range, Applies::Now, words, access);
}

std::vector<SettingOf<pointing::Antenna>> makeAntennaSettings()
{
    using pointing::Antenna;
    return {
        name<Antenna>(
            "name", Applies::Now,
            {QT_TRANSLATE_NOOP("Text", "Antenna"),
             QT_TRANSLATE_NOOP("Text", "Name of the antenna. \"main\" is the antenna that the table mount describes.")},
            [](auto& row) -> auto& { return row.name; }),
        number<Antenna>(
            "beam_width_deg", "°", {0.01, 180.0}, Applies::Now,
            {QT_TRANSLATE_NOOP("Text", "Beam width"),
             QT_TRANSLATE_NOOP("Text", "Half-power beam width of the antenna.")},
            [](auto& row) -> auto& { return row.beamWidth; }),
        number<Antenna>(
            "offset_across_deg", "°", kSmall, Applies::Now,
            {QT_TRANSLATE_NOOP("Text", "Offset across"),
             QT_TRANSLATE_NOOP("Text",
                               "How far its beam points clockwise of the main beam, measured on the sky at any "
                               "elevation. A negative value is counter-clockwise.")},
            [](auto& row) -> auto& { return row.across; }),
        number<Antenna>(
            "offset_up_deg", "°", kAbove, Applies::Now,
            {QT_TRANSLATE_NOOP("Text", "Offset up"),
             QT_TRANSLATE_NOOP("Text", "How far its beam points above the main beam. A negative value is below.")},
            [](auto& row) -> auto& { return row.up; })};
}

}  // namespace

std::span<const SettingOf<pointing::Antenna>> antennaSettings()
{
    static const std::vector<SettingOf<pointing::Antenna>> list = makeAntennaSettings();
    return list;
}

void checkAntennas(std::vector<Problem>& problems, const Profile& profile)
{
    if (profile.antennas.size() > kMaxAntennas) {
        problems.push_back(
            {std::string(kAntennaKey),
             Text::tr("%1 antennas are too many. The maximum is %2.").arg(profile.antennas.size()).arg(kMaxAntennas)});
    }
    std::set<std::string> names{pointing::kMainAntenna};
    for (std::size_t i = 0; i < profile.antennas.size(); ++i) {
        const std::string& name = profile.antennas[i].name;
        if (!names.insert(name).second) {
            const std::string key = std::string(kAntennaKey) + "[" + std::to_string(i + 1) + "].name";
            problems.push_back({key, profile.antennas[i].isMain()
                                         ? Text::tr("\"main\" is the name of the antenna that the table mount "
                                                    "describes. Choose another name.")
                                         : Text::tr("The name \"%1\" is used twice.").arg(toQString(name))});
        }
    }
}

// What Boresight does not do on an X/Y mount is refused here, so that such a mount never moves by a setting that means
// something else.
void checkGeometry(std::vector<Problem>& problems, const Profile& profile)
{
    using pointing::Geometry;
    if (profile.pointing.geometry.kind != Geometry::XY) {
        return;
    }
    const auto refuse = [&](const std::string& key, const QString& text) { problems.push_back({key, text}); };
    for (const Axis axis : kAxes) {
        const std::string table = axis == Axis::Azimuth ? "azimuth" : "elevation";
        const Angle most = axis == Axis::Azimuth ? 180_deg : 90_deg;
        const TravelRange& travel = profile.axis(axis).geometry.travel;
        if (profile.axis(axis).driver != AxisDriver::Moteus) {
            refuse(table + ".driver", Text::tr("An X/Y mount needs a moteus drive for each axis."));
        }
        if (travel.min < -most || travel.max > most) {
            refuse(table + (travel.min < -most ? ".travel_min_deg" : ".travel_max_deg"),
                   (axis == Axis::Azimuth ? Text::tr("The X axis of an X/Y mount turns by at most %1 to each side.")
                                          : Text::tr("The Y axis of an X/Y mount turns by at most %1 to each side."))
                       .arg(degreesText(most, 0)));
        }
    }
    for (const Setting& setting : settings()) {
        const bool isTerm = setting.key.starts_with("pointing.");
        if (isTerm && setting.get(profile) != setting.get(Profile{})) {
            refuse(setting.key,
                   Text::tr("An X/Y mount has no pointing terms. Set 0, and enter the zero of each axis as "
                            "azimuth.offset_deg and elevation.offset_deg."));
        }
    }
    for (std::size_t i = 0; i < profile.antennas.size(); ++i) {
        if (profile.antennas[i].across != Angle{} || profile.antennas[i].up != Angle{}) {
            refuse(
                std::string(kAntennaKey) + "[" + std::to_string(i + 1) + "].offset_across_deg",
                Text::tr("On an X/Y mount every antenna points where the main antenna points. Set both offsets to 0."));
        }
    }
    if (profile.sensor.source != SensorSource::None) {
        refuse("sensor.source", Text::tr("Boresight cannot use an orientation sensor on an X/Y mount. Set \"none\"."));
    }
    if (profile.rotctld.azimuth == AzimuthConvention::Continuous) {
        refuse("rotctld.azimuth",
               Text::tr("\"continuous\" counts turns of the azimuth axis, which an X/Y mount does not have."));
    }
}

void addMountGeometry(std::vector<Setting>& list)
{
    list.push_back(choice(
        "mount.geometry",
        {{"az-el", QT_TRANSLATE_NOOP("Text", "Azimuth/elevation")}, {"x-y", QT_TRANSLATE_NOOP("Text", "X/Y")}},
        Applies::OnReconnect,
        {QT_TRANSLATE_NOOP("Text", "Geometry"),
         QT_TRANSLATE_NOOP(
             "Text",
             "What the two axes turn about. \"az-el\": azimuth and elevation. \"x-y\": the lower axis X "
             "is horizontal and carries the upper axis Y. At X 0° and Y 0° the beam points to the zenith. "
             "All settings of the azimuth axis are then those of X, and those of the elevation axis are "
             "those of Y.")},
        [](auto& p) -> auto& { return p.pointing.geometry.kind; }));
    list.push_back(number(
        "mount.x_axis_deg", "°", {0.0, 360.0}, Applies::OnReconnect,
        {QT_TRANSLATE_NOOP("Text", "Direction of the X axis"),
         QT_TRANSLATE_NOOP(
             "Text",
             "Only for \"x-y\": true azimuth of the X axis. 0 is north-south, 90 is east-west. A positive "
             "Y leans the beam to this azimuth, a positive X to the azimuth 90° clockwise of it.")},
        [](auto& p) -> auto& { return p.pointing.geometry.xAxis; }));
}

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
