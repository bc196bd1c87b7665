// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/schedule/night_report.h"

#include "core/schedule/night_plan.h"

#include <algorithm>
#include <cmath>

namespace boresight::schedule {

double beamLoss(Angle distance, Angle beamWidth)
{
    const double widths = distance.degrees() / beamWidth.degrees();
    return 40.0 * std::log10(2.0) * widths * widths;
}

int NightReport::done() const
{
    return static_cast<int>(
        std::ranges::count_if(passes, [](const PassRecord& pass) { return pass.end == PassEnd::Set; }));
}

int partsOf(const NightReport& report, const PassRecord& pass)
{
    return static_cast<int>(std::ranges::count_if(report.passes, [&](const PassRecord& one) {
        return one.number == pass.number && std::chrono::abs(one.aos - pass.aos) < kSamePass;
    }));
}

// After the beam was on target, everything until the end of the pass counts.
bool PassTally::settles(const Look& look)
{
    if (m_onTarget < kSettled) {
        m_onTarget = look.isOnTarget ? m_onTarget + look.during : Seconds(0.0);
        return false;
    }
    return true;
}

void PassTally::add(const Look& look, Angle beamWidth)
{
    const double loss = beamLoss(look.error, beamWidth);
    m_record.tracked += look.during;
    m_record.within1dB += loss <= 1.0 ? look.during : Seconds(0.0);
    m_record.within3dB += loss <= 3.0 ? look.during : Seconds(0.0);
    if (look.during > Seconds(0.0) && settles(look)) {
        m_record.peakError = std::max(m_record.peakError.value_or(Angle{}), look.error);
        m_judged += look.during;
        m_squares += look.error.degrees() * look.error.degrees() * look.during.count();
    }
}

PassRecord PassTally::record() const
{
    PassRecord record = m_record;
    if (m_judged > Seconds(0.0)) {
        record.rmsError = Angle::fromDegrees(std::sqrt(m_squares / m_judged.count()));
    }
    return record;
}

PassRecord PassTally::ended(PassEnd end, const QString& why) const
{
    PassRecord record = this->record();
    record.end = end;
    record.why = why;
    return record;
}

}  // namespace boresight::schedule
