// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonObject>
#include <QString>

// What a station answers to `status`, as an object with these keys:
//   station, state, reason, control, target_text   text
//   actual, target      {azimuth, elevation} in degrees, or null: unknown
//   stop_latched, simulated
//   alarms              a list of {severity, what, action, remedy}
// A key that is missing is not known to the protocol: rotctld gives station, state and actual.
namespace boresight::ctl {

// One line for each, for a person.
[[nodiscard]] QString reportText(const QJsonObject& report);

}  // namespace boresight::ctl
