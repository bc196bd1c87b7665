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

Result<> checkSensorPath(const std::string& text)
{
    if (text.size() > kSensorSettingsLongest || hasControlCharacters(text)) {
        return failure(ErrorCode::InvalidInput, Text::tr("a path on one line is expected"));
    }
    return {};
}

// Checks a topic to read: not empty, one line, without the wildcards of MQTT.
Result<> checkTopic(const std::string& text)
{
    if (text.empty() || text.size() > kSensorSettingsLongest || hasControlCharacters(text) ||
        text.find_first_of("+#") != std::string::npos) {
        return failure(ErrorCode::InvalidInput,
                       Text::tr("a topic is expected, like \"antenna/orientation\", without + and #"));
    }
    return {};
}

Setting line(const std::string& key, const Words& words, std::string SensorSettings::*field,
             Result<> (*check)(const std::string&))
{
    return textual(
        key, kNow, words, [field](const Profile& p) { return p.sensor.*field; },
        [field, check](Profile& p, const std::string& wanted) {
            return check(wanted).map([&] { p.sensor.*field = wanted; });
        });
}

void addTransport(std::vector<Setting>& list)
{
    list.push_back(choice(
        "sensor.source",
        {{"none", QT_TRANSLATE_NOOP("Text", "None")},
         {"serial", QT_TRANSLATE_NOOP("Text", "Serial port")},
         {"mqtt", QT_TRANSLATE_NOOP("Text", "MQTT broker")},
         {"simulated", QT_TRANSLATE_NOOP("Text", "Simulated sensor")}},
        kNow,
        {QT_TRANSLATE_NOOP("Text", "Source"),
         QT_TRANSLATE_NOOP("Text",
                           "Whether an independent orientation sensor is on the antenna, and how Boresight reads it. "
                           "\"simulated\" is the sensor of the simulated mount.")},
        [](auto& p) -> auto& { return p.sensor.source; }));
    list.push_back(line(
        "sensor.port",
        {QT_TRANSLATE_NOOP("Text", "Serial port"),
         QT_TRANSLATE_NOOP(
             "Text",
             "Device of the serial port of the sensor. A name in /dev/serial/by-id stays the same in every socket.")},
        &SensorSettings::port, checkSensorPath));
    list.push_back(integer(
        "sensor.baud", "Bd", {300, 4000000}, kNow,
        {QT_TRANSLATE_NOOP("Text", "Baud rate"), QT_TRANSLATE_NOOP("Text", "Speed of the serial port of the sensor.")},
        [](auto& p) -> auto& { return p.sensor.baud; }));
    list.push_back(line("sensor.orientation_topic",
                        {QT_TRANSLATE_NOOP("Text", "Topic of the orientation"),
                         QT_TRANSLATE_NOOP("Text", "MQTT topic of the azimuth and the elevation of the sensor.")},
                        &SensorSettings::orientationTopic, checkTopic));
    list.push_back(line("sensor.status_topic",
                        {QT_TRANSLATE_NOOP("Text", "Topic of the status"),
                         QT_TRANSLATE_NOOP("Text", "MQTT topic of the temperature and the firmware of the sensor.")},
                        &SensorSettings::statusTopic, checkTopic));
    list.push_back(line("sensor.calibration_topic",
                        {QT_TRANSLATE_NOOP("Text", "Topic of the calibration"),
                         QT_TRANSLATE_NOOP("Text", "MQTT topic of the sensor's own calibration.")},
                        &SensorSettings::calibrationTopic, checkTopic));
}

