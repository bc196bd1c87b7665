// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/calibration_status.h"
#include "core/messages/station_status.h"
#include "ui/link/survey_words.h"

#include <QString>

#include <string>
#include <vector>

// What the calibration desk tells, in words. Whatever is said of the core's own sentences stays as it is.
namespace boresight::ui {

// Never null, whatever the status holds: without a calibration desk there is nothing to tell.
[[nodiscard]] const CalibrationStatus& calibrationOf(const StationStatus& status);
[[nodiscard]] const BodyNow* bodyNow(const StationStatus& status, ephemeris::Body body);  // null: not known

[[nodiscard]] QString offsetText(const calibration::Estimate& estimate);    // "+37.40° ± 1.20°", the shorter way
[[nodiscard]] QString estimateText(const calibration::Estimate& estimate);  // "37.41° ± 1.80°"
[[nodiscard]] QString termName(const std::string& key);                     // "azimuth offset"
[[nodiscard]] QString bodyName(ephemeris::Body body);                       // "Sun"
[[nodiscard]] QString placeText(const BodyNow& body);                       // "az 143.2°  el 32.1°, sets 17:05Z"
// Points know north better: Apply turns the sensor to it.
[[nodiscard]] bool keepsNorth(const CalibrationProposal& proposal);
// Every term that changes, before and after: "azimuth offset 0.00° → 37.41°, …".
[[nodiscard]] QString changeText(const CalibrationProposal& proposal);
[[nodiscard]] Sentence proposalSentence(const CalibrationStatus& calibration);
[[nodiscard]] QString swingText(const SwingOutcome& swing);  // several lines: north, curve, tilt, verdict
// "143.2° ± 1.6°"; without the sigma before a swing, no value while it is not known.
[[nodiscard]] QString trueAzimuthText(const SensorStatus& sensor);
// The proposal is the fit of the points. It was not typed, read from a file or found by the sensor.
[[nodiscard]] bool proposesFit(const CalibrationStatus& calibration);
[[nodiscard]] QString fitText(const CalibrationStatus& calibration);
[[nodiscard]] double onSky(const PointResidual& residual);  // degrees

// Of the eyes and the feed; stands there as long as the Sun is meant, whether the beam is there or not.
[[nodiscard]] QString sunWarning();

}  // namespace boresight::ui
