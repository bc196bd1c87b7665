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

void PassTally::add(Angle error, Seconds during, Angle beamWidth)
{
    const double loss = beamLoss(error, beamWidth);
    m_record.tracked += during;
    m_record.within1dB += loss <= 1.0 ? during : Seconds(0.0);
    m_record.within3dB += loss <= 3.0 ? during : Seconds(0.0);
    m_record.peakError = std::max(m_record.peakError, error);
    m_squares += error.degrees() * error.degrees() * during.count();
}

PassRecord PassTally::record() const
{
    PassRecord record = m_record;
    const double seconds = record.tracked.count();
    record.rmsError = Angle::fromDegrees(seconds > 0.0 ? std::sqrt(m_squares / seconds) : 0.0);
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
