// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QString>

#include <array>
#include <set>
#include <span>

// How far a mount is commissioned. The steps that the station's status or the profile show are read from there and are
// not stored. Only the operator's confirmations of the other steps are stored. Plain values.
namespace boresight::ui {

// In this order. The protection comes before the directions, because the station moves no drive that does not protect
// the mount by itself, not even a little.
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
    Ready  // summary of the steps, and help for the first pass
};

inline constexpr std::array kGuideSteps{GuideStep::Connect, GuideStep::Protection, GuideStep::Directions,
                                        GuideStep::Travel,  GuideStep::Level,      GuideStep::North,
                                        GuideStep::Site,    GuideStep::Client,     GuideStep::Ready};
// The steps that commission something.
inline constexpr std::span kWorkSteps = std::span(kGuideSteps).first(kGuideSteps.size() - 1);

enum class StepState
{
    Open,
    Done,     // shown by the station, or confirmed by the operator
    Skipped,  // left for later
    NeedsYou  // there is a problem, or the operator has to act
};

struct StepReport
{
    StepState state = StepState::Open;
    QString why;  // the problem, or what is missing; empty when it is done
};

struct GuideProgress
{
    bool open = false;  // the guide is shown
    GuideStep current = GuideStep::Connect;
    std::set<GuideStep> confirmed;  // the steps that the operator has confirmed
    std::set<GuideStep> skipped;
    QString mount;  // the mount that this progress belongs to

    bool operator==(const GuideProgress&) const = default;
};

[[nodiscard]] QString name(GuideStep step);   // "Connect"
[[nodiscard]] QString title(GuideStep step);  // "Connect: how the drives are reached"
[[nodiscard]] QString word(StepState state);  // "needs you"
[[nodiscard]] QString confirmation(
    GuideStep step);  // the question to the operator; empty: the station shows the step by itself

[[nodiscard]] StepReport reportOf(GuideStep step, const StationStatus& status, const GuideProgress& progress);
// True if this step exists for the mount.
[[nodiscard]] bool applies(GuideStep step, const StationStatus& status);
[[nodiscard]] int numberOf(GuideStep step, const StationStatus& status);  // counts the steps of this mount, from 1

// For a settings file. Unreadable text gives an empty progress.
[[nodiscard]] QString toText(const GuideProgress& progress);
[[nodiscard]] GuideProgress guideProgressFrom(const QString& text);

}  // namespace boresight::ui
