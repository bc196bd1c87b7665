// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gs232_mount/offset_watch.h"

#include "core/alarms/catalogue.h"
#include "core/base/text.h"

namespace boresight::gs232 {

void OffsetWatch::compare(const std::optional<esp32::Offsets>& reported)
{
    const std::string& text = m_profile->rotator.sensorOffsets;
    const auto saved = esp32::parseOffsets(text);
    if (!saved) {  // nothing is saved: the profile accepts no other text
        m_alarms.clear(alarmEntry("rotator.offsets"));
    } else if (reported && !esp32::areAlike(*saved, *reported)) {
        m_alarms.raise(alarmEntry("rotator.offsets"));
    } else if (reported) {
        m_alarms.clear(alarmEntry("rotator.offsets"));
    }
}

}  // namespace boresight::gs232
