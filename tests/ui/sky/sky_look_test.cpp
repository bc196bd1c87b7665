// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/units/angle_between.h"
#include "tests/ui/event_loop.h"
#include "tests/ui/sample_status.h"
#include "ui/budget/budget_card.h"
#include "ui/budget/off_button.h"
#include "ui/kit/axes.h"
#include "ui/kit/value_label.h"
#include "ui/sky/cable_words.h"
#include "ui/sky/plot_editor.h"
#include "ui/sky/plot_tools.h"
#include "ui/sky/polar_plot.h"

#include <QAction>
#include <QApplication>
#include <QContextMenuEvent>
#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <QScreen>
#include <QTableView>
#include <QTest>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace boresight::ui {
namespace {

constexpr ThemeKind kEachTheme[] = {ThemeKind::Day, ThemeKind::Night, ThemeKind::Red};
constexpr int kSquares[] = {489, 660, 1000};  // discs of 440, 590 and 900 px

bool alike(const QColor& one, const QColor& other)
{
    return std::abs(one.red() - other.red()) <= 8 && std::abs(one.green() - other.green()) <= 8 &&
           std::abs(one.blue() - other.blue()) <= 8;
}

// A pass across a mast, with everything that the plot can show.
StationStatus everything()
{
    StationStatus status = samples::bounded();
    status.bodies = {{ephemeris::Body::Sun, {220_deg, 35_deg}}, {ephemeris::Body::Moon, {120_deg, 40_deg}}};
    status.sensor.direction = SkyPointing{22_deg, 44_deg};
    return status;
}

// From 20° to 250° on the same wrap: the long way, because the cable does not allow the short one.
StationStatus unwrapping()
{
    StationStatus status = everything();
    status.state = StationState::Slew;
    status.slew = SlewProgress{.remaining = Seconds(9.0), .done = 0.3};
    status.target = SkyPointing{250_deg, 30_deg};
    status.azimuth.target = 250_deg;
    status.azimuth.beam = {.actual = 20_deg, .commanded = 20_deg, .target = 250_deg};
    status.elevation.beam = {.actual = 45_deg, .commanded = 45_deg, .target = 30_deg};
    for (int i = 0; i <= 230; ++i) {
        status.route.push_back({Angle::fromDegrees(20.0 + i), Angle::fromDegrees(45.0 - 15.0 * i / 230.0)});
    }
    return status;
}

class SkyLook : public ::testing::Test
{
protected:
    SkyLook() : draft(desk), plot(draft, desk)
    {
        QObject::connect(&desk, &RequestDesk::requested, &desk,
                         [this](const NumberedRequest& request) { asked = request; });
        plot.resize(660, 660);
        plot.show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(&plot, kPatienceMs));
    }
    ~SkyLook() override { applyTheme(ThemeKind::Day); }

    void show(const StationStatus& status)
    {
        draft.showStatus(status);
        plot.showStatus(status);
    }
    static void paintIn(ThemeKind theme)
    {
        applyTheme(theme);
        QApplication::processEvents();  // widgets receive their palette by an event
    }
    QColor pixelAt(QPointF at) { return plot.grab().toImage().pixelColor(at.toPoint()); }
    QColor skyPixel(const SkyPointing& at) { return pixelAt(plot.markers().projection().toPixel(at)); }
    QString words(const char* name)
    {
        for (const ValueLabel* const label : plot.findChildren<ValueLabel*>()) {
            if (label->accessibleName() == QLatin1String(name)) {
                return label->text();
            }
        }
        return {};
    }
    QMenu* openedMenu() { return plot.findChild<QMenu*>(); }
    QAction* entry(const char* begin)
    {
        for (QAction* const action : openedMenu()->actions()) {
            if (action->text().startsWith(QString::fromUtf8(begin))) {
                return action;
            }
        }
        return nullptr;
    }
    void rightClick(const SkyPointing& at, const DirectionVerdict& verdict = {})
    {
        auto& markers = *plot.findChild<SkyMarkers*>();
        const QPoint place = markers.projection().toPixel(at).toPoint();
        QContextMenuEvent event(QContextMenuEvent::Mouse, place, markers.mapToGlobal(place));
        QApplication::sendEvent(&markers, &event);
        answer(verdict);
    }
    void answer(const DirectionVerdict& verdict = {})
    {
        EXPECT_TRUE(std::holds_alternative<request::JudgeDirection>(asked.request));
        desk.take({{.requestId = asked.id, .verdict = verdict}});
    }

