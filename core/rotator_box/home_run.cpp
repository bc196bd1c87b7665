// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotator_box/home_run.h"

#include "core/alarms/catalogue.h"
#include "core/base/text.h"

namespace boresight {

Result<> HomeRun::admits(const RotatorTalk& talk, bool answers) const
{
    if (!talk.makesHomeRuns()) {
        return failure(ErrorCode::NotAvailable, Text::tr("this rotator has no command for a home run"));
    }
    if (!answers) {
        return failure(ErrorCode::NoAnswer, Text::tr("The control box does not answer."));
    }
    return isRunning() ? failure(ErrorCode::Refused, Text::tr("The home run is under way.")) : Result<>{};
}

void HomeRun::begin(RotatorTalk& talk, SteadyTime now)
{
    m_run = Run{.begun = now};
    forgetFailure();
    m_alarms.raise(alarmEntry("rotator.home-run"));
    talk.home();
}

void HomeRun::end()
{
    m_run.reset();
    m_alarms.clear(alarmEntry("rotator.home-run"));
}

void HomeRun::forgetFailure()
{
    m_alarms.clear(alarmEntry("rotator.no-home-run"));
}

HomeRun::Outcome HomeRun::step(RotatorTalk& talk, bool moves, SteadyTime now)
{
    if (!m_run) {
        return Outcome::None;
    }
    if (const auto answer = talk.takeHomeAnswer(); answer && *answer) {
        m_run->accepted = now;
    } else if (answer) {
        end();
        m_alarms.raise(alarmEntry("rotator.no-home-run"), {answer->error().text});
        return Outcome::None;
    }
    if (now - m_run->begun >= kLongest) {
        end();
        m_alarms.raise(alarmEntry("rotator.no-home-run"),
                       {Text::tr("no standstill within %1 min").arg(kLongest.count())});
        return Outcome::TooLong;
    }
    if (!m_run->accepted || now - *m_run->accepted < kLeast || moves) {
        return Outcome::None;
    }
    end();
    return Outcome::Ended;
}

}  // namespace boresight
