// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/night/pass_moments.h"

#include "core/base/text.h"
#include "core/base/time_of_day.h"

#include <utility>

namespace boresight {

using schedule::Moment;
using schedule::PassEnd;
using schedule::WatchedPass;

PassMoments::PassMoments(EventLog& log, const Clock& clock, Tell tell)
    : m_log(log), m_clock(clock), m_tell(std::move(tell))
{}

void PassMoments::expect(const WatchedPass* next, Seconds before)
{
    if (m_pass && (next == nullptr || !isSamePass(*m_pass, *next))) {
        end(PassEnd::Refused, Text::tr("the new plan does not contain this pass"));
    }
    if (next != nullptr && Seconds(next->begins() - m_clock.utc()) <= before) {
        announce(*next);
    }
}

void PassMoments::follow(const WatchedPass& pass, Seconds before)
{
    expect(&pass, before);
    if (m_pass && !m_begun && m_clock.utc() >= pass.begins()) {
        m_begun = true;
        m_log.add(
            Severity::Advisory, QStringLiteral("schedule"),
            (pass.rest ? Text::tr("the tracked part of the pass of %1 begins") : Text::tr("AOS of %1")).arg(pass.name));
        tell({.moment = Moment::Aos, .pass = pass});
    }
}

void PassMoments::announce(const WatchedPass& pass)
{
    if (m_pass) {
        return;
    }
    m_pass = pass;
    m_log.add(Severity::Advisory, QStringLiteral("schedule"),
              Text::tr("the pass of %1 begins at %2").arg(pass.name, timeOfDayText(pass.begins())));
    tell({.moment = Moment::BeforeAos, .pass = pass});
}

void PassMoments::end(PassEnd end, const QString& why)
{
    m_begun = false;
    if (const auto pass = std::exchange(m_pass, std::nullopt)) {
        const QString words = end != PassEnd::Set ? Text::tr("the pass of %1 ends before its LOS")
                              : pass->rest        ? Text::tr("the tracked part of the pass of %1 ends")
                                                  : Text::tr("LOS of %1");
        m_log.add(Severity::Advisory, QStringLiteral("schedule"), words.arg(pass->name));
        tell({.moment = Moment::Los, .pass = pass, .end = end, .why = why});
    }
}

// The fault itself is in the log already.
void PassMoments::fault(const QString& why)
{
    tell({.moment = Moment::Fault, .pass = m_pass, .why = why});
}

void PassMoments::tell(const schedule::PassMoment& moment) const
{
    if (m_tell) {
        schedule::PassMoment now = moment;
        now.utc = m_clock.utc();
        m_tell(now);
    }
}

}  // namespace boresight
