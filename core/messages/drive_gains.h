// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <cmath>
#include <optional>
#include <vector>

// The settings by which a drive controls its position, as far as they may be tuned from here. Plain values, part of a
// StationStatus where the mount has such drives.
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

// The drive keeps single precision and prints six digits.
[[nodiscard]] inline bool isSameGain(double one, double other)
{
    return std::abs(other - one) <= 1e-6 + 1e-5 * std::abs(one);
}

// Neither was read: the same.
[[nodiscard]] inline bool isSameGain(const std::optional<double>& one, const std::optional<double>& other)
{
    return one && other ? isSameGain(*one, *other) : one == other;
}

struct GainLine
{
    QString key;                     // as the drive calls it
    QString unit;                    // may be empty
    std::optional<double> value{};   // in force; empty: not read
    std::optional<double> first{};   // as it was found first: what is put back
    std::optional<double> stored{};  // with which the drive comes back after a power-up
    double least = 0.0;              // what may be written
    double most = 0.0;
    QString bounds;         // why no more and no less
    bool needsOff = false;  // written only while the drives are off

    bool operator==(const GainLine&) const = default;
};

struct DriveGains
{
    std::vector<GainLine> lines;  // in the order of Gain; empty: this drive has none that can be tuned
    bool read = false;
    bool busy = false;     // they are being read or written
    bool onTrial = false;  // in force, and neither stored nor put back
    QString text;          // what is done now, or how it ended
    bool failed = false;   // the last reading or writing

    bool operator==(const DriveGains&) const = default;
};

}  // namespace boresight