    RequestDesk desk;
    NumberedRequest asked;
    ProfileDraft draft;
    PolarPlot plot;
};

// REQ-UI-700: The disc of the sky takes nine tenths of its square. Tools, distance, legend and cable are in the free
// corners and overlap neither the disc nor its ring and labels, for discs of 440 px and more.
TEST_F(SkyLook, TheDiscIsNineTenthsAndTheCornersAreFree)
{
    show(unwrapping());
    for (const int side : kSquares) {
        plot.resize(side, side);
        EXPECT_GE(2.0 * plot.frame().sky().radius, 0.9 * side - 0.5) << side;
        for (const QWidget* const one : plot.tools().corners()) {
            EXPECT_TRUE(plot.frame().isFree(one->geometry())) << side << one->accessibleName().toStdString();
            EXPECT_TRUE(plot.rect().contains(one->geometry())) << side;
        }
    }
    plot.resize(489, 489);
    EXPECT_GE(plot.frame().sky().radius, 220.0);
    plot.resize(660, 660);
    EXPECT_GE(plot.frame().sky().radius, 295.0);
}

TEST_F(SkyLook, WhatIsInACornerIsWhole)
{
    StationStatus status = everything();
    status.cableEnd = CableEnd{.end = 450_deg, .in = Seconds(27.0)};
    show(status);
    for (const QWidget* const one : plot.tools().corners()) {
        if (const auto* const label = qobject_cast<const ValueLabel*>(one)) {
            EXPECT_FALSE(label->isElided()) << label->text().toStdString();
        }
        EXPECT_FALSE(one->accessibleName().isEmpty());
    }
}

// REQ-UI-701: The plot shows the distance of the mount from its target, as an angle on the sky.
TEST_F(SkyLook, OffByIsAnAngleOnTheSky)
{
    StationStatus status = samples::bounded();
    status.actual = SkyPointing{20_deg, 60_deg};
    status.target = SkyPointing{22_deg, 60_deg};
    show(status);
    EXPECT_EQ(words("Off by"), QStringLiteral("1.00°"));  // 2° of azimuth at 60°
    show(samples::withAge(status, std::chrono::milliseconds(900)));
    EXPECT_EQ(words("Off by"), QString()) << "an old place is no error";
}

// REQ-UI-1802: The distance from the target is bold, and as large as the corner beside the sky permits.
TEST_F(SkyLook, OffByIsLarge)
{
    show(samples::tracking(200.0));
    const auto points = [this](int side) {
        plot.resize(side, side);
        for (const ValueLabel* const label : plot.findChildren<ValueLabel*>()) {
            if (label->accessibleName() == QLatin1String("Off by")) {
                EXPECT_TRUE(label->font().bold());
                EXPECT_FALSE(label->isElided());
                return label->font().pointSize();
            }
        }
        return 0;
    };
    EXPECT_GE(points(489), 16);
    EXPECT_GE(points(660), 22);
    EXPECT_EQ(points(1000), 26);
}

