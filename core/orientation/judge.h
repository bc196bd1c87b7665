// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geomagnetism/declination.h"
#include "core/orientation/orientation.h"

#include <cstdint>
#include <optional>

// What of the sensor's values may be believed: are they young enough, is the sensor alive, can an antenna have moved
// like that, has the sensor been restarted? It also counts the turns itself, from the headings: the sensor's own count
// begins again after each of its resets. Pure; times are those of arrival.
namespace boresight::orientation {

struct JudgeSettings
{
    Seconds lost{5.0};  // without a value for so long there is no sensor any more
    // The fastest that the antenna turns: what is faster is an outlier, unless it stays so.
    AngularRate azimuthSpeed = AngularRate::fromDegrees(6.0);
    AngularRate elevationSpeed = AngularRate::fromDegrees(6.0);
    Angle declinationInSensor = geomagnetism::kDeclinationInFirmware;  // all that a dead sensor's heading is

    bool operator==(const JudgeSettings&) const = default;
};

enum class Presence
{
    Awaited,  // nothing has come yet, and there was time for it
    Present,
    Late,  // two or three sentences are missing
    Lost
};

enum class ValueFate
{
    Used,
    Outlier,  // a jump that no antenna makes; believed when two more agree
    Dead      // the mark of a sensor chip that does not answer its board: all zero
};

class Judge
{
public:
    explicit Judge(const JudgeSettings& settings = {}) : m_settings(settings) {}
    // From the next value on. It judges a stream of values and knows no profile.
    void setSettings(const JudgeSettings& settings) { m_settings = settings; }
    [[nodiscard]] const JudgeSettings& settings() const { return m_settings; }

    ValueFate take(const Orientation& value);
    // Another source, or the same one opened again: what was known is of another time.
    void forget();

    [[nodiscard]] Presence presence(SteadyTime now) const;
    [[nodiscard]] std::optional<Orientation> last() const { return m_last; }  // of those used, whatever its age
    // It says nothing but zeros: then nothing is used, and presence() tells of the last good one.
    [[nodiscard]] bool dead() const { return m_dead; }
    // Since when the values are the same to the last digit; a living sensor in the wind is never so still.
    [[nodiscard]] std::optional<SteadyTime> frozenSince() const;

    // Whole passages of the heading through its zero since the first value, positive where the heading grows: with a
    // sensor that counts against the compass the mount then turns the other way.
    [[nodiscard]] std::int64_t turns() const { return m_turns; }
    // The heading used last with those turns, as the sensor counts.
    [[nodiscard]] Angle course() const;
    // How often the heading could not be followed from one value to the next: a loss, a restart, a jump that was
    // believed. Between two moments of one count `course` tells how far the antenna turned.
    [[nodiscard]] std::uint64_t breaks() const { return m_breaks; }
    [[nodiscard]] std::uint64_t outliers() const { return m_outliers; }
    [[nodiscard]] std::uint64_t restarts() const { return m_restarts; }

private:
    [[nodiscard]] bool follows(const Orientation& before, const Orientation& value) const;
    [[nodiscard]] bool isBelieved(const Orientation& value);
    [[nodiscard]] bool isRestart(const Orientation& value) const;
    void use(const Orientation& value);

    JudgeSettings m_settings;
    std::optional<Orientation> m_last;
    std::optional<Orientation> m_doubted;  // the newest of those that jumped
    int m_agreeing = 0;                    // of those, one after the other
    std::optional<SteadyTime> m_sameSince;
    bool m_dead = false;
    std::int64_t m_turns = 0;
    std::uint64_t m_breaks = 0;
    std::uint64_t m_outliers = 0;
    std::uint64_t m_restarts = 0;
};

// Heading the firmware's own declination and everything else zero: failed readings of the chip come back as zeros.
[[nodiscard]] bool isDeadMark(const Orientation& value,
                              Angle declinationInSensor = geomagnetism::kDeclinationInFirmware);

}  // namespace boresight::orientation
