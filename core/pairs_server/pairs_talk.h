// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pairs_server/pairs_words.h"
#include "core/rotctld/line_session.h"

#include <functional>
#include <optional>
#include <string>

// The mount for one client that writes plain numbers. Each line is answered with "OK", with the position, or with the
// reason of a refusal. Station thread.
namespace boresight::pairs {

// The site of the mount. Empty while the profile has none.
using SiteNow = std::function<std::optional<Site>()>;

class PairsTalk final : public rotctld::LineProtocol
{
public:
    // The rotator outlives this.
    PairsTalk(rotctld::Client client, rotctld::Rotator& rotator, SiteNow site);

    [[nodiscard]] rotctld::LineOutcome obey(std::string_view line) override;
    [[nodiscard]] rotctld::LineOutcome obey(const Command& command);

private:
    void carryOut(const Report& report, rotctld::LineOutcome& outcome);
    void carryOut(const Stop& stop, rotctld::LineOutcome& outcome);
    void carryOut(const Park& park, rotctld::LineOutcome& outcome);
    void carryOut(const Place& place, rotctld::LineOutcome& outcome);
    void carryOut(const MoveBy& move, rotctld::LineOutcome& outcome);
    void carryOut(const Bearing& bearing, rotctld::LineOutcome& outcome);
    void point(const Result<SkyPointing>& place, rotctld::LineOutcome& outcome);
    [[nodiscard]] Result<SkyPointing> directionOf(const targets::Target& target) const;

    rotctld::Client m_client;
    rotctld::Rotator& m_rotator;
    SiteNow m_site;
};

// How a server starts a conversation with a client. Rotator and clock outlive it.
[[nodiscard]] rotctld::StartConversation talkPairs(rotctld::Rotator& rotator, const Clock& clock, SiteNow site);

}  // namespace boresight::pairs