// REQ-UI-1803: A press on the distance opens the error budget as a list, with mouse or keyboard: each part with its
// error and where the number comes from, and the sum. It is not modal, and Esc closes it.
TEST_F(SkyLook, TheErrorBudgetOpensAsAList)
{
    show(samples::tracking(200.0));
    EXPECT_EQ(words("Total of the error budget"), QString::fromUtf8("total ≥0.23°"));
    auto* const button = plot.findChild<OffButton*>();
    auto* const card = plot.findChild<BudgetCard*>();
    ASSERT_TRUE(button->isVisible());
    EXPECT_FALSE(card->isVisible());
    EXPECT_TRUE(button->toolTip().contains(QString::fromUtf8("Servo: 0.031°. Measured: ")));
    EXPECT_TRUE(button->accessibleDescription().startsWith(QString::fromUtf8("Off by at least 0.23°")));
    button->setFocus();
    QTest::keyClick(button, Qt::Key_Space);
    ASSERT_TRUE(card->isVisible());
    EXPECT_FALSE(card->isModal());
    const QAbstractItemModel& parts = *card->findChild<QTableView*>()->model();
    ASSERT_EQ(parts.rowCount(), 7);
    const auto cell = [&parts](int row, int column) { return parts.index(row, column).data().toString(); };
    EXPECT_EQ(cell(0, 0), QStringLiteral("Servo"));
    EXPECT_EQ(cell(0, 1), QString::fromUtf8("0.031°"));
    EXPECT_EQ(cell(3, 1), QStringLiteral("unknown"));
    EXPECT_EQ(cell(6, 1), QStringLiteral("not in the sum"));
    for (int row = 0; row < parts.rowCount(); ++row) {
        EXPECT_FALSE(cell(row, 2).isEmpty()) << row;
    }
    QTest::keyClick(card, Qt::Key_Escape);
    EXPECT_FALSE(card->isVisible());
    QTest::mouseClick(button, Qt::LeftButton);
    EXPECT_TRUE(card->isVisible());
}

// REQ-UI-1804: An old position has no error budget. The open list says so, and the button is gone with the distance.
TEST_F(SkyLook, AnOldPositionHasNoErrorBudget)
{
    show(samples::tracking(200.0));
    plot.findChild<OffButton*>()->click();
    show(samples::withAge(samples::tracking(200.0), std::chrono::milliseconds(900)));
    EXPECT_EQ(words("Total of the error budget"), QString());
    EXPECT_FALSE(plot.findChild<OffButton*>()->isVisible());
    const auto* const card = plot.findChild<BudgetCard*>();
    EXPECT_EQ(card->findChild<QTableView*>()->model()->rowCount(), 0);
    EXPECT_TRUE(card->findChild<QLabel*>()->text().startsWith(QStringLiteral("There is no error budget")));
}

// REQ-UI-702: In every theme the colour of the sky changes from the rim to the zenith, and the land below the horizon
// is filled.
TEST_F(SkyLook, TheSkyHasATone)
{
    show(samples::bounded());
    for (const ThemeKind theme : kEachTheme) {
        paintIn(theme);
        EXPECT_TRUE(alike(skyPixel({135_deg, 88_deg}), currentTheme().skyZenith)) << int(theme);
        EXPECT_EQ(skyPixel({175_deg, 13_deg}), currentTheme().land) << int(theme);
        EXPECT_NE(currentTheme().land, currentTheme().skyRim);
    }
}

// REQ-UI-703: The azimuth cable is a ring around the sky, and a spiral if its travel exceeds 360°. It shows the used
// part, both ends, a warning zone before each, and the position of the axis.
TEST_F(SkyLook, TheCableIsASpiralWithItsUsedPart)
{
    StationStatus status = samples::bounded();  // travel -90° to 450°
    status.azimuth.actual = 335_deg;
    show(status);
    const CableRing ring(plot.frame(), status.azimuth.travel);
    EXPECT_TRUE(ring.isSpiral());
    for (const ThemeKind theme : kEachTheme) {
        paintIn(theme);
        const Theme& colours = currentTheme();
        EXPECT_TRUE(alike(pixelAt(ring.pixel(100_deg)), colours.accent)) << int(theme);
        EXPECT_TRUE(alike(pixelAt(ring.pixel(335_deg)), colours.accent)) << int(theme);
        EXPECT_TRUE(alike(pixelAt(ring.pixel(380_deg)), colours.grid)) << "a turn on from the used part";
        EXPECT_TRUE(alike(pixelAt(ring.pixel(-20_deg)), colours.grid));
        EXPECT_TRUE(alike(pixelAt(ring.pixel(-75_deg)), colours.warning));
        EXPECT_TRUE(alike(pixelAt(ring.pixel(435_deg)), colours.warning));
    }
    EXPECT_EQ(words("Azimuth cable"), QStringLiteral("cable 335°"));
    EXPECT_EQ(words("Travel of the azimuth cable"), QStringLiteral("travel -90…450°"));
}

