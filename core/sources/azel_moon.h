// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/azel/azel_feed.h"
#include "core/control/control_parts.h"
#include "core/ephemeris/almanac.h"

#include <optional>

// Where the Moon of azel.dat is between the steps of the file: our own Moon, while both agree, else the last step. Our
// own needs the site. Station thread only.
namespace boresight::sources {

class AzelMoon
{
public:
    // Once in a tick, before all else.
    void look(const ControlParts& view, const azel::AzelFeed& feed);

    // Of the file's Moon from our own; empty: there is none of them.
    [[nodiscard]] const std::optional<Angle>& apart() const { return m_apart; }
    [[nodiscard]] bool interpolates() const;
    [[nodiscard]] bool differs() const;
    [[nodiscard]] bool isElsewhere() const;
    // The file has been read.
    [[nodiscard]] SkyPointing at(UtcTime utc);
    // Across the sky. Empty: it goes by the steps of the file.
    [[nodiscard]] std::optional<AngularRate> skyRate(UtcTime utc);
    // Of the horizon; empty: it does not within a day, or nobody can compute it.
    [[nodiscard]] std::optional<UtcTime> nextRise(UtcTime from);
    [[nodiscard]] std::optional<UtcTime> nextSet(UtcTime from);

private:
    std::optional<ephemeris::Almanac> m_almanac;
    std::optional<Site> m_site;  // of the almanac
    SkyPointing m_step;          // of the file
    UtcTime m_compared{};        // the time that the file showed then
    std::optional<Angle> m_apart;
};

}  // namespace boresight::sources
