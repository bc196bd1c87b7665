// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonObject>
#include <QString>

// What a station answers to `status`, as an object with these keys:
//   station, state      text
//   actual              {azimuth, elevation} in degrees, or null: unknown
// rotctld reports no more: target, control and alarms are in the window and in the log of the station.
namespace boresight::ctl {

// One line for each, for a person.
[[nodiscard]] QString reportText(const QJsonObject& report);

}  // namespace boresight::ctl