// Story: after north was set the dot of the cable was at the axis angle, and the beam at another azimuth.
// REQ-UI-976: Once north is set the ring is turned along: the dot of the cable is beside the beam, and each end is
// where the beam points when the axis stands there.
TEST_F(SkyLook, TheCableIsTurnedWithNorth)
{
    StationStatus status = samples::bounded();  // travel -90° to 450°
    status.azimuth.actual = 100_deg;
    profile::Profile profile = *status.profile;
    profile.pointing.azimuthOffset = 40_deg;
    status.profile = std::make_shared<const profile::Profile>(profile);
    show(status);
    EXPECT_EQ(plot.markers().cable().zero, 40_deg);
    const CableRing untouched(plot.frame(), status.azimuth.travel);
    const CableRing ring(plot.frame(), status.azimuth.travel, 40_deg);
    const QPointF away = ring.pixel(100_deg) - plot.frame().sky().zenith;
    EXPECT_NEAR(std::atan2(away.x(), -away.y()), (140_deg).radians(), 1e-9);
    EXPECT_TRUE(alike(pixelAt(ring.pixel(80_deg)), currentTheme().accent));
    const auto warnsNear = [&](const CableRing& of, Angle angle) {  // the zone is striped
        return std::ranges::any_of(std::array{-2_deg, -1_deg, 0_deg, 1_deg, 2_deg}, [&](Angle beside) {
            return alike(pixelAt(of.pixel(angle + beside)), currentTheme().warning);
        });
    };
    EXPECT_TRUE(warnsNear(ring, -75_deg));
    EXPECT_FALSE(warnsNear(untouched, -75_deg));
}

// REQ-UI-703
TEST_F(SkyLook, TheCableIsAPlainRingWithoutOverlap)
{
    StationStatus status = samples::bounded();
    status.azimuth.travel = {0_deg, 360_deg};
    status.azimuth.actual = 90_deg;
    show(status);
    const CableRing ring(plot.frame(), status.azimuth.travel);
    EXPECT_FALSE(ring.isSpiral());
    const auto distance = [&](Angle angle) {
        const QPointF away = ring.pixel(angle) - plot.frame().sky().zenith;
        return std::hypot(away.x(), away.y());
    };
    EXPECT_NEAR(distance(10_deg), distance(350_deg), 1e-9);
    EXPECT_TRUE(alike(pixelAt(ring.pixel(60_deg)), currentTheme().accent));
    EXPECT_TRUE(alike(pixelAt(ring.pixel(200_deg)), currentTheme().grid));
}

