// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/passes/targets_page.h"

#include "core/tables/atomic_time.h"
#include "core/targets/track_rules.h"
#include "tests/fakes/low_orbit.h"
#include "tests/ui/window_fixture.h"
#include "ui/kit/command_button.h"
#include "ui/kit/format.h"
#include "ui/passes/target_table.h"

#include <QFileDialog>
#include <QLineEdit>
#include <QTabWidget>
#include <QTableView>

#include <gmock/gmock.h>

#include <algorithm>

namespace boresight::ui {
namespace {

class TargetsPageTest : public WindowFixture
{
protected:
    TargetsPageTest()
    {
        openPanel('T');
        named<QTabWidget>("Passes of satellites")->setCurrentIndex(2);
    }

    static StationStatus atSite()
    {
        StationStatus status = samples::idle();
        status.permissions = Permissions::all();
        profile::Profile profile = *status.profile;
        profile.site = {.known = true, .latitude = 38.757_deg, .longitude = -9.117_deg, .heightMetres = 80.0};
        status.profile = std::make_shared<const profile::Profile>(profile);
        status.satellites = std::make_shared<const std::vector<orbit::ElementSet>>();
        return status;
    }
    void show(const StationStatus& status) { give(samples::update(status)); }
    QTableView& table() { return *named<QTableView>("Targets in the sky"); }
    QString cell(int row, TargetTable::Column column) { return table().model()->index(row, column).data().toString(); }
    // Whether some label of the window begins with this text.
    [[nodiscard]] bool isTold(const QString& text)
    {
        const QList<ValueLabel*> labels = window.findChildren<ValueLabel*>();
        return std::ranges::any_of(labels, [&](const ValueLabel* label) { return label->text().startsWith(text); });
    }
    [[nodiscard]] QString trackedLast() { return asked<request::Track>().back().target.name; }
};

// REQ-TARGETS-950: Sun, Moon, planets and radio sources are listed with their present direction at the site and the
// time of their next rise or set. The selected one can be tracked. Without a site only their names are shown.
TEST_F(TargetsPageTest, ListsWhereEachStandsAndTracksTheSelectedOne)
{
    StationStatus status = atSite();
    show(status);
    ASSERT_EQ(table().model()->rowCount(), 14);
    targets::TargetPath path(targets::objectTargets()[1], {38.757_deg, -9.117_deg, 80.0});
    EXPECT_NEAR(cell(1, TargetTable::Azimuth).chopped(1).toDouble(), path.at(status.utc)->azimuth.degrees(), 0.06);
    for (int row = 0; row < 14; ++row) {
        const bool isUp = !cell(row, TargetTable::Elevation).startsWith(QLatin1Char('-'));
        const QString next = cell(row, TargetTable::Next);
        EXPECT_TRUE(next.startsWith(isUp ? QStringLiteral("sets") : QStringLiteral("rises")) ||
                    next == (isUp ? QStringLiteral("up all day") : QStringLiteral("not up within a day")))
            << next.toStdString();
    }
    int row = 1;
    while (!cell(row, TargetTable::Next).startsWith(QStringLiteral("sets"))) {
        ++row;
    }
    table().selectRow(row);
    show(status);
    QTest::mouseClick(named<CommandButton>("Track selected"), Qt::LeftButton);
    EXPECT_EQ(trackedLast(), cell(row, TargetTable::Name));

    profile::Profile nowhere = *status.profile;
    nowhere.site.known = false;
    status.profile = std::make_shared<const profile::Profile>(nowhere);
    show(status);
    EXPECT_EQ(cell(1, TargetTable::Azimuth), QString());
    EXPECT_FALSE(named<CommandButton>("Track selected")->isEnabled());
}

// REQ-TARGETS-960: The list shows the apparent direction of a target and its rise by the refraction rule of the
// profile.
TEST_F(TargetsPageTest, GoesByTheRuleForRefraction)
{
    using ephemeris::RefractionRule;
    StationStatus status = atSite();
    targets::TargetPath path(targets::objectTargets()[0], {38.757_deg, -9.117_deg, 80.0});
    const UtcTime set = path.nextUp(status.utc + std::chrono::hours(24)).value().sets.value();
    status.utc = path.nextUp(set + std::chrono::minutes(1)).value().rises + std::chrono::seconds(10);
    show(status);
    EXPECT_TRUE(cell(0, TargetTable::Next).startsWith(QStringLiteral("sets")));
    EXPECT_NEAR(cell(0, TargetTable::Elevation).chopped(1).toDouble(), 0.0, 0.11);

    profile::Profile airless = *status.profile;
    airless.orbit.refraction = RefractionRule::None;
    status.profile = std::make_shared<const profile::Profile>(airless);
    status.utc += std::chrono::seconds(1);
    show(status);
    path.setRule(RefractionRule::None);
    EXPECT_LT(cell(0, TargetTable::Elevation).chopped(1).toDouble(), -0.3);
    EXPECT_NEAR(cell(0, TargetTable::Elevation).chopped(1).toDouble(), path.at(status.utc)->elevation.degrees(), 0.06);
    EXPECT_TRUE(cell(0, TargetTable::Next).startsWith(QStringLiteral("rises")));
}

// Story: the Moon of the list set four minutes after the Moon of WSJT-X, and an operator thought that it was wrong.
// REQ-TARGETS-961: The list shows the refraction with which each target rises and sets. The mount tracks with the same
// refraction. The tooltip has the time without refraction.
TEST_F(TargetsPageTest, SaysByWhichRefractionATargetRisesAndSets)
{
    using ephemeris::RefractionRule;
    constexpr int kMoon = 1;
    const targets::Target moon = targets::objectTargets()[kMoon];
    const Site site{38.757_deg, -9.117_deg, 80.0};
    StationStatus status = atSite();
    targets::TargetPath path(moon, site);
    status.utc = path.nextUp(status.utc).value().sets.value() - std::chrono::hours(1);
    const UtcTime sets = path.nextUp(status.utc).value().sets.value();
    show(status);
    EXPECT_EQ(cell(kMoon, TargetTable::Refraction), QStringLiteral("optical"));
    EXPECT_EQ(cell(13, TargetTable::Refraction), QStringLiteral("radio")) << cell(13, TargetTable::Name).toStdString();
    EXPECT_TRUE(cell(kMoon, TargetTable::Next).startsWith(QStringLiteral("sets ") + clockText(sets)));

    path.setRule(RefractionRule::None);
    const UtcTime geometric = path.nextUp(status.utc).value().sets.value();
    EXPECT_GT(sets - geometric, std::chrono::minutes(2));
    const auto help = [&] { return table().model()->index(kMoon, TargetTable::Next).data(Qt::ToolTipRole).toString(); };
    EXPECT_EQ(help(), QStringLiteral("The mount tracks with optical refraction.\nWithout refraction (as in WSJT-X) the "
                                     "target sets at %1Z.")
                          .arg(clockText(geometric)));

    profile::Profile airless = *status.profile;
    airless.orbit.refraction = RefractionRule::None;
    status.profile = std::make_shared<const profile::Profile>(airless);
    status.utc += std::chrono::seconds(1);
    show(status);
    EXPECT_EQ(cell(kMoon, TargetTable::Refraction), QStringLiteral("off"));
    EXPECT_TRUE(cell(kMoon, TargetTable::Next).startsWith(QStringLiteral("sets ") + clockText(geometric)));
    EXPECT_EQ(help(), QStringLiteral("Without refraction, as in WSJT-X."));
}

// REQ-TARGETS-962: Track is not enabled for a target that the station would refuse. The tooltip has the reason of the
// station: the profile keeps the beam away from the Sun, or the target rises in more than half an hour.
TEST_F(TargetsPageTest, OffersOnlyWhatTheStationTracks)
{
    StationStatus status = atSite();
    show(status);
    auto* const track = named<CommandButton>("Track selected");
    for (int row = 0; row < table().model()->rowCount(); ++row) {
        table().selectRow(row);
        show(status);
        const targets::Target target = targets::objectTargets()[std::size_t(row)];
        targets::TargetPath path(target, {38.757_deg, -9.117_deg, 80.0});
        const auto up = path.nextUp(status.utc);
        const Result<> may = up ? targets::isSoon(target.name, up->rises, status.utc) : Result<>{};
        const QString why = !up ? up.error().text : may ? QString() : may.error().text;
        EXPECT_EQ(track->isEnabled(), why.isEmpty()) << target.name.toStdString();
        EXPECT_TRUE(why.isEmpty() || track->toolTip().endsWith(why)) << track->toolTip().toStdString();
    }
    table().selectRow(0);
    status.permissions.refuse(Action::TrackSun, QStringLiteral("the profile keeps the beam away from the Sun."));
    show(status);
    EXPECT_FALSE(track->isEnabled());
    EXPECT_TRUE(track->toolTip().endsWith(QStringLiteral("keeps the beam away from the Sun.")));
}

// Story: a typed target was judged only after Track was pressed.
// REQ-TARGETS-963: Track is offered for a typed target only while the station tracks it. Else the tooltip has the
// reason: the text, the site, the age of the elements, a rise that is far off or does not come, the Sun, or a place
// that the mount does not reach. Enter shows the same reason.
TEST_F(TargetsPageTest, OffersOnlyATypedTargetThatTheStationTracks)
{
    StationStatus status = atSite();
    orbit::ElementSet old = fakes::lowOrbit(status.utc - std::chrono::hours(24 * 90));
    old.name = "OLDSAT";
    status.satellites = std::make_shared<const std::vector<orbit::ElementSet>>(std::vector{old});
    status.permissions.refuse(Action::TrackSun, QStringLiteral("the profile keeps the beam away from the Sun."));
    judge = [](const SkyPointing& direction) {
        return DirectionVerdict{.whyNot = direction.azimuth == 120_deg ? QStringLiteral("the mast") : QString()};
    };
    auto* const typed = named<QLineEdit>("Another target");
    auto* const track = named<CommandButton>("Track");
    const auto whyNot = [&](const char* target) {
        typed->setText(QLatin1String(target));
        show(status);  // asks the station
        show(status);  // its answer
        EXPECT_EQ(track->isEnabled(), track->obstacle().isEmpty());
        return track->obstacle().toStdString();
    };
    EXPECT_EQ(whyNot(""), "Type a target first.");
    EXPECT_THAT(whyNot("nonsense"), testing::StartsWith("\"nonsense\" is not a known satellite"));
    EXPECT_THAT(whyNot("oldsat"), testing::StartsWith("The elements of OLDSAT are 90.0 days old."));
    EXPECT_EQ(whyNot("sun"), "the profile keeps the beam away from the Sun.");
    EXPECT_THAT(whyNot("radec 12,-80"), testing::EndsWith("does not rise within a day."));
    EXPECT_EQ(whyNot("azel 120,30"), "forbidden: the mast");
    QTest::keyClick(typed, Qt::Key_Return);
    EXPECT_TRUE(isTold(QStringLiteral("forbidden: the mast")));
    EXPECT_TRUE(requests.empty());
    EXPECT_EQ(whyNot("azel 121,30"), "");
    EXPECT_EQ(whyNot("IM58kr"), "");
    EXPECT_EQ(whyNot("radec 12,80"), "") << "it never sets";
    EXPECT_EQ(whyNot("rotctld:10.0.0.7:4533"), "") << "the station asks the other rotator";

    profile::Profile nowhere = *status.profile;
    nowhere.site.known = false;
    status.profile = std::make_shared<const profile::Profile>(nowhere);
    EXPECT_THAT(whyNot("IM58kr"), testing::StartsWith("The site of the mount is not set."));
    EXPECT_EQ(whyNot("azel 121,30"), "") << "it needs no site";
    status.permissions.refuse(Action::Track, QStringLiteral("STOP is latched."));
    EXPECT_EQ(whyNot("azel 121,30"), "STOP is latched.");
}

// REQ-TARGETS-951: A typed target is tracked, with the same words as for boresightctl track. An invalid text is refused
// with the reason, and no request is sent.
TEST_F(TargetsPageTest, TracksWhatIsTyped)
{
    show(atSite());
    auto* const typed = named<QLineEdit>("Another target");
    QTest::keyClicks(typed, QStringLiteral("IM58kr long"));
    show(atSite());
    QTest::keyClick(typed, Qt::Key_Return);
    ASSERT_EQ(asked<request::Track>().size(), 1U);
    EXPECT_EQ(trackedLast(), QStringLiteral("IM58kr, long path"));

    typed->clear();
    QTest::keyClicks(typed, QStringLiteral("nonsense"));
    QTest::keyClick(typed, Qt::Key_Return);
    EXPECT_EQ(asked<request::Track>().size(), 1U);
    EXPECT_TRUE(isTold(QStringLiteral("\"nonsense\" is not a known satellite")));
}

// A window whose question about a file is answered as a test says.
class TableOfAFileTest : public TargetsPageTest
{
protected:
    TableOfAFileTest()
    {
        QObject::connect(
            &window.host(), &HostDesk::tableWanted, &window,
            [this](const QString& path, const SharedTableContent&) { wanted.push_back(path.toStdString()); });
        show(status);
    }

