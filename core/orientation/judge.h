// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geomagnetism/declination.h"
#include "core/orientation/orientation.h"

#include <cstdint>
#include <optional>

// Decides which values of the sensor are believed: whether they are young, whether the sensor is alive, whether an
// antenna can move like that, and whether the sensor was restarted. It also counts the turns from the headings, because
// the sensor's own count begins again after each of its resets. Pure; times are times of arrival.
namespace boresight::orientation {

struct JudgeSettings
{
    Seconds lost{5.0};  // after this time without a value the sensor counts as lost
    // The highest speed of the antenna. A faster change is an outlier, unless it is confirmed.
    AngularRate azimuthSpeed = AngularRate::fromDegrees(6.0);
    AngularRate elevationSpeed = AngularRate::fromDegrees(6.0);
    Angle declinationInSensor = geomagnetism::kDeclinationInFirmware;  // the heading that a dead sensor reports

    bool operator==(const JudgeSettings&) const = default;
};

enum class Presence
{
    Awaited,  // no value has come yet, although there was time for it
    Present,
    Late,  // two or three sentences are missing
    Lost
};

enum class ValueFate
{
    Used,
    Outlier,  // a jump that no antenna can make; believed when two more values agree
    Dead      // the sensor chip does not answer its board: all zero
};

class Judge
{
public:
    explicit Judge(const JudgeSettings& settings = {}) : m_settings(settings) {}
    // Applies from the next value on. The judge knows no profile.
    void setSettings(const JudgeSettings& settings) { m_settings = settings; }
    [[nodiscard]] const JudgeSettings& settings() const { return m_settings; }

    ValueFate take(const Orientation& value);
    // For another source, or the same source after it was opened again. Earlier values are forgotten.
    void forget();

    [[nodiscard]] Presence presence(SteadyTime now) const;
    // The last value that was used, of any age.
    [[nodiscard]] std::optional<Orientation> last() const { return m_last; }
    // The sensor sends only zeros. Then its values are not used, and presence() is that of the last good value.
    [[nodiscard]] bool dead() const { return m_dead; }
    // Since when all values are exactly equal. A working sensor in the wind is never so still.
    [[nodiscard]] std::optional<SteadyTime> frozenSince() const;

    // Net number of times that the heading passed its zero since the first value; positive where the heading grows.
    // With a counter-clockwise sensor the mount turns the other way.
    [[nodiscard]] std::int64_t turns() const { return m_turns; }
    // The last used heading with these turns, in the sense of the sensor.
    [[nodiscard]] Angle course() const;
    // How often the heading could not be followed from one value to the next: after a loss, a restart or a confirmed
    // jump. Between two moments with the same number, `course` shows how far the antenna turned.
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
    std::optional<Orientation> m_doubted;  // the newest value after a jump
    int m_agreeing = 0;                    // how many of them agreed in a row
    std::optional<SteadyTime> m_sameSince;
    bool m_dead = false;
    std::int64_t m_turns = 0;
    std::uint64_t m_breaks = 0;
    std::uint64_t m_outliers = 0;
    std::uint64_t m_restarts = 0;
};

// The heading is exactly the firmware's own declination and everything else is zero: failed reads of the chip return
// zeros.
[[nodiscard]] bool isDeadMark(const Orientation& value,
                              Angle declinationInSensor = geomagnetism::kDeclinationInFirmware);

}  // namespace boresight::orientation