// REQ-UI-704: While the wrap of the azimuth is unknown the ring shows no used part, and the words say so. A screen
// reader gets the cable in sentences.
TEST_F(SkyLook, AnUnknownWrapShowsNoUsedPart)
{
    StationStatus status = samples::asking(Axis::Azimuth, 3, 360_deg / 2.0, false);
    show(status);
    EXPECT_FALSE(plot.markers().cable().actual);
    EXPECT_EQ(words("Azimuth cable"), QStringLiteral("cable ---°"));
    EXPECT_EQ(words("Travel of the azimuth cable"), QStringLiteral("wrap unknown"));
    EXPECT_TRUE(cableWords(status).isWarning);
    plot.describe(status);
    EXPECT_TRUE(plot.accessibleDescription().contains(QStringLiteral("The cable wrap is unknown.")));
    status = samples::bounded();
    status.azimuth.actual = 397_deg;
    status.cableEnd = CableEnd{.end = 450_deg, .in = Seconds(27.0)};
    show(status);
    EXPECT_EQ(words("Travel of the azimuth cable"), QStringLiteral("end in 53°, 27 s"));
    plot.describe(status);
    EXPECT_TRUE(plot.accessibleDescription().endsWith(
        QStringLiteral("The azimuth cable is at 397°. Its travel is from -90° to 450°. The nearer end is 53° away. It "
                       "ends at 450° in 27 s.")))
        << plot.accessibleDescription().toStdString();
    // Story: at 460° of 460° the words were plain.
    status.azimuth.actual = 449.9_deg;
    status.cableEnd = CableEnd{.end = 450_deg, .in = Seconds(0.0)};
    show(status);
    EXPECT_EQ(words("Travel of the azimuth cable"), QStringLiteral("at the end"));
    EXPECT_TRUE(cableWords(status).isWarning);
    plot.describe(status);
    EXPECT_TRUE(plot.accessibleDescription().endsWith(QStringLiteral("It is at the end.")))
        << plot.accessibleDescription().toStdString();
}

// REQ-UI-1653: A rotator that counts its turns itself never has an unknown wrap. While it is silent only its position
// is unknown.
TEST_F(SkyLook, ASilentRotatorThatCountsItselfHasNoUnknownWrap)
{
    StationStatus status = samples::bounded();
    status.drives.reset();
    status.azimuth.actual.reset();
    status.azimuth.turnKnown = false;
    EXPECT_TRUE(isTurnKnown(status, Axis::Azimuth));
    show(status);
    EXPECT_EQ(words("Azimuth cable"), QStringLiteral("cable ---°"));
    EXPECT_NE(words("Travel of the azimuth cable"), QStringLiteral("wrap unknown"));
    EXPECT_FALSE(cableWords(status).isWarning);
    status.azimuth.actual = 10_deg;
    EXPECT_FALSE(isTurnKnown(status, Axis::Azimuth)) << "what it reports is judged as it is";
}

TEST_F(SkyLook, AMountWithoutAnAzimuthHasNoCable)
{
    StationStatus status = samples::bounded();
    status.capabilities.axes[index(Axis::Azimuth)].reset();
    status.azimuth.travel = {};
    show(status);
    EXPECT_EQ(words("Azimuth cable"), QString());
    EXPECT_FALSE(plot.markers().cable().isThere());
}

// REQ-UI-705: During a slew the plot shows the coming way of the mount, with the time of arrival at its end.
TEST_F(SkyLook, TheWayOfASlewIsTheOneThatTheStationReports)
{
    show(unwrapping());
    EXPECT_EQ(plot.markers().markers().way, unwrapping().route);
    EXPECT_TRUE(plot.markers().markers().targetLabel.endsWith(QStringLiteral(", in 9 s")));
    show(everything());
    EXPECT_TRUE(plot.markers().markers().way.empty()) << "no slew, no way";
}

// REQ-UI-706: The warning colour is only for an unplanned error: the rest of a slew is no error.
TEST_F(SkyLook, APlannedWayIsNoError)
{
    StationStatus status = unwrapping();
    show(status);
    EXPECT_FALSE(plot.markers().markers().offTarget);
    status.actual = SkyPointing{30_deg, 45_deg};  // 7° beside the set-point
    show(status);
    EXPECT_TRUE(plot.markers().markers().offTarget);
    EXPECT_EQ(plot.markers().markers().expected, status.commanded);
    status = everything();
    status.actual = SkyPointing{30_deg, 45_deg};
    show(status);
    EXPECT_TRUE(plot.markers().markers().offTarget);
    EXPECT_EQ(plot.markers().markers().expected, status.target);
}

