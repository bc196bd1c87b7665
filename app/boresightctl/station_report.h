// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonObject>
#include <QString>

// The answer of a station to `status`, as an object with these keys:
//   station, state      text
//   actual              {azimuth, elevation} in degrees, or null: unknown
// A station on this computer also sends these keys through its local socket:
//   reason, motion      text: the reason of the state, and the present motion. May be empty
//   errorBudget         {degrees: the sum, whole: no part is unknown, loss in dB or null beyond the main lobe, text,
//                       parts: of each {part: "servo", "way", "stream", "clock", "elements", "calibration" or "wind",
//                       degrees or null, from}}. Missing: no direction is aimed at, or the position is old
//   wind                {speed in m/s or null, age in s, silent, obstacle, overriddenUntil: UTC or null}.
//                       Missing: no wind is read
//   brake               {state: "set", "opens", "open", "closes" or "failed", output, problem}. Missing: there is none
//   endSwitches         of each: {end: "azimuth lower", state: "free", "pressed" or "unread", input, problem}.
//                       Missing: there are none
//   clockSetBy          seconds by which the clock was set while the station uses the old time. Missing: it does not
//   transmit            the state of the transmit output. Missing: the station has none
//   rises, sets         UTC: the next of the tracked target. Missing: nothing is tracked, or it is unknown
//   schedule            "armed". Missing: it is not
//   alarms              the active alarms, in sentences. Missing: there are none
// Control is in the window and in the log of the station.
namespace boresight::ctl {

// One line for each key, for a person.
[[nodiscard]] QString reportText(const QJsonObject& report);

}  // namespace boresight::ctl
