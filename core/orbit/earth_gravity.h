// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The Earth model WGS-72. Element sets are made with it, so SGP4 uses it, although sites are on WGS-84. Using WGS-84
// here would cause an error of 0.016° for the ISS. (AIAA 2006-6753, section III.)
namespace boresight::orbit {

inline constexpr double kEarthRadius = 6378.135;  // km
inline constexpr double kJ2 = 0.001082616;
inline constexpr double kJ3 = -0.00000253881;
inline constexpr double kJ4 = -0.00000165597;
// The mean motion of an orbit with one Earth radius, √(398600.8 km³/s² / radius³), per minute.
inline constexpr double kSurfaceMotion = 0.07436691613317342;

}  // namespace boresight::orbit
