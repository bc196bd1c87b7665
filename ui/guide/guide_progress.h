// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QString>

#include <array>
#include <set>

// How far a mount is commissioned. What can be seen in the station's status or in the profile is read there and never
// remembered; only what nobody can see (the operator has looked at the zero and it is right) is kept. Plain values.
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
    Client
};

inline constexpr std::array kGuideSteps{GuideStep::Connect, GuideStep::Protection, GuideStep::Directions,
                                        GuideStep::Travel,  GuideStep::Level,      GuideStep::North,
                                        GuideStep::Site,    GuideStep::Client};

enum class StepState
{
    Open,
    Done,
    Later  // skipped for now
};

struct GuideProgress
{
    bool open = false;  // the guide is on the screen
    GuideStep current = GuideStep::Connect;
    std::set<GuideStep> passed;  // the operator said that it is right
    std::set<GuideStep> later;
    QString mount;  // whose progress it is

    bool operator==(const GuideProgress&) const = default;
};

[[nodiscard]] QString name(GuideStep step);   // "Connect"
[[nodiscard]] QString title(GuideStep step);  // "Connect: how the drives are reached"

[[nodiscard]] StepState stateOf(GuideStep step, const StationStatus& status, const GuideProgress& progress);
// The mount has the axis that the step is about.
[[nodiscard]] bool applies(GuideStep step, const StationStatus& status);
// Why Next can not count the step as done; empty: it can.
[[nodiscard]] QString whyNotDone(GuideStep step, const StationStatus& status);

// For a settings file. What cannot be read counts as nothing done.
[[nodiscard]] QString toText(const GuideProgress& progress);
[[nodiscard]] GuideProgress guideProgressFrom(const QString& text);

}  // namespace boresight::ui
