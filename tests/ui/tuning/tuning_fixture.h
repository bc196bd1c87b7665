// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/ui/drives/drives_fixture.h"
#include "ui/tuning/tuning_panel.h"

#include <QDoubleSpinBox>
#include <QToolButton>

#include <cmath>

// The tuning panel in the window, with runs and gains as a station would report them.
namespace boresight::ui {

inline constexpr double kFoundDamping = 10053.1;
inline constexpr double kOtherDamping = 12000.0;

inline DriveGains sampleGains(double damping = kFoundDamping)
{
    DriveGains gains{.read = true, .onTrial = damping != kFoundDamping, .text = QStringLiteral("the gains were read")};
    const double values[] = {201062.0, 1608500.0, damping, 60.0, 18.0, 400.0};
    for (const double value : values) {
        gains.lines.push_back({.key = QStringLiteral("servo.sample"),
                               .unit = QStringLiteral("Nm"),
                               .value = value,
                               .first = value,
                               .stored = value,
                               .least = value / 4.0,
                               .most = value * 4.0,
                               .bounds = QStringLiteral("A quarter to four times the stored value.")});
    }
    gains.lines[2].first = gains.lines[2].stored = kFoundDamping;
    gains.lines[5].needsOff = true;
    return gains;
}

// With the gains first found, or with the other damping.
inline TuningResult sampleResult(TuningRun run, bool asFound, double error = 0.01)
{
    TuningResult result{.run = run,
                        .when = UtcTime(std::chrono::seconds(asFound ? 1000 : 2000)),
                        .asFound = asFound,
                        .good = true,
                        .verdict = {QStringLiteral("Overshoot %1 %: as measured.").arg(100.0 * error)}};
    for (const GainLine& line : sampleGains(asFound ? kFoundDamping : kOtherDamping).lines) {
        result.gains.push_back(line.value);
    }
    for (int i = 0; i < 200; ++i) {
        result.samples.push_back({.time = Seconds(0.02 * i),
                                  .actual = Angle::fromDegrees(error * std::sin(0.1 * i)),
                                  .torque = 5.0 * std::cos(0.1 * i)});
    }
    if (run == TuningRun::Step) {
        result.step = response::StepFigures{.size = 2_deg,
                                            .overshoot = error,
                                            .settling = Seconds(0.1),
                                            .error = {.rms = 0.005_deg, .peak = Angle::fromDegrees(error)},
                                            .torque = response::TorqueFigures{.rms = 3.0, .peak = 12.0}};
    } else if (run == TuningRun::Ramp) {
        result.ramp = response::RampFigures{.rate = 0.5_deg_s};
    } else {
        result.sweep = {{.hertz = 0.3, .amplitude = 0.25_deg, .gain = 1.0, .phase = -2_deg}};
    }
    return result;
}

class TuningFixture : public DrivesTest
{
protected:
    TuningFixture()
    {
        status = samples::idle();
        for (auto& plans : tuning.plans) {
            plans.fill({.text = QStringLiteral("Moves the azimuth by 2.00° from 30.0° and back, in 8 s.")});
        }
        status.drives->azimuth.gains = sampleGains();
    }

    // Shows the contents of `status` and `tuning`.
    void show()
    {
        status.tuning = std::make_shared<const TuningStatus>(tuning);
        give(samples::update(status));
    }
    void show(const std::vector<TuningResult>& results)
    {
        tuning.results = results;
        show();
    }
    [[nodiscard]] DriveGains& gains() { return status.drives->azimuth.gains; }

    [[nodiscard]] std::vector<request::StartTuning> started() const
    {
        std::vector<request::StartTuning> found;
        for (const auto& one : asked<TuningRequest>()) {
            if (const auto* const start = std::get_if<request::StartTuning>(&one)) {
                found.push_back(*start);
            }
        }
        return found;
    }

    QToolButton& choice(const char* words)
    {
        for (QToolButton* const button : window.findChild<TuningPanel*>()->findChildren<QToolButton*>()) {
            if (button->isVisible() && button->text() == QString::fromUtf8(words)) {
                return *button;
            }
        }
        throw std::runtime_error(std::string("no choice is called ") + words);
    }
    void press(const char* words) { QTest::mouseClick(&choice(words), Qt::LeftButton); }
    std::string first() { return text("First tuning").toStdString(); }
    std::string state() { return text("The run or its result").toStdString(); }

    StationStatus status;
    TuningStatus tuning;
};

}  // namespace boresight::ui
