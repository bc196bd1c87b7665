// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/control/current_motion.h"

namespace boresight {

bool CurrentMotion::continues(Activity activity, const Source& source) const
{
    const bool repeated =
        activity == Activity::Streaming || activity == Activity::Jogging || activity == Activity::Trying;
    return repeated && is(activity) && isFor(source);
}

void CurrentMotion::begin(Activity activity, const Source& source, const QString& text)
{
    const bool goesOn = continues(activity, source);
    if (!goesOn && activity != Activity::Jogging) {
        ++m_motionId;
    }
    m_keepsWrap = m_keepsWrap && goesOn;
    m_activity = activity;
    m_commander = source;
    m_text = text;
    forgetDetails();
}

void CurrentMotion::end(Activity left)
{
    m_activity = left;
    m_keepsWrap = false;
    m_text.clear();
    forgetDetails();
}

void CurrentMotion::forgetDetails()
{
    m_point.reset();
    m_asked.reset();
    m_limitedReason.clear();
    m_limitedDirection.reset();
    m_isPlanned = false;
    m_heldBy.reset();
}

bool CurrentMotion::isForClient(std::uint64_t clientId) const
{
    return m_commander.kind == SourceKind::Client && m_commander.clientId == clientId;
}

void CurrentMotion::limit(const QString& reason, const SkyPointing& asked)
{
    m_limitedReason = reason;
    m_limitedDirection = asked;
}

}  // namespace boresight
