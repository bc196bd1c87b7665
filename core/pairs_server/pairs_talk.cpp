// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pairs_server/pairs_talk.h"

#include "core/base/text.h"
#include "core/rotctld/client_target.h"
#include "core/targets/target_path.h"

#include <utility>

namespace boresight::pairs {

PairsTalk::PairsTalk(rotctld::Client client, rotctld::Rotator& rotator, SiteNow site)
    : m_client(std::move(client)), m_rotator(rotator), m_site(std::move(site))
{}

rotctld::LineOutcome PairsTalk::obey(std::string_view line)
{
    const auto command = parseLine(line);
    if (command) {
        return obey(*command);
    }
    if (endsInStop(line)) {  // a stop counts even if the rest of the line is refused
        (void)obey(Command(Stop{}));
    }
    return {.reply = refusalOf(command.error()), .result = tl::unexpected(command.error())};
}

rotctld::LineOutcome PairsTalk::obey(const Command& command)
{
    rotctld::LineOutcome outcome{.reply = std::string(kDone), .result = {}};
    std::visit([&](const auto& wanted) { carryOut(wanted, outcome); }, command);
    if (!outcome.result) {
        outcome.reply = refusalOf(outcome.result.error());
    }
    return outcome;
}

void PairsTalk::carryOut(const Report&, rotctld::LineOutcome& outcome)
{
    outcome.result = m_rotator.position(m_client).map([&](const SkyPointing& now) { outcome.reply = reportOf(now); });
}

void PairsTalk::carryOut(const Stop&, rotctld::LineOutcome& outcome)
{
    outcome.stop = true;
    outcome.result = m_rotator.stop(m_client);
}

void PairsTalk::carryOut(const Park&, rotctld::LineOutcome& outcome)
{
    outcome.motion = true;
    outcome.result = m_rotator.park(m_client);
}

void PairsTalk::carryOut(const Place& place, rotctld::LineOutcome& outcome)
{
    point(rotctld::completed(m_rotator, place.azimuth, place.elevation), outcome);
}

// Moves from the target, so that several steps one after the other add up.
void PairsTalk::carryOut(const MoveBy& move, rotctld::LineOutcome& outcome)
{
    point(m_rotator.target().and_then([&](const SkyPointing& from) { return movedBy(from, move, m_rotator.limits()); }),
          outcome);
}

void PairsTalk::carryOut(const Bearing& bearing, rotctld::LineOutcome& outcome)
{
    point(directionOf(bearing.target), outcome);
}

void PairsTalk::point(const Result<SkyPointing>& place, rotctld::LineOutcome& outcome)
{
    outcome.result = rotctld::pointTo(m_rotator, m_client, place, outcome);
    outcome.reply = doneAs(outcome.became);
}

Result<SkyPointing> PairsTalk::directionOf(const targets::Target& target) const
{
    const auto site = m_site();
    if (!site) {
        return failure(ErrorCode::NotAvailable,
                       Text::tr("The site of the mount is unknown. Enter it on the page Profile."));
    }
    return targets::TargetPath(target, *site).at({}).map([&](const SkyPointing& direction) {
        return SkyPointing{.azimuth = m_rotator.limits().turned(direction.azimuth), .elevation = direction.elevation};
    });
}

rotctld::StartConversation talkPairs(rotctld::Rotator& rotator, const Clock& clock, SiteNow site)
{
    return
        [&rotator, &clock, site = std::move(site)](rotctld::Client client) -> std::unique_ptr<rotctld::Conversation> {
            auto talk = std::make_unique<PairsTalk>(client, rotator, site);
            return std::make_unique<rotctld::LineSession>(std::move(client), std::move(talk), rotator, clock);
        };
}

}  // namespace boresight::pairs
