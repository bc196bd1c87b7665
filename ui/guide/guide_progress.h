// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QString>

#include <array>
#include <set>
#include <span>

// How far a mount is commissioned. What can be seen in the station's status or in the profile is read there and never
// remembered. Only what nobody can see is kept: the operator has looked, and confirmed it. Plain values.
namespace boresight::ui {

// In their order. Protections go before the directions, because the station moves no drive that does not protect the
// mount by itself, not even a little.
enum class GuideStep
{
    Connect,
    Protection,
    Directions,
    Travel,
    Level,
    North,
    Site,
    Client,
    Ready  // what is done and what is not, and the first pass
};

inline constexpr std::array kGuideSteps{GuideStep::Connect, GuideStep::Protection, GuideStep::Directions,
                                        GuideStep::Travel,  GuideStep::Level,      GuideStep::North,
                                        GuideStep::Site,    GuideStep::Client,     GuideStep::Ready};
// Those that commission something.
inline constexpr std::span kWorkSteps = std::span(kGuideSteps).first(kGuideSteps.size() - 1);

enum class StepState
{
    Open,
    Done,     // seen in the station, or confirmed by the operator
    Skipped,  // passed by, and left for later
    NeedsYou  // something is wrong, or waits for the operator
};

struct StepReport
{
    StepState state = StepState::Open;
    QString why;  // what is wrong, or what is missing; empty when it is done
};

struct GuideProgress
{
    bool open = false;  // the guide is on the screen
    GuideStep current = GuideStep::Connect;
    std::set<GuideStep> confirmed;  // the operator said that it is right
    std::set<GuideStep> skipped;
    QString mount;  // whose progress it is

    bool operator==(const GuideProgress&) const = default;
};

[[nodiscard]] QString name(GuideStep step);          // "Connect"
[[nodiscard]] QString title(GuideStep step);         // "Connect: how the drives are reached"
[[nodiscard]] QString word(StepState state);         // "needs you"
[[nodiscard]] QString confirmation(GuideStep step);  // what the operator confirms; empty: the station sees it itself

[[nodiscard]] StepReport reportOf(GuideStep step, const StationStatus& status, const GuideProgress& progress);
// The mount has what the step is about.
[[nodiscard]] bool applies(GuideStep step, const StationStatus& status);
[[nodiscard]] int numberOf(GuideStep step, const StationStatus& status);  // among those of this mount, from 1

// For a settings file. What cannot be read counts as nothing done.
[[nodiscard]] QString toText(const GuideProgress& progress);
[[nodiscard]] GuideProgress guideProgressFrom(const QString& text);

}  // namespace boresight::ui
