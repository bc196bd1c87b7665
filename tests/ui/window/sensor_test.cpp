// SPDX-License-Identifier: GPL-3.0-or-later
// The orientation sensor on the screen: its readout, its calibration bars, its link in the header, its marker.
#include "tests/ui/find_widget.h"
#include "ui/kit/value_label.h"
#include "ui/sky/sky_markers.h"
#include "ui/window/authority_button.h"
#include "ui/window/calibration_bars.h"
#include "ui/window/header_bar.h"
#include "ui/window/sensor_readout.h"

#include <QPainter>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace boresight::ui {
namespace {

SensorStatus calibrated()
{
    orientation::Orientation value;
    value.calibration = orientation::Calibration{.system = 3, .gyro = 3, .accelerometer = 2, .magnetometer = 1};
    return {.source = QStringLiteral("serial /dev/ttyUSB0"),
            .open = true,
            .presence = orientation::Presence::Present,
            .last = value,
            .age = std::chrono::milliseconds(300),
            .direction = SkyPointing{.azimuth = 334.9_deg, .elevation = 55.3_deg},
            .azimuthDifference = -0.4_deg};
}

QString shown(const QWidget& in, const char* accessibleName)
{
    return findNamed<ValueLabel>(in, accessibleName)->text();
}

TEST(SensorReadout, IsThereOnlyWithASensor)
{
    SensorReadout readout;
    readout.showStatus({});
    EXPECT_TRUE(readout.isHidden());
    readout.showStatus(calibrated());
    EXPECT_FALSE(readout.isHidden());
    EXPECT_EQ(shown(readout, "Direction by the sensor"), QStringLiteral("Sensor 334.9° 55.3°"));
    EXPECT_EQ(shown(readout, "Age of the sensor's value"), QStringLiteral("age 0.3 s"));
    EXPECT_EQ(shown(readout, "Sensor against the axes"), QStringLiteral("sensor minus axes: AZ -0.40°"));
}

TEST(SensorReadout, ALostOneShowsNoNumber)
{
    SensorStatus lost = calibrated();
    lost.presence = orientation::Presence::Lost;
    lost.direction.reset();
    lost.problem = QStringLiteral("/dev/ttyUSB0 is gone. Plug the sensor in again");
    SensorReadout readout;
    readout.showStatus(lost);
    EXPECT_FALSE(shown(readout, "Direction by the sensor").contains(QLatin1String("334")));
    EXPECT_EQ(shown(readout, "Sensor against the axes"), lost.problem);
    EXPECT_EQ(readout.findChild<CalibrationBars*>()->accessibleName(), QStringLiteral("Calibration: not reported"));
}

// REQ-UI-1718: While the broker of the sensor is not reached, the line of the sensor shows when Boresight tries again.
TEST(SensorReadout, ABrokerThatIsNotReachedShowsTheNextAttempt)
{
    const QString problem = QStringLiteral("MQTT broker 127.0.0.1:1883: No connection");
    const SensorStatus sensor{.source = QStringLiteral("MQTT 127.0.0.1:1883"), .problem = problem};
    SensorReadout readout;
    readout.showStatus(sensor, {.wanted = true, .problem = problem, .retryIn = Seconds(4.2)});
    EXPECT_EQ(shown(readout, "Sensor against the axes"),
              QStringLiteral("Broker not reached, next attempt in 5 s. MQTT broker 127.0.0.1:1883: No connection"));
    readout.showStatus(sensor, {.wanted = true, .problem = problem});
    EXPECT_EQ(shown(readout, "Sensor against the axes"), problem);
}

TEST(CalibrationBars, SayTheirDigits)
{
    CalibrationBars bars;
    EXPECT_EQ(bars.accessibleName(), QStringLiteral("Calibration: not reported"));
    bars.showCalibration(orientation::Calibration{.system = 0, .gyro = 3, .accelerometer = 1, .magnetometer = 2});
    EXPECT_EQ(bars.accessibleName(),
              QStringLiteral("Calibration: system 0, gyro 3, accelerometer 1, magnetometer 2 of 3"));
}

TEST(HeaderBar, ShowsTheSensorIfThereIsOne)
{
    RequestDesk desk;
    ValueLabel notice({}, {}, {});
    auto* const authority = new AuthorityButton(desk, notice);
    HeaderBar header(*authority);
    StationStatus status;
    header.showStatus(status);
    EXPECT_EQ(shown(header, "Orientation sensor"), QString());
    status.sensor = calibrated();
    header.showStatus(status);
    EXPECT_EQ(shown(header, "Orientation sensor"), QStringLiteral("Sensor"));
    status.sensor.presence = orientation::Presence::Late;
    header.showStatus(status);
    EXPECT_EQ(shown(header, "Orientation sensor"), QStringLiteral("Sensor late"));
    status.sensor.disagrees = true;
    header.showStatus(status);
    EXPECT_EQ(shown(header, "Orientation sensor"), QStringLiteral("Sensor differs"));
    status.sensor.dead = true;
    header.showStatus(status);
    EXPECT_EQ(shown(header, "Orientation sensor"), QStringLiteral("Sensor lost"));
}

// Story: while the broker did not answer, the header said "Sensor awaited", as if everything was well.
// REQ-UI-1463: A sensor that is awaited and has a problem, such as a broker that does not answer, is shown as silent in
// the header.
TEST(HeaderBar, CallsASensorWithAProblemSilent)
{
    RequestDesk desk;
    ValueLabel notice({}, {}, {});
    auto* const authority = new AuthorityButton(desk, notice);
    HeaderBar header(*authority);
    StationStatus status;
    status.sensor = {.source = QStringLiteral("MQTT 127.0.0.1:1883"), .open = true};
    header.showStatus(status);
    EXPECT_EQ(shown(header, "Orientation sensor"), QStringLiteral("Sensor awaited"));
    status.sensor.problem = QStringLiteral("MQTT broker 127.0.0.1:1883: No connection");
    header.showStatus(status);
    EXPECT_EQ(shown(header, "Orientation sensor"), QStringLiteral("Sensor silent"));
}

// REQ-TRANSMIT-30: The header shows whether the transmit output is on, and its tooltip shows what keeps it off. Without
// an output nothing is shown.
TEST(HeaderBar, ShowsTheTransmitOutputIfThereIsOne)
{
    RequestDesk desk;
    ValueLabel notice({}, {}, {});
    auto* const authority = new AuthorityButton(desk, notice);
    HeaderBar header(*authority);
    StationStatus status;
    header.showStatus(status);
    EXPECT_EQ(shown(header, "Transmit output"), QString());
    status.transmit = {
        .output = QStringLiteral("dtr:/dev/ttyUSB0"), .whyOff = QStringLiteral("STOP is latched."), .within = 2.5_deg};
    header.showStatus(status);
    EXPECT_EQ(shown(header, "Transmit output"), QStringLiteral("TX off"));
    EXPECT_EQ(findNamed<ValueLabel>(header, "Transmit output")->toolTip(),
              QStringLiteral("The output dtr:/dev/ttyUSB0 is on only while the beam is less than 2.50° from the "
                             "target.\nSTOP is latched."));
    status.transmit.whyOff.clear();
    status.transmit.on = true;
    header.showStatus(status);
    EXPECT_EQ(shown(header, "Transmit output"), QStringLiteral("TX on"));
    status.transmit.problem = QStringLiteral("unplugged");
    header.showStatus(status);
    EXPECT_EQ(shown(header, "Transmit output"), QStringLiteral("TX output failed"));
}

// REQ-BRAKE-30: The header shows whether the brake is set. Without a brake nothing is shown.
TEST(HeaderBar, ShowsTheBrakeIfThereIsOne)
{
    RequestDesk desk;
    ValueLabel notice({}, {}, {});
    auto* const authority = new AuthorityButton(desk, notice);
    HeaderBar header(*authority);
    StationStatus status;
    header.showStatus(status);
    EXPECT_EQ(shown(header, "Brake"), QString());
    status.brake = {.output = QStringLiteral("rts:/dev/ttyUSB0"), .state = brake::BrakeState::Set};
    header.showStatus(status);
    EXPECT_EQ(shown(header, "Brake"), QStringLiteral("Brake set"));
    status.brake.state = brake::BrakeState::Released;
    header.showStatus(status);
    EXPECT_EQ(shown(header, "Brake"), QStringLiteral("Brake open"));
    EXPECT_EQ(
        findNamed<ValueLabel>(header, "Brake")->toolTip(),
        QStringLiteral(
            "The output rts:/dev/ttyUSB0 is on while the brake is open. Nothing moves before the brake is open."));
    status.brake.problem = QStringLiteral("unplugged");
    header.showStatus(status);
    EXPECT_EQ(shown(header, "Brake"), QStringLiteral("Brake failed"));
    status.transmit = {.output = QStringLiteral("dtr:/dev/ttyUSB0"), .problem = QStringLiteral("unplugged")};
    status.sensor = {.source = QStringLiteral("MQTT 127.0.0.1:1883"), .open = true};
    header.showStatus(status);
    EXPECT_LE(header.minimumSizeHint().width(), 1024) << "with all labels beside the target";
}

// REQ-ENDSWITCH-65: The header shows which axis is at a pressed end switch. Under the pointer the label of an axis
// shows each of its switches, also one that cannot be read.
TEST(HeaderBar, ShowsTheEndSwitchesOfAnAxis)
{
    using end_switches::SwitchState;
    RequestDesk desk;
    ValueLabel notice({}, {}, {});
    auto* const authority = new AuthorityButton(desk, notice);
    HeaderBar header(*authority);
    StationStatus status;
    status.azimuth.age = std::chrono::milliseconds(20);
    status.elevation.age = std::chrono::milliseconds(20);
    status.endSwitches = {
        {.which = {Axis::Azimuth, true}, .input = QStringLiteral("mqtt:roof/high"), .state = SwitchState::Free},
        {.which = {Axis::Elevation, false}, .input = QStringLiteral("mqtt:roof/low"), .state = SwitchState::Free}};
    header.showStatus(status);
    EXPECT_EQ(shown(header, "Azimuth drive"), QStringLiteral("AZ"));
    EXPECT_EQ(shown(header, "Elevation drive"), QStringLiteral("EL"));
    status.endSwitches[0].state = SwitchState::Unread;
    status.endSwitches[0].problem = QStringLiteral("no message for 5 s");
    status.endSwitches[1].state = SwitchState::Pressed;
    header.showStatus(status);
    EXPECT_EQ(shown(header, "Azimuth drive"), QStringLiteral("AZ")) << "the alarm tells of a switch that is not read";
    EXPECT_EQ(shown(header, "Elevation drive"), QStringLiteral("EL switch"));
    EXPECT_THAT(findNamed<ValueLabel>(header, "Azimuth drive")->toolTip().toStdString(),
                testing::HasSubstr("AZ upper end: not read (mqtt:roof/high). no message for 5 s"));
    EXPECT_THAT(findNamed<ValueLabel>(header, "Elevation drive")->toolTip().toStdString(),
                testing::HasSubstr("EL lower end: pressed (mqtt:roof/low)"));
}

// Story: the header showed "Park at … because of the wind, by wind".
// REQ-WIND-53: The header names the wind once as the reason of a motion.
TEST(HeaderBar, NamesTheWindOnce)
{
    RequestDesk desk;
    ValueLabel notice({}, {}, {});
    auto* const authority = new AuthorityButton(desk, notice);
    HeaderBar header(*authority);
    StationStatus status;
    status.state = StationState::Slew;
    status.targetText = QStringLiteral("park at 0.0° 90.0° because of the wind");
    status.commander = {.kind = SourceKind::Operator, .name = QStringLiteral("wind")};
    header.showStatus(status);
    EXPECT_EQ(shown(header, "Target and its source"), QStringLiteral("Park at 0.0° 90.0° because of the wind"));
}

// REQ-GS232-61
TEST(HeaderBar, ShowsTheMotorStartsUnderThePointer)
{
    RequestDesk desk;
    ValueLabel notice({}, {}, {});
    auto* const authority = new AuthorityButton(desk, notice);
    HeaderBar header(*authority);
    StationStatus status;
    status.azimuth.stateText = QStringLiteral("at travel limit 450.0°");
    header.showStatus(status);
    EXPECT_EQ(findNamed<ValueLabel>(header, "Azimuth drive")->toolTip(), status.azimuth.stateText);
    status.azimuth.starts = MotorStarts{.lastMinute = 7, .total = 132, .coast = 1_deg};
    header.showStatus(status);
    EXPECT_EQ(findNamed<ValueLabel>(header, "Azimuth drive")->toolTip(),
              QStringLiteral("at travel limit 450.0°\n7 motor starts in the last minute, 132 in total\nThe axis "
                             "coasts 1.00° beyond its target"));
}

// REQ-ROTCTLDMOUNT-70
TEST(HeaderBar, ShowsTheStepOfAnAxisUnderThePointer)
{
    RequestDesk desk;
    ValueLabel notice({}, {}, {});
    auto* const authority = new AuthorityButton(desk, notice);
    HeaderBar header(*authority);
    StationStatus status;
    status.capabilities.axes[0]->step = Angle::fromTurns(1.0 / 866.0);
    header.showStatus(status);
    EXPECT_EQ(findNamed<ValueLabel>(header, "Azimuth drive")->toolTip(),
              QStringLiteral("The axis stands only at steps of 0.416°"));
    EXPECT_EQ(findNamed<ValueLabel>(header, "Elevation drive")->toolTip(), QString());
}

QImage pictureOf(const MarkerData& data)
{
    SkyMarkers markers;
    markers.resize(200, 200);
    QPixmap ground(200, 200);
    ground.fill(currentTheme().plotGround);
    markers.setGround(ground, {.zenith = {100.0, 100.0}, .radius = 90.0});
    markers.setMarkers(data, UtcTime());
    QImage image(200, 200, QImage::Format_RGB32);
    image.fill(currentTheme().plotGround);
    QPainter painter(&image);
    markers.paint(painter);
    return image;
}

TEST(SkyMarkers, TheSensorHasATriangleOfItsOwnColour)
{
    MarkerData data;
    EXPECT_EQ(pictureOf(data).pixelColor(100, 100), currentTheme().plotGround);
    data.sensor = SkyPointing{.azimuth = 0_deg, .elevation = 90_deg};
    const QImage picture = pictureOf(data);
    int coloured = 0;
    for (int x = 80; x < 120; ++x) {
        for (int y = 80; y < 120; ++y) {
            coloured += picture.pixelColor(x, y) == currentTheme().sensor ? 1 : 0;
        }
    }
    EXPECT_GT(coloured, 20);
}

}  // namespace
}  // namespace boresight::ui
