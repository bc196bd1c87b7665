// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <cmath>
#include <optional>
#include <vector>

// The position-control gains of a drive that Boresight can tune. Plain values. Part of a StationStatus if the mount has
// such drives.
namespace boresight {

enum class Gain
{
    Stiffness,
    Integral,
    Damping,
    IntegralLimit,
    InertiaFeedforward,
    EncoderFilter,
    Count
};

// Compares with a tolerance, because the drive stores single precision and prints six digits.
[[nodiscard]] inline bool isSameGain(double one, double other)
{
    return std::abs(other - one) <= 1e-6 + 1e-5 * std::abs(one);
}

// Two gains that were not read are the same.
[[nodiscard]] inline bool isSameGain(const std::optional<double>& one, const std::optional<double>& other)
{
    return one && other ? isSameGain(*one, *other) : one == other;
}

struct GainLine
{
    QString key;                     // as the drive calls it
    QString unit;                    // may be empty
    std::optional<double> value{};   // in force; empty: not read
    std::optional<double> first{};   // as first read; PutGainsBack restores it
    std::optional<double> stored{};  // in the memory of the drive, in force after a power-up
    double least = 0.0;              // the smallest value that may be written
    double most = 0.0;               // the largest value that may be written
    QString bounds;                  // the reason for these bounds
    bool needsOff = false;           // written only while the drives are off

    bool operator==(const GainLine&) const = default;
};

struct DriveGains
{
    std::vector<GainLine> lines;  // in the order of Gain; empty: this drive has none that can be tuned
    bool read = false;
    bool busy = false;     // they are being read or written
    bool onTrial = false;  // changed gains are in force, neither stored nor put back
    QString text;          // the running action, or the result of the last one
    bool failed = false;   // the last reading or writing has failed

    bool operator==(const DriveGains&) const = default;
};

}  // namespace boresight