    // Two rows, at these times after the present status.
    [[nodiscard]] targets::Target rows(std::chrono::minutes first, std::chrono::minutes last) const
    {
        const tables::AtomicTime from = tables::atomicTime(status.utc + first);
        const tables::AtomicTime to = tables::atomicTime(status.utc + last);
        const tables::DirectionRows both{{.time = from, .direction = {100_deg, 20_deg}},
                                         {.time = to, .direction = {110_deg, 20_deg}}};
        return targets::tableTarget(std::make_shared<const tables::Table>(
            tables::Table{.name = QStringLiteral("way.csv"), .rows = both, .spans = {{.from = from, .to = to}}}));
    }
    void answer(const Result<targets::Target>& table)
    {
        Q_EMIT window.host().tableRead(std::make_shared<const TableContent>(
            TableContent{.path = QStringLiteral("/tmp/way.csv"), .state = {}, .table = table}));
    }
    void elapseShown(std::chrono::milliseconds time)
    {
        status.utc += time;
        show(status);
    }
    // Types the path. The window has asked for the file.
    void type()
    {
        field().clear();
        QTest::keyClicks(&field(), QStringLiteral("table /tmp/way.csv"));
        show(status);
        elapseShown(std::chrono::seconds(1));
    }
    QLineEdit& field() { return *named<QLineEdit>("Another target"); }
    CommandButton& track() { return *named<CommandButton>("Track"); }
    [[nodiscard]] std::string whyNot() { return track().obstacle().toStdString(); }