// REQ-UI-707: Sun and Moon are drawn at their places while they are above the horizon.
TEST_F(SkyLook, SunAndMoonAreWhereTheyAre)
{
    show(everything());
    for (const ThemeKind theme : kEachTheme) {
        paintIn(theme);
        EXPECT_TRUE(alike(skyPixel({220_deg, 35_deg}), currentTheme().sun)) << int(theme);
    }
    ASSERT_EQ(plot.markers().bodies().size(), 2U);
    StationStatus status = everything();
    status.bodies[0].direction.azimuth += 0.01_deg;
    show(status);
    EXPECT_EQ(plot.markers().bodies()[0].direction.azimuth, 220_deg) << "not painted again for a part of a pixel";
    status.bodies[0].direction.elevation = -1_deg;
    show(status);
    ASSERT_EQ(plot.markers().bodies().size(), 1U);
    EXPECT_EQ(plot.markers().bodies()[0].body, ephemeris::Body::Moon);
}

// REQ-UI-713: A change of the plot is repainted everywhere, also below hidden words: the legend names the sensor as
// soon as there is one.
TEST_F(SkyLook, TheScreenShowsTheLegendOfNow)
{
    StationStatus status = samples::tracking(1);
    status.sensor.direction.reset();
    show(status);
    settle();
    status.sensor.direction = SkyPointing{22_deg, 44_deg};
    show(status);
    settle();
    const QRect corner(0, plot.height() - 60, 200, 60);
    const QImage screen = plot.screen()->grabWindow(plot.winId()).toImage().copy(corner);
    const QImage anew = plot.grab(corner).toImage();
    EXPECT_EQ(screen.convertToFormat(QImage::Format_RGB32), anew.convertToFormat(QImage::Format_RGB32));
}

// REQ-UI-708: The trail of the mount fades over a minute to a faint line.
TEST(SkyTrail, FadesOverAMinute)
{
    SkyTrail trail;
    trail.setSky({QPointF(300, 300), 290.0});
    const UtcTime begin = samples::idle().utc;
    for (int second = 0; second <= 90; second += 10) {
        trail.add({Angle::fromDegrees(second / 5.0), 45_deg}, begin + std::chrono::seconds(second));
        trail.age(begin + std::chrono::seconds(second));
    }
    EXPECT_NEAR(trail.strength(begin + std::chrono::seconds(90)), 1.0, 1e-9);
    EXPECT_LT(trail.strength(begin + std::chrono::seconds(60)), 0.7);
    EXPECT_NEAR(trail.strength(begin), trail.strength(begin + std::chrono::seconds(30)), 1e-9) << "no fainter";
    EXPECT_GT(trail.strength(begin), 0.1);
    EXPECT_FALSE(trail.age(begin + std::chrono::seconds(92)).isEmpty()) << "it fades also while the mount stands";
    EXPECT_TRUE(trail.age(begin + std::chrono::seconds(92)).isEmpty());
}

// REQ-UI-709: A right click offers Go here, Add horizon point and Keep-out here. The last two are edits of the draft
// and open the editing. An action that is not possible is disabled with its reason. Opening the menu moves and changes
// nothing.
TEST_F(SkyLook, TheMenuOffersWhatCanBeDoneThere)
{
    show(everything());
    std::vector<SkyPointing> gone;
    QObject::connect(&plot, &PolarPlot::goHereWanted, &plot, [&](const SkyPointing& at) { gone.push_back(at); });
    rightClick({300_deg, 60_deg});
    ASSERT_NE(openedMenu(), nullptr);
    EXPECT_TRUE(gone.empty());
    EXPECT_FALSE(draft.hasEdits());
    entry("Go here")->trigger();
    ASSERT_EQ(gone.size(), 1U);
    EXPECT_LT(angleBetween(gone[0], {300_deg, 60_deg}), 0.5_deg);
    delete openedMenu();
    rightClick({300_deg, 10_deg}, {.whyNot = QStringLiteral("the horizon"), .nearest = SkyPointing{300_deg, 20_deg}});
    EXPECT_FALSE(entry("Go here")->isEnabled());
    EXPECT_EQ(entry("Go here")->text(), QStringLiteral("Go here (forbidden: the horizon)"));
    entry("Go to the nearest allowed: az 300.0°  el 20.0°")->trigger();
    EXPECT_EQ(gone.back(), (SkyPointing{300_deg, 20_deg}));
    delete openedMenu();
    rightClick({300_deg, 60_deg});
    EXPECT_FALSE(plot.editor().isEditing());
    entry("Keep-out here")->trigger();
    EXPECT_TRUE(plot.editor().isEditing());
    EXPECT_EQ(draft.edited().limits.keepOuts.size(), 3U);
}

