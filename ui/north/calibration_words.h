// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/calibration_status.h"
#include "core/messages/station_status.h"
#include "ui/link/drive_check_words.h"

#include <QString>
#include <QStringList>

#include <string>
#include <vector>

// The reports of the calibration desk in words. Sentences of the core are not changed.
namespace boresight::ui {

// Never null: without a calibration desk the result is empty.
[[nodiscard]] const CalibrationStatus& calibrationOf(const StationStatus& status);
[[nodiscard]] const BodyNow* bodyNow(const StationStatus& status, ephemeris::Body body);  // null if unknown

[[nodiscard]] QString offsetText(const calibration::Estimate& estimate);    // "+37.40° ± 1.20°", at most 180°
[[nodiscard]] QString estimateText(const calibration::Estimate& estimate);  // "37.41° ± 1.80°"
[[nodiscard]] QString termName(const std::string& key);                     // "azimuth offset"
[[nodiscard]] QString bodyName(ephemeris::Body body);                       // "Sun"
[[nodiscard]] QString placeText(const BodyNow& body);                       // "az 143.2°  el 32.1°, sets 17:05Z"
// The north from the points is more accurate than that of the sensor. Then Apply keeps it and adjusts the sensor to it.
[[nodiscard]] bool keepsNorth(const CalibrationProposal& proposal);
// Every term that changes, before and after: "azimuth offset 0.00° → 37.41°, …".
[[nodiscard]] QString changeText(const CalibrationProposal& proposal);
// Doubts first, then warnings.
[[nodiscard]] QStringList warningsOf(const CalibrationProposal& proposal);
[[nodiscard]] Sentence proposalSentence(const CalibrationStatus& calibration);
[[nodiscard]] QString swingText(const SwingOutcome& swing);  // several lines: north, curve, tilt, verdict
// "143.2° ± 1.6°", without the sigma before a swing, and without a value while it is unknown.
[[nodiscard]] QString trueAzimuthText(const SensorStatus& sensor);
// The proposal is the fit of the points: not typed, not read from a file, and not found by the sensor.
[[nodiscard]] bool proposesFit(const CalibrationStatus& calibration);
[[nodiscard]] QString fitText(const CalibrationStatus& calibration);
[[nodiscard]] double onSky(const PointResidual& residual);  // degrees

// The warning about eyes and feed. It is shown while the Sun is chosen, wherever the beam is.
[[nodiscard]] QString sunWarning();

}  // namespace boresight::ui