    StationStatus status = atSite();
    std::vector<std::string> wanted;  // files
};

// REQ-TARGETS-952: The table of a file is chosen by a button, or typed by its path. Track sends its path to the
// station. To choose a file moves nothing. The field also accepts another rotator to follow.
TEST_F(TableOfAFileTest, IsChosenThenTracked)
{
    QTest::mouseClick(named<QPushButton>("Choose file …"), Qt::LeftButton);
    auto* const dialog = window.findChild<QFileDialog*>();
    ASSERT_NE(dialog, nullptr);
    EXPECT_FALSE(dialog->isModal()) << "STOP stays in reach";
    Q_EMIT dialog->fileSelected(QStringLiteral("/tmp/way.csv"));
    EXPECT_EQ(field().text(), QStringLiteral("table /tmp/way.csv"));
    elapseShown(std::chrono::seconds(1));
    EXPECT_EQ(wanted, std::vector<std::string>{"/tmp/way.csv"});
    EXPECT_FALSE(track().isEnabled());
    answer(rows(std::chrono::minutes(0), std::chrono::minutes(5)));
    show(status);
    EXPECT_TRUE(requests.empty());
    QTest::mouseClick(&track(), Qt::LeftButton);
    ASSERT_EQ(asked<request::TrackFile>().size(), 1U);
    EXPECT_EQ(asked<request::TrackFile>().back().path, QStringLiteral("/tmp/way.csv"));
}

// Story: a table that was over, or had a mistake, was refused only after Track was pressed.
// REQ-TARGETS-964: Track is offered for the table of a file only while the station would track it. The file is read
// beside the window. The reason is beside the field: the file and the line of a mistake, a path that is over or far
// off, a site that is missing. It does not replace what the station refused.
TEST_F(TableOfAFileTest, IsOfferedOnlyIfTheStationTracksIt)
{
    type();
    EXPECT_EQ(whyNot(), "Boresight is reading the file. Wait a moment.");
    EXPECT_TRUE(isTold(QStringLiteral("Boresight is reading the file.")));
    const QString mistake = QStringLiteral("/tmp/way.csv:2: The elevation is 200°.");
    answer(failure(ErrorCode::InvalidInput, mistake));
    EXPECT_EQ(whyNot(), mistake.toStdString());
    EXPECT_TRUE(isTold(mistake));
    EXPECT_FALSE(track().isEnabled());
    QTest::keyClick(&field(), Qt::Key_Return);
    EXPECT_TRUE(requests.empty());

    answer(rows(std::chrono::minutes(-9), std::chrono::minutes(-1)));
    EXPECT_THAT(whyNot(), testing::StartsWith("The table of way.csv ended at "));
    answer(rows(std::chrono::minutes(90), std::chrono::minutes(95)));
    EXPECT_THAT(whyNot(), testing::StartsWith("way.csv rises at "));
    answer(rows(std::chrono::minutes(-1), std::chrono::minutes(3)));
    EXPECT_EQ(whyNot(), "");
    EXPECT_FALSE(isTold(QStringLiteral("way.csv rises at ")));
    elapseShown(std::chrono::minutes(4));
    EXPECT_THAT(whyNot(), testing::StartsWith("The table of way.csv ended at ")) << "while the text stands";
    EXPECT_TRUE(isTold(QStringLiteral("The table of way.csv ended at ")));

    profile::Profile nowhere = *status.profile;
    nowhere.site.known = false;
    status.profile = std::make_shared<const profile::Profile>(nowhere);
    show(status);
    answer(targets::tableTarget(std::make_shared<const tables::Table>(
        tables::Table{.name = QStringLiteral("probe"), .rows = tables::OrbitSegments(1), .spans = {{}}})));
    EXPECT_THAT(whyNot(), testing::StartsWith("The site of the mount is not set."));
    answer(rows(std::chrono::minutes(0), std::chrono::minutes(3)));
    EXPECT_EQ(whyNot(), "") << "a table of directions needs no site";
    status.permissions.refuse(Action::Track, QStringLiteral("STOP is latched."));
    show(status);
    EXPECT_EQ(whyNot(), "STOP is latched.");
}

// Story: each change of the file erased what the station had refused.
// REQ-TARGETS-964
TEST_F(TableOfAFileTest, ItsReasonKeepsTheRefusalOfAnotherTarget)
{
    type();
    answer(failure(ErrorCode::InvalidInput, QStringLiteral("/tmp/way.csv:2: The elevation is 200°.")));
    QTest::mouseClick(named<CommandButton>("Track selected"), Qt::LeftButton);
    ASSERT_EQ(asked<request::Track>().size(), 1U);
    StationUpdate refused = samples::update(status);
    refused.answers.push_back({.requestId = requests.back().id,
                               .error = Error{ErrorCode::Refused, QStringLiteral("It is behind the mast.")}});
    give(refused);
    const QString refusal = QStringLiteral("Track selected: It is behind the mast.");
    ASSERT_TRUE(isTold(refusal));
    answer(failure(ErrorCode::InvalidInput, QStringLiteral("/tmp/way.csv:3: The elevation is 300°.")));
    EXPECT_TRUE(isTold(refusal));
    answer(rows(std::chrono::minutes(0), std::chrono::minutes(3)));
    EXPECT_TRUE(isTold(refusal));
}

// REQ-TARGETS-967
TEST_F(TableOfAFileTest, TheStationDecidesWhenItIsNotRead)
{
    type();
    elapseShown(kLongestTableReading);
    EXPECT_TRUE(isTold(QStringLiteral("/tmp/way.csv was not read within 30 s.")));
    QTest::mouseClick(&track(), Qt::LeftButton);
    EXPECT_EQ(asked<request::TrackFile>().size(), 1U);
}

// Also where an earlier answer would not have been tracked.
// REQ-TARGETS-967
TEST_F(TableOfAFileTest, AnEarlierTableDoesNotCountWhenItIsNotReadAgain)
{
    type();
    answer(rows(std::chrono::minutes(-9), std::chrono::minutes(-1)));
    elapseShown(std::chrono::seconds(2));
    EXPECT_NE(whyNot(), "");
    elapseShown(kLongestTableReading);
    EXPECT_EQ(whyNot(), "");
}

// REQ-TARGETS-964
TEST_F(TableOfAFileTest, AnotherTextEndsItsReason)
{
    type();
    answer(failure(ErrorCode::NoDevice, QStringLiteral("/tmp/way.csv: There is no such file.")));
    ASSERT_TRUE(isTold(QStringLiteral("/tmp/way.csv: There is no such file.")));
    field().clear();
    QTest::keyClicks(&field(), QStringLiteral("moon"));
    show(status);
    EXPECT_FALSE(isTold(QStringLiteral("/tmp/way.csv")));
    answer(rows(std::chrono::minutes(0), std::chrono::minutes(3)));
    show(status);
    EXPECT_TRUE(track().obstacle().isEmpty() || track().obstacle().contains(QStringLiteral("Moon")))
        << track().obstacle().toStdString();
}

// REQ-TARGETS-952
TEST_F(TargetsPageTest, FollowsAnotherRotator)
{
    QTest::keyClicks(named<QLineEdit>("Another target"), QStringLiteral(" rotctld:10.0.0.7:4533"));
    show(atSite());
    QTest::keyClick(named<QLineEdit>("Another target"), Qt::Key_Return);
    ASSERT_EQ(asked<request::FollowRotator>().size(), 1U);
    EXPECT_EQ(asked<request::FollowRotator>().back().name, QStringLiteral("rotctld:10.0.0.7:4533"));
}

}  // namespace
}  // namespace boresight::ui