void addMounting(std::vector<Setting>& list)
{
    list.push_back(choice(
        "sensor.azimuth_sense",
        {{"clockwise", QT_TRANSLATE_NOOP("Text", "Clockwise")},
         {"counterclockwise", QT_TRANSLATE_NOOP("Text", "Counterclockwise")}},
        kNow,
        {QT_TRANSLATE_NOOP("Text", "Azimuth direction"),
         QT_TRANSLATE_NOOP("Text",
                           "The direction in which the sensor's azimuth grows, seen from above. It depends on the "
                           "mounting. Turn the mount and watch the value.")},
        [](auto& p) -> auto& { return p.sensor.mounting.sense; }));
    list.push_back(choice(
        "sensor.elevation_sense",
        {{"up", QT_TRANSLATE_NOOP("Text", "Same as the beam")},
         {"down", QT_TRANSLATE_NOOP("Text", "Opposite to the beam")}},
        kNow,
        {QT_TRANSLATE_NOOP("Text", "Elevation direction"),
         QT_TRANSLATE_NOOP(
             "Text",
             "Whether the sensor's elevation grows (\"up\") or falls (\"down\") when the beam rises. For a "
             "sensor that reports 180° - elevation: \"down\", with an elevation offset of 180°.")},
        [](auto& p) -> auto& { return p.sensor.mounting.elevationSense; }));
    list.push_back(number(
        "sensor.azimuth_offset_deg", "°", {-360.0, 360.0}, kNow,
        {QT_TRANSLATE_NOOP("Text", "Azimuth offset"),
         QT_TRANSLATE_NOOP("Text", "True azimuth of the beam when the sensor points north.")},
        [](auto& p) -> auto& { return p.sensor.mounting.azimuthOffset; }));
    list.push_back(number(
        "sensor.elevation_offset_deg", "°", {-180.0, 180.0}, kNow,
        {QT_TRANSLATE_NOOP("Text", "Elevation offset"),
         QT_TRANSLATE_NOOP("Text", "Elevation of the beam when the sensor reports 0°.")},
        [](auto& p) -> auto& { return p.sensor.mounting.elevationOffset; }));
}

template <class Access>
Setting harmonic(const std::string& key, const Words& words, Access access)
{
    constexpr Range kDeviation{-60.0, 60.0};
    return number("sensor." + key, "°", kDeviation, kNow, words, access);
}

// The uncertainty of the compass error, and the headings where it is not usable.
void addTrust(std::vector<Setting>& list)
{
    list.push_back(number(
        "sensor.deviation_sigma_deg", "°", {0.0, 90.0}, kNow,
        {QT_TRANSLATE_NOOP("Text", "Uncertainty of north"),
         QT_TRANSLATE_NOOP("Text", "Uncertainty (1 sigma) of the north that the swing found. 0: unknown.")},
        [](auto& p) -> auto& { return p.sensor.deviation.sigma; }));
    list.push_back(number(
        "sensor.deviation_elevation_deg", "°", {-90.0, 180.0}, kNow,
        {QT_TRANSLATE_NOOP("Text", "Elevation of the swing"),
         QT_TRANSLATE_NOOP("Text",
                           "Elevation of the boom during the compass swing. The measured error is most exact there.")},
        [](auto& p) -> auto& { return p.sensor.deviation.elevation; }));
    list.push_back(textual(
        "sensor.deviation_unreliable", kNow,
        {QT_TRANSLATE_NOOP("Text", "Unreliable headings"),
         QT_TRANSLATE_NOOP("Text",
                           "True headings at which steel disturbs the compass, clockwise, for example \"40-80, "
                           "350-20\". Boresight does not use its azimuth there. Empty: none.")},
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
        {QT_TRANSLATE_NOOP("Text", "Compass error: sine"),
         QT_TRANSLATE_NOOP(
             "Text",
             "Error of the compass, as a swing measures it: the part that follows the sine of the true heading.")},
        [](auto& p) -> auto& { return p.sensor.deviation.a1; }));
    list.push_back(harmonic(
        "deviation_b1_deg",
        {QT_TRANSLATE_NOOP("Text", "Compass error: cosine"),
         QT_TRANSLATE_NOOP("Text", "The part that follows the cosine of the true heading.")},
        [](auto& p) -> auto& { return p.sensor.deviation.b1; }));
    list.push_back(harmonic(
        "deviation_a2_deg",
        {QT_TRANSLATE_NOOP("Text", "Compass error: sine of twice"),
         QT_TRANSLATE_NOOP("Text", "The part that follows the sine of twice the true heading.")},
        [](auto& p) -> auto& { return p.sensor.deviation.a2; }));
    list.push_back(harmonic(
        "deviation_b2_deg",
        {QT_TRANSLATE_NOOP("Text", "Compass error: cosine of twice"),
         QT_TRANSLATE_NOOP("Text", "The part that follows the cosine of twice the true heading.")},
        [](auto& p) -> auto& { return p.sensor.deviation.b2; }));
    addTrust(list);
}

