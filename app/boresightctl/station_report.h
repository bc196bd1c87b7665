// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonObject>
#include <QString>

// What a station answers to `status`, as an object with these keys:
//   station, state      text
//   actual              {azimuth, elevation} in degrees, or null: unknown
// and of a station of this computer by its local socket:
//   reason, motion      text: of the state, and what the mount carries out. May be empty
//   wind                {speed in m/s or null, age in s, silent, obstacle, overriddenUntil: UTC or null}.
//                       Missing: no wind is read
//   transmit            what the station reports of its transmit output. Missing: it has none
// Control and alarms are in the window and in the log of the station.
namespace boresight::ctl {

// One line for each, for a person.
[[nodiscard]] QString reportText(const QJsonObject& report);

}  // namespace boresight::ctl
