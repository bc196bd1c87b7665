// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/guide/guide_progress.h"

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

// In a settings file; never translated.
constexpr std::array kWords{"connect", "protection", "directions", "travel", "level", "north", "site", "client"};

std::size_t indexOf(GuideStep step)
{
    return static_cast<std::size_t>(std::ranges::find(kGuideSteps, step) - kGuideSteps.begin());
}

QString word(GuideStep step)
{
    return QLatin1String(kWords.at(indexOf(step)));
}

QString words(const std::set<GuideStep>& steps)
{
    QStringList all;
    for (const GuideStep step : steps) {
        all << word(step);
    }
    return all.join(QLatin1Char(' '));
}

std::set<GuideStep> stepsIn(const QString& text)
{
    const QStringList given = text.split(QLatin1Char(' '));
    std::set<GuideStep> steps;
    std::ranges::copy_if(kGuideSteps, std::inserter(steps, steps.end()),
                         [&given](GuideStep step) { return given.contains(word(step)); });
    return steps;
}

bool everyDriveAnswers(const StationStatus& status)
{
    const bool read = !status.drives || (!status.drives->released && status.drives->survey == SurveyState::Done);
    return status.state != StationState::Disconnected && read;
}

}  // namespace

QString name(GuideStep step)
{
    const std::array names{GuideWords::tr("Connect"), GuideWords::tr("Protect"), GuideWords::tr("Turning"),
                           GuideWords::tr("Travel"),  GuideWords::tr("Level"),   GuideWords::tr("North"),
                           GuideWords::tr("Site"),    GuideWords::tr("Client")};
    return names.at(indexOf(step));
}

QString title(GuideStep step)
{
    const std::array titles{GuideWords::tr("Connect: how are the drives reached?"),
                            GuideWords::tr("Protect: does each drive guard the mount by itself?"),
                            GuideWords::tr("Turning: which motor is which, and which way does it turn?"),
                            GuideWords::tr("Travel: how far may each axis and its cable go?"),
                            GuideWords::tr("Level: where is elevation 0°?"),
                            GuideWords::tr("North: where is azimuth 0°?"),
                            GuideWords::tr("Site: where does the mount stand?"),
                            GuideWords::tr("Client: which program follows the satellites?")};
    return titles.at(indexOf(step));
}

bool applies(GuideStep step, const StationStatus& status)
{
    return !(step == GuideStep::Level && missingAxis(status) == Axis::Elevation) &&
           !(step == GuideStep::North && missingAxis(status) == Axis::Azimuth);
}

QString whyNotDone(GuideStep step, const StationStatus& status)
{
    switch (step) {
        case GuideStep::Connect:
            return everyDriveAnswers(status) ? QString() : GuideWords::tr("Every drive must answer and be read first.");
        case GuideStep::Protection:
            return !everyDriveAnswers(status) ? GuideWords::tr("The drives have not been read.")
                                              : drivesOf(status).armingObstacle;
        case GuideStep::Directions:
            return status.profile->mount.directions == profile::Directions::Confirmed
                       ? QString()
                       : GuideWords::tr("The directions are not confirmed.");
        case GuideStep::Site:
            return status.profile->site.known ? QString() : GuideWords::tr("No site has been set.");
        default:
            return {};
    }
}

StepState stateOf(GuideStep step, const StationStatus& status, const GuideProgress& progress)
{
    const bool isSeen = step == GuideStep::Connect || step == GuideStep::Protection || step == GuideStep::Directions ||
                        step == GuideStep::Site;
    const bool done = isSeen ? whyNotDone(step, status).isEmpty()
                             : progress.passed.contains(step) || (step == GuideStep::Client && !status.clients.empty());
    return done ? StepState::Done : progress.later.contains(step) ? StepState::Later : StepState::Open;
}

QString toText(const GuideProgress& progress)
{
    return QStringList{progress.open ? QStringLiteral("open") : QStringLiteral("closed"), word(progress.current),
                       words(progress.passed), words(progress.later), progress.mount}
        .join(QLatin1Char('|'));
}

GuideProgress guideProgressFrom(const QString& text)
{
    const QStringList parts = text.split(QLatin1Char('|'));
    if (parts.size() < 5) {
        return {};
    }
    GuideProgress progress{.open = parts[0] == QLatin1String("open"),
                           .passed = stepsIn(parts[2]),
                           .later = stepsIn(parts[3]),
                           .mount = parts.mid(4).join(QLatin1Char('|'))};
    const auto current = stepsIn(parts[1]);
    progress.current = current.empty() ? GuideStep::Connect : *current.begin();
    return progress;
}

}  // namespace boresight::ui