// REQ-UI-709
TEST_F(SkyLook, TheMenuAddsAHorizonPointAndIsReachedByKey)
{
    show(everything());
    plot.setPicked(SkyPointing{300_deg, 60_deg});
    QContextMenuEvent byKey(QContextMenuEvent::Keyboard, QPoint(1, 1), plot.mapToGlobal(QPoint(1, 1)));
    QApplication::sendEvent(&plot, &byKey);
    answer();
    ASSERT_NE(openedMenu(), nullptr);
    entry("Add horizon point")->trigger();
    EXPECT_TRUE(plot.editor().isEditing());
    const auto& horizon = draft.edited().limits.horizon;
    EXPECT_NE(std::ranges::find(horizon, pointing::HorizonPoint{300_deg, 60_deg}), horizon.end());
    EXPECT_NE(plot.focusPolicy() & Qt::TabFocus, 0);
}

TEST_F(SkyLook, TooManyKeepOutsAreRefusedInTheMenu)
{
    StationStatus status = everything();
    profile::Profile full = *status.profile;
    while (full.limits.keepOuts.size() < profile::kMaxKeepOuts) {
        full.limits.keepOuts.push_back(
            {"k" + std::to_string(full.limits.keepOuts.size()), 10_deg, 12_deg, 70_deg, 71_deg});
    }
    status.profile = std::make_shared<const profile::Profile>(full);
    show(status);
    rightClick({300_deg, 60_deg});
    EXPECT_FALSE(entry("Keep-out here")->isEnabled());
    EXPECT_TRUE(entry("Add horizon point")->isEnabled());
}

TEST_F(SkyLook, APictureHasTheWordsOfTheCorners)
{
    show(everything());
    QImage picture(plot.size(), QImage::Format_RGB32);
    QPainter painter(&picture);
    plot.paintPicture(painter);
    painter.end();
    const QRect words = plot.tools().corners().back()->geometry();
    int inked = 0;
    for (int x = words.left(); x < words.right(); ++x) {
        inked += picture.pixelColor(x, words.center().y()) != currentTheme().window ? 1 : 0;
    }
    EXPECT_GT(inked, 5);
}

// Story: beside the numbers under the cursor stood "◇ target", which was left of the legend.
// REQ-UI-1719: The numbers under the cursor take the place of the whole legend.
TEST_F(SkyLook, TheNumbersUnderTheCursorTakeThePlaceOfTheLegend)
{
    const QImage legend = plot.grab(QRect(110, plot.height() - 18, 60, 16)).toImage();
    QImage empty = legend;
    empty.fill(currentTheme().window);
    EXPECT_NE(legend, empty);
    auto* const editor = plot.findChild<PlotEditor*>();
    ASSERT_NE(editor, nullptr);
    Q_EMIT editor->readout(QStringLiteral("az 1°"));
    EXPECT_EQ(plot.grab(QRect(110, plot.height() - 18, 60, 16)).toImage(), empty);
    Q_EMIT editor->readout({});
    EXPECT_EQ(plot.grab(QRect(110, plot.height() - 18, 60, 16)).toImage(), legend);
}

}  // namespace
}  // namespace boresight::ui
