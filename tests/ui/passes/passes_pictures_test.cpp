// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fakes/low_orbit.h"
#include "tests/fakes/wait_until.h"
#include "tests/ui/picture_book.h"
#include "ui/kit/choice_button.h"
#include "ui/plan/plan_view.h"

#include <QTabWidget>
#include <QTableView>

#include <vector>

// The page Passes while a satellite is tracked: each view of the coming passes, the schedule, and the other targets.
namespace boresight::ui {
namespace {

constexpr int kFirst = 25'544;
constexpr const char* kNames[] = {"ISS (ZARYA)", "NOAA 19",  "METEOR-M2 4", "FOX-1B (RADFXSAT)", "AO-91", "SO-50",
                                  "FO-29",       "UVSQ-SAT", "TEVEL-3",     "CUTE-1 (CO-55)",    "IO-86", "GREENCUBE",
                                  "RS-44",       "JO-97",    "DIWATA-2B"};

StationStatus withManySatellites()
{
    StationStatus status = samples::tracking(330);
    profile::Profile profile = *status.profile;
    profile.site = {.known = true, .latitude = 38.757_deg, .longitude = -9.117_deg, .heightMetres = 80.0};
    profile.schedule.watch = {{.number = kFirst, .priority = 1}, {.number = kFirst + 3, .priority = 2}};
    profile.satellites = {{.number = kFirst, .favourite = orbit::Favourite::On, .note = "145.800 MHz FM down, RHCP"},
                          {.number = kFirst + 2, .favourite = orbit::Favourite::On, .note = "137.900 MHz LRPT"}};
    status.profile = std::make_shared<const profile::Profile>(profile);
    std::vector<orbit::ElementSet> sets;
    for (const char* const name : kNames) {
        const double turn = static_cast<double>(sets.size());
        orbit::ElementSet set =
            fakes::lowOrbit(status.utc - std::chrono::hours(60), Angle::fromDegrees(10.0 + 47.0 * turn),
                            Angle::fromDegrees(131.0 * turn));
        set.number = kFirst + static_cast<int>(sets.size());
        set.name = name;
        sets.push_back(set);
    }
    status.satellites = std::make_shared<const std::vector<orbit::ElementSet>>(std::move(sets));
    status.clock = {.synchronised = true, .error = Seconds(0.0123)};
    status.tracked = TrackedTarget{.name = QStringLiteral("ISS (ZARYA)"),
                                   .number = kFirst,
                                   .isUp = true,
                                   .next = status.utc + std::chrono::minutes(5),
                                   .skyRate = AngularRate::fromDegrees(0.987)};
    return status;
}

// A night with a pass that is over, one that goes on in part beside another one, and one that is left out.
ScheduleStatus night(UtcTime now)
{
    using std::chrono::minutes;
    const auto passOf = [&](const char* name, int number, minutes from, minutes lasts) {
        schedule::WatchedPass one{.number = number, .name = QString::fromLatin1(name), .pass = {}};
        one.pass.aos.utc = now + from;
        one.pass.los.utc = now + from + lasts;
        one.pass.tca = {.utc = now + from + lasts / 2, .direction = {.azimuth = 10_deg, .elevation = 38_deg}};
        one.pass.clear = {{.from = one.pass.aos.utc, .to = one.pass.los.utc}};
        return one;
    };
    ScheduleStatus night;
    const schedule::WatchedPass chosen = passOf("ISS (ZARYA)", kFirst, minutes(12), minutes(10));
    const schedule::WatchedPass leftOut = passOf("FOX-1B (RADFXSAT)", kFirst + 3, minutes(17), minutes(12));
    schedule::WatchedPass rest = leftOut;
    rest.rest = passes::Stretch{.from = chosen.ends(), .to = leftOut.ends()};
    rest.pass.clear = {*rest.rest};
    night.plan.chosen = {chosen, rest, passOf("ISS (ZARYA)", kFirst, minutes(105), minutes(9))};
    night.plan.conflicts = {{.leftOut = leftOut, .chosen = chosen, .rests = {*rest.rest}}};
    night.plan.hidden = {passOf("METEOR-M2 4", kFirst + 2, minutes(60), minutes(10))};
    night.report.passes = {{.number = kFirst + 2,
                            .name = QStringLiteral("METEOR-M2 4"),
                            .aos = now - minutes(30),
                            .los = now - minutes(20),
                            .tracked = Seconds(600.0),
                            .within1dB = Seconds(590.0),
                            .within3dB = Seconds(600.0),
                            .rmsError = 0.03_deg,
                            .peakError = 0.2_deg,
                            .end = schedule::PassEnd::Set,
                            .why = {}}};
    return night;
}

class PassesPictures : public PictureBook
{
protected:
    void open()
    {
        show(m_status, 'T');
        ASSERT_TRUE(fakes::waitUntil([this] { return table().model()->rowCount() > 0; }));
        table().selectRow(2);
        refresh();
    }
    void openPage(int page)
    {
        named<QTabWidget>(translated("PanelTabs", "Passes of satellites"))->setCurrentIndex(page);
        refresh();
    }
    void refresh()
    {
        m_status.utc += std::chrono::seconds(1);
        give(samples::update(m_status));
        settle();
    }
    QTableView& table() { return *named<QTableView>(translated("PassesPanel", "Coming passes")); }

    StationStatus m_status = withManySatellites();
};

// REQ-UI-15 (PassesPictures.*)
TEST_P(PassesPictures, AreTakenOfEachView)
{
    open();
    for (const auto& [scene, view] : {std::pair("passes", "The passes as a list"),
                                      std::pair("passes-timeline", "The passes of the next 24 hours side by side"),
                                      std::pair("passes-elevation", "The elevation of the selected pass over time"),
                                      std::pair("passes-map", "The path of the selected satellite over the Earth"),
                                      std::pair("passes-plan", "How the mount will track the selected pass")}) {
        QTest::mouseClick(named<ChoiceButton>(translated("PassViews", view)), Qt::LeftButton);
        const auto* const plan = window.findChild<PlanView*>();
        ASSERT_TRUE(fakes::waitUntil([plan] { return !plan->isVisible() || plan->variant(); }));
        refresh();
        take(QLatin1String(scene));
    }
}

TEST_P(PassesPictures, AreTakenOfScheduleAndTargets)
{
    m_status.schedule = std::make_shared<const ScheduleStatus>(night(m_status.utc));
    open();
    openPage(1);
    take(QStringLiteral("passes-schedule"));
    openPage(2);
    take(QStringLiteral("passes-targets"));
}

INSTANTIATE_TEST_SUITE_P(All, PassesPictures, kThemesAndPortuguese, editionName);

}  // namespace
}  // namespace boresight::ui
