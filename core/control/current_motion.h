// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "core/units/sky.h"

#include <QString>

#include <cstdint>
#include <optional>

// The present motion of the mount: its kind, its source, and its description for the log and the screen. Decides
// nothing. Motion has the set-points. Pure, one thread.
namespace boresight {

enum class Activity
{
    None,
    Holding,
    Pointing,
    Placing,  // like Pointing, but to a place of the mount: home, or the wrap with the least cable wound
    Parking,
    Streaming,
    Jogging,
    Running,
    Trying,  // a tuning run with its own rates
    Proving
};

class CurrentMotion
{
public:
    // True when this only continues the present motion: the next point of a stream, or the next moment of a jog.
    [[nodiscard]] bool continues(Activity activity, const Source& source) const;
    void begin(Activity activity, const Source& source, const QString& text);
    // `left` is None or Holding. The source that asked last stays known.
    void end(Activity left);
    // A source asked the mount to hold. Known until the next motion begins.
    void setHeldBy(const Source& source) { m_heldBy = source; }
    [[nodiscard]] const std::optional<Source>& heldBy() const { return m_heldBy; }
    // The source of the stream is gone. Its last point becomes a place to go to.
    void settleStream() { m_activity = Activity::Pointing; }

    [[nodiscard]] Activity activity() const { return m_activity; }
    [[nodiscard]] bool is(Activity activity) const { return m_activity == activity; }
    [[nodiscard]] bool moves() const { return !is(Activity::None) && !is(Activity::Holding); }
    [[nodiscard]] bool goesToAPlace() const
    {
        return is(Activity::Pointing) || is(Activity::Placing) || is(Activity::Parking);
    }
    [[nodiscard]] bool runsFreely() const
    {
        return is(Activity::Jogging) || is(Activity::Running) || is(Activity::Trying);
    }
    [[nodiscard]] bool isFor(const Source& source) const { return m_commander == source; }
    [[nodiscard]] bool isForClient(std::uint64_t clientId) const;
    [[nodiscard]] const Source& commander() const { return m_commander; }
    [[nodiscard]] const QString& text() const { return m_text; }

    // The motion id. It changes each time that the mount is sent somewhere or control is given away. A jog leaves it.
    [[nodiscard]] std::uint64_t motionId() const { return m_motionId; }
    void setMotionId(std::uint64_t motionId) { m_motionId = motionId; }

    // The place of the axes for the last point of a stream.
    void aim(const AxisPosition& point) { m_point = point; }
    [[nodiscard]] const std::optional<AxisPosition>& point() const { return m_point; }

    // The last point of a stream as it was asked for. It stays after the source of the stream is gone.
    void ask(const SkyPointing& direction) { m_asked = direction; }
    [[nodiscard]] const std::optional<SkyPointing>& asked() const { return m_asked; }

    // The direction that was asked for is not permitted. The mount goes to the nearest permitted place.
    void limit(const QString& reason, const SkyPointing& asked);
    [[nodiscard]] const QString& limitedReason() const
    {
        return m_limitedReason;
    }  // empty: the mount goes to the target itself
    [[nodiscard]] const std::optional<SkyPointing>& limitedDirection() const { return m_limitedDirection; }

    // The way to come is planned and keeps to the room of the cable. Valid until the next point of the stream.
    void setPlanned() { m_isPlanned = true; }
    // The present motion is all that is known of the way to come, so it shows whether the cable will end.
    [[nodiscard]] bool needsForecast() const { return is(Activity::Streaming) && !m_isPlanned; }

    // The operator chose to wait at the end of the cable. The choice ends with the motion.
    void keepWrap() { m_keepsWrap = true; }
    [[nodiscard]] bool keepsWrap() const { return m_keepsWrap; }

private:
    void forgetDetails();

    Activity m_activity = Activity::None;
    Source m_commander;
    std::optional<Source> m_heldBy;
    std::uint64_t m_motionId = 0;
    QString m_text;
    std::optional<AxisPosition> m_point;
    std::optional<SkyPointing> m_asked;
    QString m_limitedReason;
    std::optional<SkyPointing> m_limitedDirection;
    bool m_isPlanned = false;
    bool m_keepsWrap = false;
};

}  // namespace boresight
