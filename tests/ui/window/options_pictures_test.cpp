// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/alarms/catalogue.h"
#include "tests/ui/picture_book.h"
#include "tests/ui/sample_alarms.h"
#include "tests/ui/sample_drives.h"
#include "tests/ui/sample_third_axis.h"
#include "tests/ui/tuning/tuning_fixture.h"
#include "ui/drives/box_console_panel.h"
#include "ui/drives/protection_panel.h"
#include "ui/drives/readings_table.h"
#include "ui/jog/jog_panel.h"
#include "ui/tuning/tuning_panel.h"
#include "ui/window/panel_tabs.h"

// Pictures of what only some mounts have, and of the pages that have no key of their own.
namespace boresight::ui {
namespace {

template <class Change>
void changeProfile(StationStatus& status, const Change& change)
{
    profile::Profile profile = *status.profile;
    change(profile);
    status.profile = std::make_shared<const profile::Profile>(profile);
}

StationStatus withThirdAxis()
{
    StationStatus status = samples::cableEnding();
    status.thirdAxis = samples::thirdAxis();
    return status;
}

StationStatus withFaultOfTheThirdAxis()
{
    StationStatus status = withThirdAxis();
    status.thirdAxis->state = ThirdAxisStatus::State::Fault;
    status.thirdAxis->fault = QStringLiteral("over temperature (38)");
    status.thirdAxis->age = std::chrono::milliseconds(2500);
    status.permissions.refuse(Action::JogThirdAxisUp, QStringLiteral("The drive of the third axis has a fault."));
    status.permissions.refuse(Action::JogThirdAxisDown, QStringLiteral("The drive of the third axis has a fault."));
    return status;
}

// A control box on a serial port, in place of drives on a bus.
StationStatus withBox()
{
    StationStatus status = samples::idle();
    status.drives.reset();
    status.line = {.state = MountLine::State::Up,
                   .kind = QStringLiteral("ESP32"),
                   .name = QStringLiteral("esp32:/dev/ttyUSB0"),
                   .condition = QStringLiteral("calibration of the sensor: system 3, gyroscope 3, "
                                               "accelerometer 1, magnetometer 2"),
                   .sensorOffsets =
                       "accelerometer -12 31 -8, magnetometer 140 -75 22, gyroscope 0 -1 2, "
                       "radii 1000 712",
                   .sent = 8'211,
                   .received = 8'209};
    status.console =
        QStringList{QStringLiteral("> CALSTATS"), QStringLiteral("Accel Rad: 1000"), QStringLiteral("Mag Rad: 712"),
                    QStringLiteral("> C2"), QStringLiteral("AZ=112 EL=045")};
    status.capabilities.makesHomeRuns = true;
    return status;
}

StationStatus withOtherOffsets()
{
    StationStatus status = withBox();
    changeProfile(status, [](profile::Profile& profile) {
        profile.rotator.sensorOffsets =
            "accelerometer -10 30 -8, magnetometer 120 -70 20, gyroscope 0 -1 2, radii 1000 "
            "700";
    });
    status.permissions.refuse(Action::TypeLine, QStringLiteral("The mount moves. Stop it first."));
    status.permissions.refuse(Action::MakeHomeRun, QStringLiteral("The mount moves. Stop it first."));
    return status;
}

StationStatus withEndSwitches()
{
    using end_switches::SwitchState;
    StationStatus status = samples::idle();
    status.brake = {.output = QStringLiteral("rts:/dev/ttyUSB0"), .state = brake::BrakeState::Set};
    status.endSwitches = {
        {.which = {Axis::Azimuth, false}, .input = QStringLiteral("moteus:1:aux1.0"), .state = SwitchState::Free},
        {.which = {Axis::Azimuth, true}, .input = QStringLiteral("moteus:1:aux1.1"), .state = SwitchState::Free},
        {.which = {Axis::Elevation, false},
         .input = QStringLiteral("mqtt:roof/low"),
         .state = SwitchState::Pressed,
         .isClosed = true},
        {.which = {Axis::Elevation, true},
         .input = QStringLiteral("mqtt:roof/high"),
         .state = SwitchState::Unread,
         .problem = QStringLiteral("No message for 5 s. Check the switch and the broker.")}};
    return status;
}

// A brake, a transmitter, a sensor, wind, several antennas and end switches: all that a header and a column may show.
StationStatus withEverything()
{
    StationStatus status = samples::tracking(330);
    status.brake = {.output = QStringLiteral("rts:/dev/ttyUSB0"), .state = brake::BrakeState::Released};
    status.transmit = {.output = QStringLiteral("dtr:/dev/ttyUSB0"), .on = true, .within = 2_deg, .error = 0.1_deg};
    status.wind = {.source = QStringLiteral("udp:4541"), .speed = 7.2, .age = Seconds(1.2)};
    status.endSwitches = withEndSwitches().endSwitches;
    status.power = {.total = 61.5,
                    .running = MotionEnergy{.joules = 5400.0, .peak = 118.0, .time = Seconds(95.0), .unknown = {}}};
    status.thirdAxis = withThirdAxis().thirdAxis;
    changeProfile(status, [](profile::Profile& profile) {
        profile.antennas = {{.name = "70 cm", .beamWidth = 20_deg, .across = 2_deg}};
        profile.presets = {{"beacon", {113_deg, 10_deg}}, {"zenith", {0_deg, 90_deg}}};
    });
    return status;
}

StationStatus inAStorm()
{
    StationStatus status = withEverything();
    status.state = StationState::Parked;
    status.stateReason = QStringLiteral("park position reached");
    status.transmit.on = false;
    status.transmit.whyOff = QStringLiteral("The mount is parked.");
    status.wind.speed = 17.0;
    status.wind.obstacle = QStringLiteral("The wind reached 17.0 m/s. The limit is 15.0 m/s.");
    status.alarms = {samples::alarmOf(alarmEntry("wind.parks"))};
    return status;
}

StationStatus onXAndY()
{
    StationStatus status = samples::idle();
    changeProfile(status, [](profile::Profile& profile) {
        profile.pointing.geometry = {.kind = pointing::Geometry::XY, .xAxis = 20_deg};
        profile.azimuth.geometry.travel = {-88_deg, 88_deg};
        profile.elevation.geometry.travel = {-85_deg, 85_deg};
        profile.limits.azimuth = {-88_deg, 88_deg};
        profile.limits.elevation = {-85_deg, 85_deg};
        profile.limits.horizon = {{0_deg, 6_deg}, {140_deg, 22_deg}, {180_deg, 28_deg}, {240_deg, 7_deg}};
        profile.limits.keepOuts = {{"mast", 262_deg, 308_deg, 0_deg, 30_deg}};
    });
    status.azimuth.travel = status.profile->azimuth.geometry.travel;
    status.elevation.travel = status.profile->elevation.geometry.travel;
    samples::place(status, {35_deg, 30_deg}, {35_deg, 30_deg}, {35_deg, 30_deg});
    status.actual = status.commanded = status.target = SkyPointing{68.9_deg, 45.2_deg};
    return status;
}

StationStatus tuned()
{
    StationStatus status = samples::idle();
    TuningStatus tuning;
    for (auto& plans : tuning.plans) {
        plans.fill({.text = QStringLiteral("Moves the azimuth by 2.00° from 30.0° and back, in 8 s.")});
    }
    TuningResult result{.run = TuningRun::Step,
                        .when = status.utc,
                        .asFound = true,
                        .good = true,
                        .verdict = {QStringLiteral("Overshoot 1.2 %: well tuned.")}};
    for (int i = 0; i < 200; ++i) {
        result.samples.push_back({.time = Seconds(0.02 * i),
                                  .actual = Angle::fromDegrees(2.0 - 2.0 * std::exp(-0.05 * i) * std::cos(0.1 * i)),
                                  .torque = 5.0 * std::cos(0.1 * i)});
    }
    result.step = response::StepFigures{.size = 2_deg,
                                        .overshoot = 0.012,
                                        .settling = Seconds(1.1),
                                        .error = {.rms = 0.005_deg, .peak = 0.03_deg},
                                        .torque = response::TorqueFigures{.rms = 3.0, .peak = 12.0}};
    tuning.results = {result};
    status.tuning = std::make_shared<const TuningStatus>(tuning);
    status.drives->azimuth.gains = sampleGains();
    return status;
}

class OptionsPictures : public PictureBook
{
protected:
    template <class Panel>
    void takeOf(const char* scene, const StationStatus& status)
    {
        SCOPED_TRACE(scene);
        show(status, '1');
        auto* const panel = window.findChild<Panel*>();
        window.findChild<PanelTabs*>()->bringUp(*panel);
        for (const ValueLabel* const label : panel->template findChildren<ValueLabel*>()) {
            mustBeWhole << label;
        }
        take(QLatin1String(scene));
    }
};

// REQ-UI-15 (OptionsPictures.*)
TEST_P(OptionsPictures, AreTakenOfEachPartThatSomeMountsHave)
{
    takeOf<JogPanel>("third-axis", withThirdAxis());
    takeOf<JogPanel>("third-axis-fault", withFaultOfTheThirdAxis());
    takeOf<JogPanel>("everything", withEverything());
    takeOf<JogPanel>("storm", inAStorm());
    takeOf<ProtectionPanel>("end-switches", withEndSwitches());
    takeOf<BoxConsolePanel>("box", withBox());
    takeOf<BoxConsolePanel>("box-offsets", withOtherOffsets());
    takeOf<JogPanel>("x-y", onXAndY());
    show(onXAndY(), '3');
    take(QStringLiteral("x-y-limits"));
}

TEST_P(OptionsPictures, AreTakenOfReadingsAndTuning)
{
    takeOf<ReadingsTable>("readings", samples::idle());
    takeOf<TuningPanel>("tuning", tuned());
    QTest::mouseClick(named<ChoiceButton>(TuningPanel::tr("The gains of the drive").toUtf8()), Qt::LeftButton);
    take(QStringLiteral("tuning-gains"));
}

INSTANTIATE_TEST_SUITE_P(All, OptionsPictures, kThemesAndPortuguese, editionName);

}  // namespace
}  // namespace boresight::ui
