// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/profile/sensor_settings.h"

#include "core/base/control_characters.h"
#include "core/base/text.h"
#include "core/profile/setting_groups.h"
#include "core/profile/setting_makers.h"
#include "core/profile/unreliable_arcs.h"

namespace boresight::profile {

using namespace makers;

namespace {

constexpr std::size_t kSensorSettingsLongest = 1000;

Result<> checkPath(const std::string& text)
{
    if (text.size() > kSensorSettingsLongest || hasControlCharacters(text)) {
        return failure(ErrorCode::InvalidInput, Text::tr("a path on one line is expected"));
    }
    return {};
}

// One that is listened to: without the patterns that mean many.
Result<> checkTopic(const std::string& text)
{
    if (text.empty() || text.size() > kSensorSettingsLongest || hasControlCharacters(text) ||
        text.find_first_of("+#") != std::string::npos) {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("a topic is expected, like \"antenna/orientation\", without + and #"));
    }
    return {};
}

Setting line(const std::string& key, const std::string& text, std::string SensorSettings::*field,
             Result<> (*check)(const std::string&))
{
    return textual(
        key, kNow, text, [field](const Profile& p) { return p.sensor.*field; },
        [field, check](Profile& p, const std::string& wanted) {
            return check(wanted).map([&] { p.sensor.*field = wanted; });
        });
}

void addTransport(std::vector<Setting>& list)
{
    list.push_back(choice(
        "sensor.source", {"none", "serial", "mqtt", "simulated"}, kNow,
        QT_TRANSLATE_NOOP(
            "Text",
            "Whether there is an orientation sensor on the antenna, and how it is heard; \"simulated\" is "
            "that of the simulated mount."),
        [](auto& p) -> auto& { return p.sensor.source; }));
    list.push_back(line("sensor.port",
                        QT_TRANSLATE_NOOP("Text",
                                          "Device of the sensor's serial port; a name in /dev/serial/by-id stays the "
                                          "same in every socket."),
                        &SensorSettings::port, checkPath));
    list.push_back(integer(
        "sensor.baud", "Bd", {300, 4000000}, kNow, QT_TRANSLATE_NOOP("Text", "Speed of the sensor's serial port."),
        [](auto& p) -> auto& { return p.sensor.baud; }));
    list.push_back(line("sensor.orientation_topic",
                        QT_TRANSLATE_NOOP("Text", "MQTT topic of the sensor's azimuth and elevation."),
                        &SensorSettings::orientationTopic, checkTopic));
    list.push_back(line("sensor.status_topic",
                        QT_TRANSLATE_NOOP("Text", "MQTT topic of the sensor's temperature and firmware."),
                        &SensorSettings::statusTopic, checkTopic));
    list.push_back(line("sensor.calibration_topic",
                        QT_TRANSLATE_NOOP("Text", "MQTT topic of the sensor's own calibration."),
                        &SensorSettings::calibrationTopic, checkTopic));
}

void addMounting(std::vector<Setting>& list)
{
    list.push_back(choice(
        "sensor.azimuth_sense", {"clockwise", "counterclockwise"}, kNow,
        QT_TRANSLATE_NOOP("Text",
                          "Which way the sensor's azimuth grows, seen from above; it depends on how it is mounted. "
                          "Turn the mount and look."),
        [](auto& p) -> auto& { return p.sensor.mounting.sense; }));
    list.push_back(number(
        "sensor.azimuth_offset_deg", "°", {-360.0, 360.0}, kNow,
        QT_TRANSLATE_NOOP("Text", "True azimuth of the beam where the sensor looks north."),
        [](auto& p) -> auto& { return p.sensor.mounting.azimuthOffset; }));
    list.push_back(number(
        "sensor.elevation_offset_deg", "°", {-180.0, 180.0}, kNow,
        QT_TRANSLATE_NOOP("Text", "Elevation of the beam where the sensor says 0°."),
        [](auto& p) -> auto& { return p.sensor.mounting.elevationOffset; }));
}

template <class Access>
Setting harmonic(const std::string& key, const std::string& text, Access access)
{
    constexpr Range kDeviation{-60.0, 60.0};
    return number("sensor." + key, "°", kDeviation, kNow, text, access);
}

// How far that curve is to be believed.
void addTrust(std::vector<Setting>& list)
{
    list.push_back(number(
        "sensor.deviation_sigma_deg", "°", {0.0, 90.0}, kNow,
        QT_TRANSLATE_NOOP("Text",
                          "How well the north that came with the deviation is known, 1 sigma; 0: it is not known."),
        [](auto& p) -> auto& { return p.sensor.deviation.sigma; }));
    list.push_back(number(
        "sensor.deviation_elevation_deg", "°", {-90.0, 180.0}, kNow,
        QT_TRANSLATE_NOOP("Text", "Elevation of the boom while the compass was swung: there the deviation holds best."),
        [](auto& p) -> auto& { return p.sensor.deviation.elevation; }));
    list.push_back(textual(
        "sensor.deviation_unreliable", kNow,
        QT_TRANSLATE_NOOP("Text",
                          "True headings at which steel steers the compass and its azimuth is no evidence, clockwise, "
                          "like \"40-80, 350-20\"; empty: nowhere."),
        [](const Profile& p) { return toText(p.sensor.deviation.unreliable); },
        [](Profile& p, const std::string& text) {
            return parseArcs(text).map(
                [&](std::vector<UnreliableArc> arcs) { p.sensor.deviation.unreliable = std::move(arcs); });
        }));
}

void addDeviation(std::vector<Setting>& list)
{
    list.push_back(harmonic(
        "deviation_a1_deg",
        QT_TRANSLATE_NOOP("Text",
                          "Deviation of the sensor's compass, as a swing finds it: the part that goes with the sine of "
                          "the true heading."),
        [](auto& p) -> auto& { return p.sensor.deviation.a1; }));
    list.push_back(harmonic(
        "deviation_b1_deg", QT_TRANSLATE_NOOP("Text", "The same: the part that goes with the cosine of the heading."),
        [](auto& p) -> auto& { return p.sensor.deviation.b1; }));
    list.push_back(harmonic(
        "deviation_a2_deg",
        QT_TRANSLATE_NOOP("Text", "The same: the part that goes with the sine of twice the heading."),
        [](auto& p) -> auto& { return p.sensor.deviation.a2; }));
    list.push_back(harmonic(
        "deviation_b2_deg",
        QT_TRANSLATE_NOOP("Text", "The same: the part that goes with the cosine of twice the heading."),
        [](auto& p) -> auto& { return p.sensor.deviation.b2; }));
    addTrust(list);
}

void addDeclination(std::vector<Setting>& list)
{
    constexpr Range kDeclination{-180.0, 180.0};
    list.push_back(choice(
        "sensor.declination_by", {"sensor", "boresight", "none"}, kNow,
        QT_TRANSLATE_NOOP(
            "Text",
            "Who applies the magnetic declination: the sensor alone, Boresight alone (that of the site in "
            "place of the sensor's), or nobody."),
        [](auto& p) -> auto& { return p.sensor.declinationBy; }));
    list.push_back(number(
        "sensor.firmware_declination_deg", "°", kDeclination, kNow,
        QT_TRANSLATE_NOOP("Text", "What the sensor's firmware adds to its azimuth: 5.07° as delivered, for Berlin."),
        [](auto& p) -> auto& { return p.sensor.declinationInSensor; }));
    list.push_back(number(
        "sensor.declination_deg", "°", kDeclination, kNow,
        QT_TRANSLATE_NOOP("Text", "Magnetic declination of the site, east positive, while declination_file is empty."),
        [](auto& p) -> auto& { return p.sensor.declination; }));
    list.push_back(line("sensor.declination_file",
                        QT_TRANSLATE_NOOP("Text",
                                          "Coefficients of the World Magnetic Model (.COF), to reckon the declination "
                                          "of the site from."),
                        &SensorSettings::declinationFile, checkPath));
}

void addJudgement(std::vector<Setting>& list)
{
    constexpr Range kCurrent{0.1, 100.0};
    list.push_back(number(
        "sensor.lost_s", "s", {2.0, 60.0}, kNow,
        QT_TRANSLATE_NOOP("Text", "The sensor is lost, and nothing is made of its last values, after so long without."),
        [](auto& p) -> auto& { return p.sensor.lost; }));
    list.push_back(number(
        "sensor.latency_s", "s", {0.0, 10.0}, kNow,
        QT_TRANSLATE_NOOP("Text",
                          "Age of the sensor's azimuth when it arrives: of the middle of what its firmware averages."),
        [](auto& p) -> auto& { return p.sensor.latency; }));
    list.push_back(number(
        "sensor.averaging_s", "s", {0.0, 10.0}, kNow,
        QT_TRANSLATE_NOOP("Text", "How long the firmware averages the azimuth."),
        [](auto& p) -> auto& { return p.sensor.averaging; }));
    list.push_back(number(
        "sensor.disagreement_deg", "°", {1.0, 90.0}, kNow,
        QT_TRANSLATE_NOOP("Text", "A hint when sensor and axes differ by so much for disagreement_s."),
        [](auto& p) -> auto& { return p.sensor.disagreement; }));
    list.push_back(number(
        "sensor.disagreement_s", "s", {0.5, 60.0}, kNow,
        QT_TRANSLATE_NOOP("Text", "How long sensor and axes may differ."),
        [](auto& p) -> auto& { return p.sensor.disagreementTime; }));
    list.push_back(number(
        "sensor.still_current_a", "A", kCurrent, kNow,
        QT_TRANSLATE_NOOP("Text",
                          "North is not averaged from the still sensor while a motor draws more: its field turns the "
                          "needle."),
        [](auto& p) -> auto& { return p.sensor.stillCurrent; }));
    list.push_back(number(
        "sensor.swing_current_a", "A", kCurrent, kNow,
        QT_TRANSLATE_NOOP("Text",
                          "A swing of the compass leaves out readings at which a motor draws more; turning needs some "
                          "current."),
        [](auto& p) -> auto& { return p.sensor.swingCurrent; }));
}

}  // namespace

void addSensor(std::vector<Setting>& list)
{
    addTransport(list);
    addMounting(list);
    addDeviation(list);
    addDeclination(list);
    addJudgement(list);
}

void checkSensor(std::vector<Problem>& problems, const Profile& profile)
{
    const SensorSettings& sensor = profile.sensor;
    const auto demand = [&problems](bool right, const char* key, const QString& text) {
        if (!right) {
            problems.push_back({std::string("sensor.") + key, text});
        }
    };
    demand(sensor.source != SensorSource::Serial || !sensor.port.empty(), "port",
           Text::tr("is needed while sensor.source is \"serial\""));
    demand(sensor.orientationTopic != sensor.statusTopic && sensor.orientationTopic != sensor.calibrationTopic,
           "orientation_topic", Text::tr("is the same as another topic of the sensor"));
    demand(sensor.statusTopic != sensor.calibrationTopic, "status_topic",
           Text::tr("is the same as another topic of the sensor"));
    demand(sensor.declinationBy != geomagnetism::DeclinationBy::Boresight || sensor.declinationFile.empty() ||
               profile.site.known,
           "declination_file", Text::tr("needs the place of the mount (site)"));
}

}  // namespace boresight::profile
