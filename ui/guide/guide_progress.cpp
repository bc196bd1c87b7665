// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/guide/guide_progress.h"

#include "core/profile/axis_driver.h"
#include "ui/kit/axes.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>

namespace boresight::ui {

namespace {

class GuideWords
{
    Q_DECLARE_TR_FUNCTIONS(GuideWords)
};

// The words in the settings file, never translated. kForm is the version of the text. In version 1 every Next had
// counted as a confirmation.
constexpr std::array kWords{"connect", "protection", "directions", "travel", "level",
                            "north",   "site",       "client",     "ready"};
constexpr QLatin1String kForm("2");

std::size_t indexOf(GuideStep step)
{
    return static_cast<std::size_t>(std::ranges::find(kGuideSteps, step) - kGuideSteps.begin());
}

QString key(GuideStep step)
{
    return QLatin1String(kWords.at(indexOf(step)));
}

QString words(const std::set<GuideStep>& steps)
{
    QStringList all;
    for (const GuideStep step : steps) {
        all << key(step);
    }
    return all.join(QLatin1Char(' '));
}

std::set<GuideStep> stepsIn(const QString& text)
{
    const QStringList given = text.split(QLatin1Char(' '));
    std::set<GuideStep> steps;
    std::ranges::copy_if(kGuideSteps, std::inserter(steps, steps.end()),
                         [&given](GuideStep step) { return given.contains(key(step)); });
    return steps;
}

bool everyDriveAnswers(const StationStatus& status)
{
    const bool read =
        !status.drives || (!status.drives->released && status.drives->driveCheck == DriveCheckState::Done);
    return status.state != StationState::Disconnected && read;
}

bool isBeingRead(const StationStatus& status)
{
    const DriveCheckState driveCheck = drivesOf(status).driveCheck;
    return driveCheck == DriveCheckState::Running || driveCheck == DriveCheckState::Fixing;
}

QString whyNotConnected(const StationStatus& status)
{
    if (everyDriveAnswers(status) || isBeingRead(status)) {
        return {};
    }
    if (drivesOf(status).released) {
        return GuideWords::tr("The bus is released. Press Take bus back on the page Drives.");
    }
    const QString obstacle = drivesOf(status).armingObstacle;
    return obstacle.isEmpty() ? GuideWords::tr("The mount does not answer.") : obstacle;
}

QString unknownWrap(const StationStatus& status, Axis axis)
{
    if (!driveOf(status, axis).turnQuestion) {
        return {};
    }
    return (axis == Axis::Azimuth ? GuideWords::tr("The cable wrap of the %1 is unknown. Press Ctrl+9 to enter it.")
                                  : GuideWords::tr("The position of the %1 is unknown. Press Ctrl+9 to enter it."))
        .arg(name(axis));
}

// A problem, or what the operator has to do. Empty: nothing.
QString trouble(GuideStep step, const StationStatus& status)
{
    switch (step) {
        case GuideStep::Connect:
            return whyNotConnected(status);
        case GuideStep::Protection:
            return everyDriveAnswers(status) ? drivesOf(status).armingObstacle : QString();
        case GuideStep::Travel: {
            const auto axis = askingAxis(status);
            return axis ? unknownWrap(status, *axis) : QString();
        }
        case GuideStep::North:
            return status.calibration->otherMount;
        case GuideStep::Client:
            return status.listening.isEmpty()
                       ? GuideWords::tr("No program can connect, because rotctld does not listen.")
                       : QString();
        default:
            return {};
    }
}

// The reason why the station does not show the step as done. Empty: it is done.
QString whyNotSeen(GuideStep step, const StationStatus& status)
{
    switch (step) {
        case GuideStep::Connect:
            return everyDriveAnswers(status) ? QString() : GuideWords::tr("Boresight is reading the drives.");
        case GuideStep::Protection:
            return everyDriveAnswers(status) ? QString() : GuideWords::tr("The drives have not been read.");
        case GuideStep::Directions:
            return status.profile->mount.directions == profile::Directions::Confirmed
                       ? QString()
                       : GuideWords::tr("The directions are not confirmed.");
        case GuideStep::Site:
            return status.profile->site.known ? QString() : GuideWords::tr("No site has been set.");
        case GuideStep::Client:
            return status.clients.empty() ? GuideWords::tr("No program is connected.") : QString();
        case GuideStep::North:
            return std::ranges::any_of(status.calibration->history, &CalibrationHistoryEntry::inForce)
                       ? QString()
                       : GuideWords::tr("Nobody has confirmed north.");
        default:
            return GuideWords::tr("Nobody has confirmed this step.");
    }
}

// The worst state of all steps before.
StepReport readiness(const StationStatus& status, const GuideProgress& progress)
{
    StepReport worst{.state = StepState::Done};
    for (const GuideStep step : kWorkSteps) {
        if (!applies(step, status)) {
            continue;
        }
        const StepReport one = reportOf(step, status, progress);
        if (one.state == StepState::NeedsYou) {
            return {.state = StepState::NeedsYou, .why = GuideWords::tr("A step needs you.")};
        }
        if (one.state != StepState::Done) {
            worst = {.state = StepState::Open, .why = GuideWords::tr("Not every step is done.")};
        }
    }
    return worst;
}

}  // namespace

QString name(GuideStep step)
{
    const std::array names{GuideWords::tr("Connect"), GuideWords::tr("Protect"), GuideWords::tr("Turning"),
                           GuideWords::tr("Travel"),  GuideWords::tr("Level"),   GuideWords::tr("North"),
                           GuideWords::tr("Site"),    GuideWords::tr("Client"),  GuideWords::tr("Ready")};
    return names.at(indexOf(step));
}

QString title(GuideStep step)
{
    const std::array titles{GuideWords::tr("Connect: what turns the mount?"),
                            GuideWords::tr("Protect: are the safety settings of each drive right?"),
                            GuideWords::tr("Turning: which motor turns which axis, and which way?"),
                            GuideWords::tr("Travel: how far may each axis and its cable go?"),
                            GuideWords::tr("Level: where is elevation 0°?"),
                            GuideWords::tr("North: where is azimuth 0°?"),
                            GuideWords::tr("Site: where does the mount stand?"),
                            GuideWords::tr("Client: which program tracks the satellites?"),
                            GuideWords::tr("Ready: first pass")};
    return titles.at(indexOf(step));
}

QString word(StepState state)
{
    switch (state) {
        case StepState::Done:
            return GuideWords::tr("done");
        case StepState::Skipped:
            return GuideWords::tr("skipped");
        case StepState::NeedsYou:
            return GuideWords::tr("needs you");
        case StepState::Open:
            break;
    }
    return GuideWords::tr("to do");
}

QString confirmation(GuideStep step)
{
    switch (step) {
        case GuideStep::Travel:
            return GuideWords::tr("I have checked: the ends of the travel are right");
        case GuideStep::Level:
            return GuideWords::tr("I have checked: elevation 0° is level");
        case GuideStep::North:
            return GuideWords::tr("I have checked: north is right");
        case GuideStep::Client:
            return GuideWords::tr("The program that tracks the satellites is set up");
        default:
            return {};
    }
}

bool applies(GuideStep step, const StationStatus& status)
{
    switch (step) {
        case GuideStep::Protection:
            return std::ranges::any_of(
                kAxes, [&](Axis axis) { return profile::kindOf(status.profile->axis(axis).driver).hasId; });
        case GuideStep::Level:
            return missingAxis(status) != Axis::Elevation;
        case GuideStep::North:
            return missingAxis(status) != Axis::Azimuth;
        default:
            return true;
    }
}

int numberOf(GuideStep step, const StationStatus& status)
{
    const auto before = std::span(kGuideSteps).first(indexOf(step));
    return 1 + static_cast<int>(std::ranges::count_if(before, [&](GuideStep one) { return applies(one, status); }));
}

StepReport reportOf(GuideStep step, const StationStatus& status, const GuideProgress& progress)
{
    if (step == GuideStep::Ready) {
        return readiness(status, progress);
    }
    if (const QString wrong = trouble(step, status); !wrong.isEmpty()) {
        return {.state = StepState::NeedsYou, .why = wrong};
    }
    const QString missing = whyNotSeen(step, status);
    const bool confirmed = !confirmation(step).isEmpty() && progress.confirmed.contains(step);
    if (missing.isEmpty() || confirmed) {
        return {.state = StepState::Done};
    }
    return {.state = progress.skipped.contains(step) ? StepState::Skipped : StepState::Open, .why = missing};
}

QString toText(const GuideProgress& progress)
{
    return QStringList{kForm,
                       progress.open ? QStringLiteral("open") : QStringLiteral("closed"),
                       key(progress.current),
                       words(progress.confirmed),
                       words(progress.skipped),
                       progress.mount}
        .join(QLatin1Char('|'));
}

GuideProgress guideProgressFrom(const QString& text)
{
    const QStringList parts = text.split(QLatin1Char('|'));
    if (parts.size() < 6 || parts[0] != kForm) {
        return {};
    }
    GuideProgress progress{.open = parts[1] == QLatin1String("open"),
                           .confirmed = stepsIn(parts[3]),
                           .skipped = stepsIn(parts[4]),
                           .mount = parts.mid(5).join(QLatin1Char('|'))};
    const auto current = stepsIn(parts[2]);
    progress.current = current.empty() ? GuideStep::Connect : *current.begin();
    return progress;
}

}  // namespace boresight::ui