void addDeclination(std::vector<Setting>& list)
{
    constexpr Range kDeclination{-180.0, 180.0};
    list.push_back(choice(
        "sensor.declination_by",
        {{"sensor", QT_TRANSLATE_NOOP("Text", "Sensor")},
         {"boresight", QT_TRANSLATE_NOOP("Text", "Boresight")},
         {"none", QT_TRANSLATE_NOOP("Text", "Nowhere")}},
        kNow,
        {QT_TRANSLATE_NOOP("Text", "Declination applied by"),
         QT_TRANSLATE_NOOP("Text",
                           "Where the magnetic declination is applied: in the sensor alone, in Boresight alone (for "
                           "the site, in place of the sensor's value), or nowhere.")},
        [](auto& p) -> auto& { return p.sensor.declinationBy; }));
    list.push_back(number(
        "sensor.firmware_declination_deg", "°", kDeclination, kNow,
        {QT_TRANSLATE_NOOP("Text", "Declination in the firmware"),
         QT_TRANSLATE_NOOP("Text",
                           "The sensor's firmware adds this angle to its azimuth: 5.07° as delivered, for Berlin.")},
        [](auto& p) -> auto& { return p.sensor.declinationInSensor; }));
    list.push_back(number(
        "sensor.declination_deg", "°", kDeclination, kNow,
        {QT_TRANSLATE_NOOP("Text", "Declination of the site"),
         QT_TRANSLATE_NOOP(
             "Text", "Magnetic declination of the site, east positive. It is used while the file below is empty.")},
        [](auto& p) -> auto& { return p.sensor.declination; }));
    list.push_back(line("sensor.declination_file",
                        {QT_TRANSLATE_NOOP("Text", "Magnetic model"),
                         QT_TRANSLATE_NOOP("Text",
                                           "Coefficients of the World Magnetic Model (.COF). Boresight computes the "
                                           "declination of the site from them.")},
                        &SensorSettings::declinationFile, checkSensorPath));
}

void addJudgement(std::vector<Setting>& list)
{
    constexpr Range kCurrent{0.1, 100.0};
    list.push_back(number(
        "sensor.lost_s", "s", {2.0, 60.0}, kNow,
        {QT_TRANSLATE_NOOP("Text", "Lost after"),
         QT_TRANSLATE_NOOP(
             "Text", "The sensor counts as lost after this time without a value. Its last values are then not used.")},
        [](auto& p) -> auto& { return p.sensor.lost; }));
    list.push_back(number(
        "sensor.latency_s", "s", {0.0, 10.0}, kNow,
        {QT_TRANSLATE_NOOP("Text", "Latency"),
         QT_TRANSLATE_NOOP("Text",
                           "Age of the sensor's azimuth when Boresight receives it. The age counts from the middle of "
                           "the firmware's averaging time.")},
        [](auto& p) -> auto& { return p.sensor.latency; }));
    list.push_back(number(
        "sensor.averaging_s", "s", {0.0, 10.0}, kNow,
        {QT_TRANSLATE_NOOP("Text", "Averaging time"),
         QT_TRANSLATE_NOOP("Text", "How long the firmware averages the azimuth.")},
        [](auto& p) -> auto& { return p.sensor.averaging; }));
    list.push_back(number(
        "sensor.disagreement_deg", "°", {1.0, 90.0}, kNow,
        {QT_TRANSLATE_NOOP("Text", "Disagreement: warn"),
         QT_TRANSLATE_NOOP("Text", "Warn when sensor and axes differ by this angle for the time below.")},
        [](auto& p) -> auto& { return p.sensor.disagreement; }));
    list.push_back(number(
        "sensor.disagreement_s", "s", {0.5, 60.0}, kNow,
        {QT_TRANSLATE_NOOP("Text", "Disagreement: time"),
         QT_TRANSLATE_NOOP("Text", "How long sensor and axes may differ.")},
        [](auto& p) -> auto& { return p.sensor.disagreementTime; }));
    list.push_back(number(
        "sensor.still_current_a", "A", kCurrent, kNow,
        {QT_TRANSLATE_NOOP("Text", "Current limit, standing"),
         QT_TRANSLATE_NOOP(
             "Text",
             "North is not averaged while a motor current is higher. The field of the motor disturbs the compass.")},
        [](auto& p) -> auto& { return p.sensor.stillCurrent; }));
    list.push_back(number(
        "sensor.swing_current_a", "A", kCurrent, kNow,
        {QT_TRANSLATE_NOOP("Text", "Current limit, swinging"),
         QT_TRANSLATE_NOOP(
             "Text", "A compass swing ignores readings taken at a higher motor current. Turning needs some current.")},
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
