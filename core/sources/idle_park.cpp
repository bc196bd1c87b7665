// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sources/idle_park.h"

#include "core/base/text.h"
#include "core/control/status_report.h"

namespace boresight::sources {
namespace {

using Minutes = std::chrono::duration<double, std::ratio<60>>;

const Source& idleSource()
{
    static const Source source{.kind = SourceKind::Station, .name = QStringLiteral("station")};
    return source;
}

}  // namespace

void IdlePark::step(SteadyTime now)
{
    const ControlParts view = helm().view();
    const Minutes after(view.profile.parkAfter);
    if (after <= Minutes(0.0) || !isIdle()) {
        m_since = now;
        m_isDone = false;
        return;
    }
    if (view.asked > m_since) {
        m_since = view.asked;
        m_isDone = false;
    }
    if (!m_isDone && now - m_since >= after) {
        m_isDone = true;
        park();
    }
}

// The mount may be idle while it holds the last target of a client. It is not idle while it tracks a target by itself,
// because that target may move again at any time.
bool IdlePark::isIdle() const
{
    const ControlParts view = helm().view();
    const bool tracks = view.current.is(Activity::Streaming) && view.current.commander().kind != SourceKind::Client;
    return StatusReport(view).state() == StationState::Hold && !tracks && !Gates(view).isAtPark();
}

// Keeps the motion id. So the schedule, which waits between two passes, does not take this for a foreign motion.
void IdlePark::park()
{
    const std::uint64_t motionId = helm().current().motionId();
    const ControlParts view = helm().view();
    const AxisPosition place = Gates(view).park();
    const QString what = Text::tr("park at %1 after %2 min without a command")
                             .arg(helm().directionText(place), QString::number(view.profile.parkAfter, 'g', 4));
    const Result<> parked = helm().goTo(place, Activity::Parking, idleSource(), what);
    if (parked) {
        helm().keepMotionId(motionId);
    } else {
        helm().note(Severity::Warning, Text::tr("does not park when idle: %1").arg(parked.error().text));
    }
}

}  // namespace boresight::sources
