// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/passes/passes_panel.h"

#include "core/targets/track_rules.h"
#include "tests/ui/event_loop.h"
#include "tests/ui/passes/passes_fixture.h"
#include "ui/guide/guide_page.h"
#include "ui/kit/command_button.h"
#include "ui/kit/format.h"
#include "ui/kit/value_label.h"
#include "ui/passes/note_line.h"
#include "ui/passes/pass_details.h"
#include "ui/passes/pass_views.h"
#include "ui/passes/pass_words.h"
#include "ui/sky/polar_plot.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QMenu>
#include <QScrollArea>
#include <QScrollBar>
#include <QToolButton>

#include <gmock/gmock.h>

#include <cmath>
#include <ranges>

namespace boresight::ui {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::MatchesRegex;
using testing::Not;

class PassesPanelTest : public PassesFixture
{
protected:
    // When the station accepts to track this pass.
    StationStatus soonBefore(int row)
    {
        StationStatus status = withSatellites();
        status.utc = qobject_cast<PassTable*>(table().model())->pass(row).pass.aos.utc - std::chrono::minutes(5);
        return status;
    }
};

// REQ-PASSES-950: The panel Passes lists the coming passes of all satellites within a day, in the order of their rise.
// Typed words and a minimum elevation filter them. Without satellites or without a site it says what to do.
TEST_F(PassesPanelTest, SaysWhatToDoWithoutSatellites)
{
    EXPECT_TRUE(text("About the passes").startsWith(QStringLiteral("Boresight knows no satellites.")));
    EXPECT_FALSE(named<CommandButton>("Track")->isEnabled());
    StationStatus status = withSatellites();
    profile::Profile nowhere = *status.profile;
    nowhere.site.known = false;
    status.profile = std::make_shared<const profile::Profile>(nowhere);
    give(samples::update(status));
    EXPECT_TRUE(text("About the passes").startsWith(QStringLiteral("The site is not set.")));
}

// REQ-PASSES-990: If elements or the site are missing, they can be added from the page of the passes. Without elements
// a button adds a file or a group of CelesTrak to the profile at once, and a refusal stays readable. Without a site a
// button opens that step of the guide.
TEST_F(PassesPanelTest, TheButtonAddsElements)
{
    StationStatus status = samples::idle();
    status.permissions = Permissions::all();
    give(samples::update(status));
    auto* const button = named<QPushButton>("Add elements");
    ASSERT_TRUE(button->isVisible());
    const QList<QAction*> lines = button->menu()->actions();
    const auto stations = std::ranges::find(lines, QStringLiteral("Space stations (CelesTrak)"), &QAction::text);
    ASSERT_NE(stations, lines.end());
    (*stations)->trigger();
    ASSERT_EQ(asked<request::ApplyProfile>().size(), 1U);
    EXPECT_EQ(asked<request::ApplyProfile>().back().profile.orbit.elements,
              std::vector<std::string>{"celestrak:stations"});
    StationUpdate refused = samples::update(status);
    refused.answers.push_back(
        {.requestId = requests.back().id, .error = Error{ErrorCode::Refused, QStringLiteral("No.")}});
    give(refused);
    give(samples::update(status));
    EXPECT_EQ(text("About the passes"), QStringLiteral("Elements: No."));
}

// REQ-PASSES-990
TEST_F(PassesPanelTest, TheButtonLeadsToTheSite)
{
    StationStatus status = withSatellites();
    profile::Profile nowhere = *status.profile;
    nowhere.site.known = false;
    status.profile = std::make_shared<const profile::Profile>(nowhere);
    give(samples::update(status));
    EXPECT_EQ(window.findChild<GuidePage*>(), nullptr);
    QTest::mouseClick(named<QPushButton>("Enter the site"), Qt::LeftButton);
    const auto* const guide = window.findChild<GuidePage*>();
    ASSERT_NE(guide, nullptr);
    EXPECT_TRUE(guide->isVisible());
    EXPECT_EQ(guide->progress().current, GuideStep::Site);
    give(samples::update(withSatellites()));
    EXPECT_TRUE(named<QPushButton>("Enter the site")->isHidden()) << "also while passes are searched for";
}

TEST_F(PassesPanelTest, ListsThePassesInTheOrderInWhichTheyRise)
{
    giveFound(withSatellites());
    EXPECT_EQ(names(), (std::vector<std::string>{"ALPHA ONE", "ALPHA TWO", "BETA"}));
    ASSERT_GT(rows(), 9) << "several of each within a day";
    const auto& model = *qobject_cast<PassTable*>(table().model());
    for (int row = 1; row < rows(); ++row) {
        EXPECT_LE(model.pass(row - 1).pass.aos.utc, model.pass(row).pass.aos.utc);
    }
    EXPECT_TRUE(text("About the passes").endsWith(QStringLiteral("passes of 3 satellites within a day")));
    EXPECT_FALSE(text("The selected pass").isEmpty()) << "the first is selected";
}

TEST_F(PassesPanelTest, WordsAndHeightSelect)
{
    giveFound(withSatellites());
    const int all = rows();
    QTest::keyClicks(named<QLineEdit>("Satellites to list"), QStringLiteral("alpha"));
    EXPECT_EQ(names(), (std::vector<std::string>{"ALPHA ONE", "ALPHA TWO"}));
    named<QLineEdit>("Satellites to list")->setText(QStringLiteral("4006"));
    EXPECT_EQ(names(), (std::vector<std::string>{"BETA"}));
    named<QLineEdit>("Satellites to list")->clear();
    named<QDoubleSpinBox>("Elevation that a listed pass must reach")->setValue(30.0);
    EXPECT_LT(rows(), all);
    const auto& model = *qobject_cast<PassTable*>(table().model());
    for (int row = 0; row < rows(); ++row) {
        EXPECT_GE(model.pass(row).pass.tca.direction.elevation, 30_deg);
    }
    named<QLineEdit>("Satellites to list")->setText(QStringLiteral("no such thing"));
    EXPECT_EQ(rows(), 0);
    EXPECT_EQ(text("The selected pass"), QString());
}

// Story: with a name typed the page still counted the satellites of all elements.
// REQ-PASSES-991: The page counts the listed passes and satellites, and the number of all passes. If the filter hides
// all passes it says so.
TEST_F(PassesPanelTest, CountsWhatIsListed)
{
    const StationStatus status = withSatellites();
    giveFound(status);
    const QString all = QString::number(rows());
    EXPECT_EQ(text("About the passes"), all + QStringLiteral(" passes of 3 satellites within a day"));
    auto* const words = named<QLineEdit>("Satellites to list");
    words->setText(QStringLiteral("alpha"));
    give(samples::update(status));
    EXPECT_EQ(text("About the passes"),
              QStringLiteral("%1 of %2 passes within a day, of 2 satellites").arg(QString::number(rows()), all));
    words->setText(QStringLiteral("no such thing"));
    give(samples::update(status));
    EXPECT_EQ(text("About the passes"),
              QStringLiteral("No pass matches the filter. The filter leaves out %1.").arg(all));
}

// REQ-PASSES-958: The age of the elements is evaluated: the expected error of the satellite in seconds and degrees, and
// whether it exceeds half the beam width. The facts of the selected pass show this also in a low panel.
TEST_F(PassesPanelTest, JudgesTheAgeOfTheElements)
{
    StationStatus status = withSatellites();
    giveFound(status);
    // A low panel has all facts in the tooltip.
    const auto facts = [this] { return named<ValueLabel>("The selected pass")->toolTip(); };
    EXPECT_THAT(facts().toStdString(), AllOf(HasSubstr("elements 0.0 days old: expected error 0."),
                                             HasSubstr("°, beam "), Not(HasSubstr("half the beam"))));
    EXPECT_THAT(text("The selected pass").toStdString(),
                MatchesRegex("(.|\n)*elements 0\\.0 d old: error 0\\.[0-9] s, 0\\.[0-9][0-9]°, beam [0-9.]+°(.|\n)*"));
    profile::Profile profile = *status.profile;
    profile.mount.beamWidth = 0.01_deg;
    status.profile = std::make_shared<const profile::Profile>(profile);
    give(samples::update(status));
    ASSERT_TRUE(fakes::waitUntil([&] { return facts().contains(u"°, more than half the beam"); }));
    EXPECT_THAT(text("The selected pass").toStdString(), HasSubstr("°, beam 0.01°, too old"));
    EXPECT_FALSE(named<ValueLabel>("The selected pass")->isElided());

    // With the antenna in use, or with the satellite's own antenna.
    profile.mount.beamWidth = 10_deg;
    profile.antennas = {{.name = "thin", .beamWidth = 0.01_deg}};
    status.profile = std::make_shared<const profile::Profile>(profile);
    give(samples::update(status));
    ASSERT_TRUE(fakes::waitUntil([&] { return !facts().contains(u"half the beam"); }));
    for (const orbit::ElementSet& one : *status.satellites) {
        orbit::setAntenna(profile.satellites, static_cast<int>(one.number), "thin");
    }
    status.profile = std::make_shared<const profile::Profile>(profile);
    give(samples::update(status));
    ASSERT_TRUE(fakes::waitUntil([&] { return facts().contains(u"°, more than half the beam"); }));
}

// REQ-PASSES-967: The chosen view and "Favourites only" are restored at the next start.
TEST_F(PassesPanelTest, TheViewAndFavouritesOnlyAreRemembered)
{
    giveFound(withSatellites());
    QTest::mouseClick(named<QToolButton>("The path of the selected satellite over the Earth"), Qt::LeftButton);
    QTest::mouseClick(named<QToolButton>("Favourites only"), Qt::LeftButton);
    WindowSettings next = settings();
    next.layout = window.arrangement();
    EXPECT_EQ(next.layout.passes, (PassesLayout{.view = PassViews::Map, .onlyFavourites = true}));
    MainWindow again(clock, next);
    EXPECT_EQ(again.arrangement().passes, next.layout.passes);
    EXPECT_TRUE(findNamed<QToolButton>(again, "The path of the selected satellite over the Earth")->isChecked());
    EXPECT_TRUE(findNamed<QToolButton>(again, "Favourites only")->isChecked());
    next.layout.passes.view = 77;  // from a file that was edited by hand
    const MainWindow wrong(clock, next);
    EXPECT_EQ(wrong.arrangement().passes.view, PassViews::List);
}

// REQ-PASSES-957: Problems with the elements, including a download without a network, are shown above the passes of the
// good elements. Without problems this takes no room.
TEST_F(PassesPanelTest, TellsWhatIsWrongWithTheElements)
{
    StationStatus status = withSatellites();
    giveFound(status);
    EXPECT_EQ(text("Problems with the elements"), QString());
    const QString problem = QStringLiteral(
        "CelesTrak group stations: No network, or no server celestrak.org. Elements of 2026-11-26 "
        "14:02Z from the cache are used.");
    status.elementProblems = {problem};
    give(samples::update(status));
    EXPECT_EQ(text("Problems with the elements"), problem);
    EXPECT_GT(rows(), 0);
    status.elementProblems << QStringLiteral("/srv/a.tle:5: wrong");
    give(samples::update(status));
    EXPECT_EQ(text("Problems with the elements"), problem + QStringLiteral(" The log has more problems."));
}

// REQ-PASSES-951: The selected pass is shown with its path across the sky, its times, and the part hidden by the limits
// of the mount. Track asks the station to track this satellite. A new search keeps the selection.
TEST_F(PassesPanelTest, TrackAsksForTheSelectedSatellite)
{
    giveFound(withSatellites());
    const int row = 3;
    table().selectRow(row);
    const auto numberIn = [this](int of) {
        const auto& model = *qobject_cast<PassTable*>(table().model());
        return model.book()->elementsOf(model.pass(of)).number;
    };
    const std::int64_t number = numberIn(row);
    EXPECT_TRUE(text("The selected pass").contains(QString::number(number)));
    const StationStatus status = soonBefore(row);
    give(samples::update(status));
    QTest::mouseClick(named<CommandButton>("Track"), Qt::LeftButton);
    ASSERT_EQ(asked<request::Track>().size(), 1U);
    EXPECT_EQ(std::get<orbit::ElementSet>(asked<request::Track>().front().target.kind).number, number);

    StationUpdate refused = samples::update(status);
    refused.answers.push_back(
        {.requestId = requests.back().id, .error = Error{ErrorCode::Refused, QStringLiteral("It rises later.")}});
    give(refused);
    const auto isShown = [this] {
        return std::ranges::any_of(window.findChildren<ValueLabel*>(), [](const ValueLabel* label) {
            return label->isVisible() && label->text().endsWith(QStringLiteral("It rises later."));
        });
    };
    EXPECT_TRUE(isShown());
    int other = 0;  // the passes that are over are no longer listed
    while (numberIn(other) == number) {
        ++other;
    }
    table().selectRow(other);
    give(samples::update(status));
    EXPECT_FALSE(isShown()) << "it was about another satellite";
}

// Story: at 1024×700 with an alarm only one pass was visible.
// REQ-PASSES-979: In a low window the table of the passes has the room: the facts of the selected pass are reduced to
// those that the table does not show. The age of the elements stays on the page.
TEST_F(PassesPanelTest, TheFactsFoldWhereTheWindowIsLow)
{
    giveFound(withSatellites());
    EXPECT_LE(text("The selected pass").count(QLatin1Char('\n')), 3);
    EXPECT_THAT(text("The selected pass").toStdString(), HasSubstr("\nelements 0.0 d old: error 0."));
    EXPECT_FALSE(named<ValueLabel>("The selected pass")->isElided());
    EXPECT_TRUE(text("The selected pass").startsWith(QStringLiteral("number ")));
    EXPECT_GE(table().viewport()->height(), 3 * table().rowHeight(0));
    window.resize(1280, 1000);
    settle();
    EXPECT_TRUE(text("The selected pass").contains(QStringLiteral("days old")));
}

// Story: with a problem of the elements, Track was out of sight after the window had become lower.
// REQ-PASSES-979
TEST_F(PassesPanelTest, TheButtonsStayInSightAtEachHeight)
{
    StationStatus status = withSatellites();
    giveFound(status);
    window.setUpdatesEnabled(false);  // only the layout is judged
    const auto* const around = window.findChild<PassesPanel*>()->parentWidget()->parentWidget();
    const auto& scroll = dynamic_cast<const QScrollArea&>(*around);
    for (const bool hasProblem : {false, true}) {
        status.elementProblems =
            hasProblem ? QStringList(QStringLiteral("/srv/a.tle:4: wrong ").repeated(9)) : QStringList();
        give(samples::update(status));
        for (const auto view : {PassViews::List, PassViews::Timeline, PassViews::Elevation, PassViews::Map}) {
            window.findChild<PassViews*>()->showView(view);
            for (int height = 1100; height >= 700; height -= 20) {
                window.resize(1280, height);
                settle();
                EXPECT_EQ(scroll.verticalScrollBar()->maximum(), 0) << view << hasProblem << height;
            }
            window.resize(1280, 1100);
            settle();
        }
    }
}

TEST_F(PassesPanelTest, TellsWhatTheLimitsHide)
{
    targets::SkyWay way;
    const QObject here;  // the window is destroyed after it
    QObject::connect(window.findChild<PassesPanel*>(), &PassesPanel::wayChosen, &here,
                     [&way](const targets::SkyWay& chosen) { way = chosen; });
    StationStatus status = withSatellites();
    profile::Profile profile = *status.profile;
    profile.limits.horizon = {{0_deg, 20_deg}, {180_deg, 20_deg}};
    status.profile = std::make_shared<const profile::Profile>(profile);
    giveFound(status);
    const auto& model = *qobject_cast<PassTable*>(table().model());
    const auto number = model.book()->elementsOf(model.pass(table().currentIndex().row())).number;
    profile.satellites = {{.number = static_cast<int>(number), .note = "145.800 MHz"}};
    status.profile = std::make_shared<const profile::Profile>(profile);
    give(samples::update(status));
    EXPECT_EQ(text("The selected pass").count(QLatin1Char('\n')), 3) << "note, limits, age and light fit four lines";
    EXPECT_TRUE(text("The selected pass").contains(QStringLiteral("hidden for ")))
        << text("The selected pass").toStdString();
    ASSERT_TRUE(way);
    EXPECT_GT(way->size(), 100U);
    for (const targets::SkyMoment& moment : *way) {
        const double above = moment.direction.elevation.degrees() - 20.0;
        EXPECT_TRUE(std::abs(above) < 0.5 || moment.isHidden == (above < 0.0)) << above;
    }
}

// REQ-PASSES-999: The facts of the selected pass have the times of each part that the antenna sees.
TEST_F(PassesPanelTest, TellsWhenTheAntennaSeesThePass)
{
    giveFound(withSatellites());
    const auto& model = *qobject_cast<PassTable*>(table().model());
    BookedPass one = model.pass(0);
    const UtcTime aos = one.pass.aos.utc;
    const auto part = [aos](int from, int to) {
        return passes::Stretch{aos + std::chrono::seconds(from), aos + std::chrono::seconds(to)};
    };
    one.pass.clear = {part(0, 60), part(120, 180)};
    const QString seen =
        QStringLiteral("\nseen %1–%2, %3–%4 UTC\n")
            .arg(clockText(aos), clockText(aos + std::chrono::seconds(60)), clockText(aos + std::chrono::seconds(120)),
                 clockText(aos + std::chrono::seconds(180)));
    EXPECT_THAT(factsOf(one, *model.book(), aos).toStdString(), HasSubstr(seen.toStdString()));
    one.pass.clear = {{one.pass.aos.utc, one.pass.los.utc}};
    EXPECT_FALSE(factsOf(one, *model.book(), aos).contains(QStringLiteral("seen")));
    one.pass.clear = {};
    EXPECT_FALSE(factsOf(one, *model.book(), aos).contains(QStringLiteral("seen")));
}

// REQ-PASSES-952: The plot shows the path of the selected pass while the page Coming is open.
TEST_F(PassesPanelTest, ThePlotShowsTheWayOfTheSelectedPass)
{
    const StationStatus status = withSatellites();
    giveFound(status);
    const SkyPath& chosen = window.findChild<PolarPlot*>()->markers().chosen();
    const auto& model = *qobject_cast<PassTable*>(table().model());
    for (const int row : {0, 5}) {
        table().selectRow(row);
        give(samples::update(status));
        ASSERT_EQ(chosen.ends().size(), 2U);
        EXPECT_EQ(chosen.ends().front().time, clockText(model.pass(row).pass.aos.utc).chopped(3));
        EXPECT_EQ(chosen.ends().back().time, clockText(model.pass(row).pass.los.utc).chopped(3));
    }
    openPanel('1');
    give(samples::update(status));
    EXPECT_TRUE(chosen.ends().empty());
    openPanel('T');
    give(samples::update(status));
    EXPECT_EQ(chosen.ends().size(), 2U);
}

TEST_F(PassesPanelTest, APassThatIsOverLeavesTheTable)
{
    StationStatus status = withSatellites();
    giveFound(status);
    const int before = rows();
    const auto& model = *qobject_cast<PassTable*>(table().model());
    const UtcTime sets = model.pass(0).pass.los.utc;
    status.utc = sets - std::chrono::seconds(1);
    give(samples::update(status));
    EXPECT_EQ(cell(0, PassTable::Until), QStringLiteral("up"));
    status.utc = sets + std::chrono::seconds(1);
    give(samples::update(status));
    EXPECT_LT(rows(), before);
    EXPECT_GT(model.pass(0).pass.los.utc, status.utc);
}

// Story: Track was offered for a pass in three hours, and the station refused it.
// REQ-PASSES-968: Track is enabled for a pass exactly when the station accepts it. Otherwise the tooltip has the reason
// of the station: a rise in more than half an hour, elements that are too old, elements that are gone.
TEST_F(PassesPanelTest, TrackIsOfferedByTheRulesOfTheStation)
{
    StationStatus status = withSatellites();
    giveFound(status);
    const auto& model = *qobject_cast<PassTable*>(table().model());
    auto* const track = named<CommandButton>("Track");
    int blocked = 0;
    for (int row = 0; row < rows(); ++row) {
        table().selectRow(row);
        give(samples::update(status));
        const BookedPass& pass = model.pass(row);
        const QString name = targets::satelliteName(model.book()->elementsOf(pass));
        const Result<> may = targets::isSoon(name, pass.pass.aos.utc, status.utc);
        EXPECT_EQ(track->isEnabled(), may.has_value()) << row;
        EXPECT_TRUE(may || track->toolTip() == QStringLiteral("Track: ") + may.error().text);
        blocked += may ? 0 : 1;
    }
    EXPECT_GT(blocked, 0);

    status = soonBefore(table().currentIndex().row());
    give(samples::update(status));
    EXPECT_TRUE(track->isEnabled());
    profile::Profile strict = *status.profile;
    strict.orbit.oldestDays = 0.01;
    status.profile = std::make_shared<const profile::Profile>(strict);
    give(samples::update(status));
    EXPECT_FALSE(track->isEnabled());
    EXPECT_TRUE(track->toolTip().endsWith(QStringLiteral("Load newer elements."))) << track->toolTip().toStdString();
}

// REQ-PASSES-989: When the selected pass is over, the next pass of the same satellite is selected. So Track never
// changes to another satellite by itself.
TEST_F(PassesPanelTest, TheSelectionStaysWithItsSatellite)
{
    StationStatus status = withSatellites();
    giveFound(status);
    const auto& model = *qobject_cast<PassTable*>(table().model());
    const auto numberAt = [&](int row) { return model.book()->elementsOf(model.pass(row)).number; };
    int row = 0;
    while (numberAt(row + 1) == numberAt(row)) {
        ++row;  // otherwise another row would prove nothing
    }
    const std::int64_t number = numberAt(row);
    table().selectRow(row);
    status.utc = model.pass(row).pass.los.utc + std::chrono::seconds(1);
    give(samples::update(status));
    ASSERT_TRUE(table().currentIndex().isValid());
    EXPECT_EQ(numberAt(table().currentIndex().row()), number);
    EXPECT_GT(model.pass(table().currentIndex().row()).pass.los.utc, status.utc);
    give(samples::update(soonBefore(table().currentIndex().row())));
    QTest::mouseClick(named<CommandButton>("Track"), Qt::LeftButton);
    ASSERT_EQ(asked<request::Track>().size(), 1U);
    EXPECT_EQ(std::get<orbit::ElementSet>(asked<request::Track>().back().target.kind).number, number);
}

// REQ-SCHEDULE-953: The satellite of the selected pass can be added to the watched satellites of the profile, and
// removed again.
TEST_F(PassesPanelTest, AddsTheSatelliteToTheScheduleAndRemovesIt)
{
    StationStatus status = withSatellites();
    giveFound(status);
    auto* const watch = named<CommandButton>("Add to schedule");
    QTest::mouseClick(watch, Qt::LeftButton);
    ASSERT_EQ(asked<request::ApplyProfile>().size(), 1U);
    const profile::Profile watching = asked<request::ApplyProfile>().back().profile;
    ASSERT_EQ(watching.schedule.watch.size(), 1U);
    EXPECT_EQ(watching.schedule.watch.front().leastElevation, 10_deg);
    status.profile = std::make_shared<const profile::Profile>(watching);
    StationUpdate applied = samples::update(status);
    applied.answers.push_back({.requestId = requests.back().id});
    give(applied);
    EXPECT_EQ(watch->text().toStdString(), "Remove from schedule");
    QTest::mouseClick(watch, Qt::LeftButton);
    ASSERT_EQ(asked<request::ApplyProfile>().size(), 2U);
    EXPECT_TRUE(asked<request::ApplyProfile>().back().profile.schedule.watch.empty());
}

TEST(PassWords, LightIsOneLine)
{
    const UtcTime first = std::chrono::sys_days{std::chrono::year{2026} / 3 / 20} + std::chrono::hours(17) +
                          std::chrono::minutes(5) + std::chrono::seconds(59);
    const auto line = [](bool sunlit, std::vector<UtcTime> changes) {
        return lightText({.isSunlitFirst = sunlit, .changes = std::move(changes)}).toStdString();
    };
    EXPECT_EQ(line(true, {}), "in sunlight");
    EXPECT_EQ(line(false, {}), "in the shadow of the Earth");
    EXPECT_EQ(line(true, {first}), "enters the shadow 17:05:59Z");
    EXPECT_EQ(line(false, {first}), "leaves the shadow 17:05:59Z");
    EXPECT_EQ(line(true, {first, first + std::chrono::minutes(30)}), "in the shadow 17:05:59Z to 17:35:59Z");
    EXPECT_EQ(line(false, {first, first + std::chrono::minutes(30)}), "in sunlight 17:05:59Z to 17:35:59Z");
}

}  // namespace
}  // namespace boresight::ui
