// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recording/record_writer.h"
#include "tests/core/recording/recorded_pass.h"
#include "tests/fakes/hand_turned_timers.h"
#include "tests/fakes/manual_clock.h"
#include "tests/ui/find_widget.h"
#include "ui/charts/strip_charts.h"
#include "ui/kit/choice_button.h"
#include "ui/look/desk_style.h"
#include "ui/replay/recorded_status.h"
#include "ui/replay/recording_band.h"
#include "ui/replay/replay_charts.h"
#include "ui/replay/replay_opener.h"
#include "ui/replay/replay_window.h"
#include "ui/replay/time_slider.h"
#include "ui/sky/plot_button.h"
#include "ui/sky/polar_plot.h"

#include <QContextMenuEvent>
#include <QDir>
#include <QFile>
#include <QMenu>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>
#include <QTemporaryDir>

#include <gmock/gmock.h>

#include <span>

// A recorded pass in its window, by mouse and keys, with a hand-turned clock.
namespace boresight::ui {
namespace {

using namespace std::chrono_literals;
using recording::kRecordedFrom;
using testing::HasSubstr;

constexpr std::size_t kTicks = 50 * 120;

recording::Event eventAt(std::chrono::seconds after, recording::EventKind kind, const char* text)
{
    return {.utc = kRecordedFrom + after,
            .kind = kind,
            .source = QStringLiteral("operator"),
            .text = QString::fromUtf8(text)};
}

// Two minutes.
recording::Recording recordedPass()
{
    return {.header = recording::recordedHeader(),
            .ticks = recording::RecordedPass().ticks(kTicks),
            .events = {eventAt(10s, recording::EventKind::MotionStart, "Go to 113.0° 10.0°"),
                       eventAt(30s, recording::EventKind::ClientLine, "P 180.00 10.00 -> RPRT 0"),
                       eventAt(60s, recording::EventKind::MotionStart, "Track NOAA 19"),
                       eventAt(90s, recording::EventKind::Event, "The wind is 12 m/s")},
            .hasEnd = true};
}

QByteArray fileOf(const recording::Recording& record)
{
    QByteArray bytes = recording::fileStart(record.header) + recording::eventBlock(record.events);
    constexpr std::size_t kBlock = 250;
    for (std::size_t i = 0; i < record.ticks.size(); i += kBlock) {
        bytes += recording::tickBlock(std::span(record.ticks).subspan(i, kBlock));
    }
    return record.hasEnd ? bytes + recording::fileEnd() : bytes;
}

class ReplayTest : public ::testing::Test
{
protected:
    ReplayTest()
    {
        DeskStyle::install();
        applyTheme(ThemeKind::Day, Brightness::High);
        QObject::connect(&opener, &ReplayOpener::opened, &opener, [this](ReplayWindow* made) { window = made; });
    }
    ~ReplayTest() override { applyTheme(ThemeKind::Day, Brightness::High); }

    QString write(const QByteArray& bytes)
    {
        const QString path = folder.filePath(QStringLiteral("pass.recording"));
        QFile file(path);
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        EXPECT_EQ(file.write(bytes), bytes.size());
        return path;
    }

    // Opens it as an operator does, at the smallest size of the window of the station.
    void open(const QByteArray& bytes)
    {
        opener.open(write(bytes));
        ASSERT_TRUE(comesTrue([this] { return window != nullptr; }));
        window->resize(1024, 700);
        timers.emplace(*window, clock);
        window->activateWindow();
        ASSERT_TRUE(becomesActive(*window));
        settle();
    }
    void open() { open(fileOf(recordedPass())); }

    void key(Qt::Key one, Qt::KeyboardModifiers with = Qt::NoModifier) { QTest::keyClick(window, one, with); }
    void press(const char* button) { QTest::mouseClick(&findSeen<QAbstractButton>(*window, button), Qt::LeftButton); }
    QString text(const char* name) { return findNamed<ValueLabel>(*window, name)->text(); }
    Seconds passed() { return window->player().moment() - window->player().begin(); }
    Seconds sinceTheStart() { return window->player().moment() - kRecordedFrom; }  // of the events
    PolarPlot& plot() { return *window->findChild<PolarPlot*>(); }
    QTableView& events() { return findSeen<QTableView>(*window, "Events of the recording"); }
    void clickEvent(int row)
    {
        const QRect line = events().visualRect(events().model()->index(row, 0));
        QTest::mouseClick(events().viewport(), Qt::LeftButton, {}, line.center());
    }

    QTemporaryDir folder;
    fakes::ManualClock clock;
    ReplayOpener opener{clock, folder.path()};
    QPointer<ReplayWindow> window;
    std::optional<fakes::HandTurnedTimers> timers;
};

// REQ-REPLAY-01: A recording opens in a window of its own. Its title and a band across the top name the target and the
// time. It has no STOP and no control of the station.
TEST_F(ReplayTest, NobodyTakesItForThePresent)
{
    open();
    EXPECT_EQ(window->windowTitle(), QStringLiteral("Recording of NOAA 19, 2026-11-18 11:06Z"));
    const auto* const band = window->findChild<RecordingBand*>();
    EXPECT_EQ(band->title(), window->windowTitle());
    EXPECT_EQ(band->geometry().top(), 0);
    EXPECT_EQ(band->width(), window->width());
    EXPECT_EQ(window->parentWidget(), nullptr) << "the window of the station can come to the front";
    for (const QAbstractButton* const button : window->findChildren<QAbstractButton*>()) {
        EXPECT_FALSE(button->isVisible() && button->text() == QStringLiteral("STOP"));
    }
    for (const PlotButton* const button : window->findChildren<PlotButton*>()) {
        EXPECT_FALSE(button->isVisible() && button->accessibleName() == QStringLiteral("Edit"));
    }
}

// REQ-REPLAY-01
TEST_F(ReplayTest, TheSkyOffersNoCommand)
{
    open();
    const QPoint middle = plot().markers().rect().center();
    QContextMenuEvent event(QContextMenuEvent::Mouse, middle, plot().markers().mapToGlobal(middle));
    QCoreApplication::sendEvent(&plot().markers(), &event);
    settle();
    EXPECT_EQ(plot().findChild<QMenu*>(), nullptr);
}

// REQ-REPLAY-02: A recording plays at 1, 2, 5, 10, 30 and 60 times the speed. At its end it pauses, and Play begins
// again.
TEST_F(ReplayTest, PlaysAtEachSpeed)
{
    open();
    timers->elapse(1s);
    EXPECT_EQ(passed(), 0s) << "it does not play by itself";
    for (const int speed : ReplayPlayer::kSpeeds) {
        press(QStringLiteral("Play at %1 times the speed (+ and -)").arg(speed).toUtf8().constData());
        key(Qt::Key_Home);
        press("Play");
        timers->elapse(1s);
        press("Pause");
        EXPECT_NEAR(passed().count(), speed, 1e-6);
        timers->elapse(1s);
        EXPECT_NEAR(passed().count(), speed, 1e-6) << "it pauses";
    }
}

// REQ-REPLAY-02
TEST_F(ReplayTest, PausesAtTheEndAndBeginsAgain)
{
    open();
    window->player().setSpeed(60);
    press("Play");
    timers->elapse(3s);
    EXPECT_EQ(window->player().moment(), window->player().end());
    EXPECT_FALSE(window->player().isPlaying());
    press("Play");
    timers->elapse(1s);
    EXPECT_NEAR(passed().count(), 60.0, 1e-6);
}

// REQ-REPLAY-03: Space plays and pauses, the arrow keys step by 1 s, Home and End go to the ends, + and - change the
// speed.
TEST_F(ReplayTest, ListensToKeys)
{
    open();
    key(Qt::Key_Right);
    key(Qt::Key_Right);
    key(Qt::Key_Left);
    EXPECT_EQ(passed(), 1s);
    key(Qt::Key_End);
    EXPECT_EQ(window->player().moment(), window->player().end());
    key(Qt::Key_Home);
    EXPECT_EQ(passed(), 0s);
    key(Qt::Key_Plus);
    key(Qt::Key_Equal);
    EXPECT_EQ(window->player().speed(), 5);
    EXPECT_TRUE(findNamed<ChoiceButton>(*window, "Play at 5 times the speed (+ and -)")->isChecked());
    key(Qt::Key_Minus);
    EXPECT_EQ(window->player().speed(), 2);
    key(Qt::Key_Space);
    EXPECT_TRUE(window->player().isPlaying());
    key(Qt::Key_Space);
    EXPECT_FALSE(window->player().isPlaying());
    QTest::keyClick(&events(), Qt::Key_Right);
    EXPECT_EQ(passed(), 1s) << "also while the table has the keyboard";
    key(Qt::Key_Escape);
    settle();
    EXPECT_EQ(window, nullptr);
}

// REQ-REPLAY-04: A click on an event, and on the time slider, jumps to that moment.
TEST_F(ReplayTest, JumpsToAnEvent)
{
    open();
    key(Qt::Key_Space);
    clickEvent(1);
    EXPECT_EQ(sinceTheStart(), 30s);
    EXPECT_FALSE(window->player().isPlaying()) << "the operator reads the event";
    events().selectRow(3);
    QTest::keyClick(&events(), Qt::Key_Return);
    EXPECT_EQ(sinceTheStart(), 90s);
    clickEvent(0);
    EXPECT_EQ(sinceTheStart(), 10s);
    auto& slider = findSeen<TimeSlider>(*window, "Moment of the recording");
    QTest::mouseClick(&slider, Qt::LeftButton, {}, QPoint(slider.width() - 1, slider.height() / 2));
    EXPECT_EQ(window->player().moment(), window->player().end());
    EXPECT_EQ(events().currentIndex().row(), 3) << "the newest event at the moment is selected";
}

// REQ-REPLAY-05: "Why did it move?" jumps to the last start of a motion before the moment, and shows its sentence. Such
// events are marked in the list.
TEST_F(ReplayTest, ShowsWhyItMoved)
{
    open();
    EXPECT_EQ(events().model()->index(0, RecordedEventModel::Kind).data().toString(), QStringLiteral("▶ motion"));
    EXPECT_EQ(events().model()->index(1, RecordedEventModel::Kind).data().toString(), QStringLiteral("client"));
    press("Why did it move?");
    EXPECT_THAT(text("Why the mount moved").toStdString(), HasSubstr("No motion began before this moment"));
    key(Qt::Key_End);
    press("Why did it move?");
    EXPECT_EQ(sinceTheStart(), 60s);
    EXPECT_THAT(text("Why the mount moved").toStdString(), HasSubstr("operator: Track NOAA 19"));
    press("Why did it move?");
    EXPECT_EQ(sinceTheStart(), 10s);
    EXPECT_THAT(text("Why the mount moved").toStdString(), HasSubstr("operator: Go to 113.0° 10.0°"));
    press("Why did it move?");
    EXPECT_EQ(sinceTheStart(), 10s);
    EXPECT_THAT(text("Why the mount moved").toStdString(), HasSubstr("first motion"));
}

// REQ-REPLAY-06: Sky, charts and numbers show the values of the moment.
TEST_F(ReplayTest, ShowsTheMoment)
{
    const recording::Recording record = recordedPass();
    open(fileOf(record));
    window->player().jumpTo(record.ticks[3000].utc);
    const recording::Tick& tick = record.ticks[3000];
    EXPECT_EQ(plot().markers().markers().actual, tick.actual);
    EXPECT_EQ(plot().markers().markers().target, tick.target);
    EXPECT_EQ(plot().markers().markers().sensor, tick.sensor);
    EXPECT_TRUE(plot().markers().markers().live);
    EXPECT_EQ(text("UTC"), dateText(tick.utc));
    EXPECT_EQ(text("State"), QStringLiteral("TRACK"));
    EXPECT_EQ(text("Actual azimuth"), azimuthText(tick.actual->azimuth, 2));
    EXPECT_EQ(text("Commanded elevation"), angleText(tick.commanded->elevation));
    EXPECT_EQ(text("Target elevation"), angleText(tick.target->elevation));
    EXPECT_EQ(text("Error on the sky"), angleText(*tick.error, 3));
    EXPECT_EQ(text("Torque of azimuth"), QStringLiteral("%1 Nm").arg(*tick.axes[0].torque, 0, 'f', 2));
    const auto& store = window->findChild<StripCharts*>()->store();
    const auto drawn = store.ring(Axis::Azimuth, Channel::Actual).at(TelemetryStore::binOf(steadyTimeOf(tick.utc)));
    ASSERT_TRUE(drawn);
    EXPECT_NEAR(drawn->max, tick.axes[0].actual->degrees(), 0.1);
}

// REQ-REPLAY-06
TEST_F(ReplayTest, TheTrailEndsAtTheMomentAfterEachJump)
{
    open();
    key(Qt::Key_End);
    const std::size_t whole = plot().markers().trail().length();
    EXPECT_GT(whole, 10u);
    window->player().jumpTo(window->player().begin() + 30s);
    EXPECT_LT(plot().markers().trail().length(), whole / 2);
    EXPECT_GT(plot().markers().trail().length(), 2u);
    window->player().setSpeed(60);
    key(Qt::Key_Space);
    timers->elapse(2s);
    EXPECT_EQ(plot().markers().trail().length(), whole) << "no place is lost at 60 times the speed";
}

// The motion that began just before the first tick: pressed again, the answer is that it is the first one.
TEST_F(ReplayTest, ShowsAMotionFromBeforeTheFirstTick)
{
    recording::Recording record = recordedPass();
    record.events.erase(record.events.begin() + 1, record.events.end());
    record.events.front().utc = kRecordedFrom - 5s;
    open(fileOf(record));
    key(Qt::Key_W);
    EXPECT_EQ(passed(), Seconds(0.0));
    EXPECT_TRUE(text("Why the mount moved").contains(QStringLiteral("Go to 113.0° 10.0°")));
    key(Qt::Key_W);
    EXPECT_TRUE(text("Why the mount moved").contains(QStringLiteral("This is the first motion")));
}

// REQ-REPLAY-07: A damaged file opens up to what can be read, and a sentence says so. A file that is no recording does
// not open, with the reason.
TEST_F(ReplayTest, OpensADamagedFile)
{
    const QByteArray whole = fileOf(recordedPass());
    open(whole.first(whole.size() / 2));
    EXPECT_TRUE(says(*window, "The file is damaged"));
    EXPECT_GT(window->player().end(), window->player().begin() + 50s);
    EXPECT_LT(window->player().end(), window->player().begin() + 119s);
}

// REQ-REPLAY-07
TEST_F(ReplayTest, OpensAFileThatIsStillWritten)
{
    recording::Recording record = recordedPass();
    record.hasEnd = false;
    open(fileOf(record));
    EXPECT_TRUE(says(*window, "The recording has no end mark"));
}

// REQ-REPLAY-07
TEST_F(ReplayTest, NamesTheDamage)
{
    QByteArray bytes = fileOf(recordedPass());
    const qsizetype middle = bytes.size() / 2;
    bytes[middle] = static_cast<char>(~bytes[middle]);
    open(bytes);
    EXPECT_TRUE(says(*window, "The file is damaged"));
    EXPECT_GT(window->player().end(), window->player().begin() + 119s) << "only one block is lost";
}

// REQ-REPLAY-07
TEST_F(ReplayTest, RefusesAFileThatIsNoRecording)
{
    QString reason;
    QObject::connect(&opener, &ReplayOpener::failed, &opener, [&reason](const QString& text) { reason = text; });
    opener.open(write("not a recording"));
    EXPECT_TRUE(comesTrue([&reason] { return !reason.isEmpty(); }));
    EXPECT_EQ(window, nullptr);
    EXPECT_TRUE(reason.contains(QStringLiteral("pass.recording"))) << reason.toStdString();
}

// Where ticks are missing, the mount looks silent: nothing shows an old number.
// REQ-REPLAY-06
TEST_F(ReplayTest, AGapShowsNoNumbers)
{
    recording::Recording record = recordedPass();
    record.ticks.erase(record.ticks.begin() + 1000, record.ticks.begin() + 2000);
    const ReplayTape tape(record);
    const UtcTime last = record.ticks[999].utc;
    const auto profile = recordedProfile(tape.header());
    EXPECT_EQ(recordedStatus(tape, profile, last + 1s).azimuth.age, 1s);
    open(fileOf(record));
    window->player().jumpTo(last + 5s);
    EXPECT_EQ(text("Actual azimuth"), noValue());
    EXPECT_EQ(text("State"), QStringLiteral("NO DATA"));
}

TEST(ReplayTapeTest, AddsTheGapsToTheEvents)
{
    recording::Recording record = recordedPass();
    record.gaps.push_back({.from = kRecordedFrom + 20s, .to = kRecordedFrom + 21s, .ticks = 50});
    const ReplayTape tape(record);
    ASSERT_EQ(tape.events().size(), 5u);
    EXPECT_EQ(tape.events()[1].utc, kRecordedFrom + 20s);
    EXPECT_THAT(tape.events()[1].text.toStdString(), HasSubstr("50 ticks were not recorded"));
    EXPECT_TRUE(tape.remarks().isEmpty());
}

// Story: events from long before the pass made the replay begin with nothing to see.
TEST(ReplayTapeTest, TheTicksAreTheSpan)
{
    recording::Recording record = recordedPass();
    record.events.front().utc = kRecordedFrom - 50s;
    record.events.back().utc = kRecordedFrom + 500s;
    const ReplayTape tape(record);
    EXPECT_EQ(tape.begin(), tape.ticks().front().utc);
    EXPECT_EQ(tape.end(), tape.ticks().back().utc);
    EXPECT_EQ(tape.motionStartAt(tape.begin()), 0U);
}

// REQ-REPLAY-07
TEST(ReplayTapeTest, ShowsTheFirstDamageAndANumber)
{
    recording::Recording record = recordedPass();
    for (int i = 1; i <= 10; ++i) {
        record.problems << QStringLiteral("damage %1").arg(i);
    }
    const QStringList remarks = ReplayTape(record).remarks();
    ASSERT_EQ(remarks.size(), 5);
    EXPECT_EQ(remarks[3], QStringLiteral("damage 3."));
    EXPECT_EQ(remarks[4], QStringLiteral("Further damage: 7."));
}

TEST(ReplayTapeTest, ARecordingWithoutTicksShowsItsEvents)
{
    recording::Recording record = recordedPass();
    record.ticks.clear();
    const ReplayTape tape(record);
    EXPECT_EQ(tape.begin(), kRecordedFrom + 10s);
    EXPECT_EQ(tape.end(), kRecordedFrom + 90s);
    EXPECT_EQ(tape.tickAt(tape.end()), nullptr);
    EXPECT_EQ(tape.remarks().size(), 1);
    const StationStatus status = recordedStatus(tape, recordedProfile(tape.header()), tape.end());
    EXPECT_FALSE(status.actual);
    EXPECT_FALSE(status.azimuth.age);
}

// REQ-REPLAY-06
TEST(ReplayChartsTest, AJumpBackInALongRecordingFillsThemAgain)
{
    recording::Recording record = recordedPass();
    record.ticks.clear();
    for (int second = 0; second < 3600; ++second) {
        recording::Tick tick{.utc = kRecordedFrom + std::chrono::seconds(second)};
        tick.axes[0].actual = Angle::fromDegrees(0.1 * second);
        record.ticks.push_back(tick);
    }
    const auto tape = std::make_shared<const ReplayTape>(record);
    const auto profile = recordedProfile(tape->header());
    ReplayCharts charts(tape);
    const auto actual = [&](std::chrono::seconds at) {
        return charts.charts()
            .store()
            .ring(Axis::Azimuth, Channel::Actual)
            .at(TelemetryStore::binOf(steadyTimeOf(kRecordedFrom + at)));
    };
    charts.show(recordedStatus(*tape, profile, kRecordedFrom + 3500s));
    EXPECT_TRUE(actual(3500s));
    EXPECT_FALSE(actual(600s));
    charts.show(recordedStatus(*tape, profile, kRecordedFrom + 600s));
    ASSERT_TRUE(actual(600s));
    EXPECT_NEAR(actual(600s)->max, 60.0, 1e-3);
}

struct Look
{
    const char* name;
    ThemeKind theme;
    QSize size;
};

void PrintTo(const Look& look, std::ostream* out)
{
    *out << look.name;
}

class ReplayLook : public ReplayTest, public ::testing::WithParamInterface<Look>
{};

// REQ-REPLAY-08: The replay has room at 1024×700 in each theme. With BORESIGHT_PICTURES its picture is kept.
TEST_P(ReplayLook, HasRoom)
{
    applyTheme(GetParam().theme, Brightness::High);
    open();
    window->player().jumpTo(window->player().begin() + 75s);
    window->resize(GetParam().size);
    settle();
    EXPECT_EQ(window->size(), GetParam().size);
    for (const char* const name : {"UTC", "State", "Actual azimuth", "Target elevation", "Torque of elevation"}) {
        EXPECT_FALSE(findNamed<ValueLabel>(*window, name)->isElided()) << name;
    }
    EXPECT_GE(std::min(plot().width(), plot().height()), 380);
    EXPECT_GE(events().height(), 3 * kRowHeight);
    const QString folderOfPictures = qEnvironmentVariable("BORESIGHT_PICTURES");
    const QString file = QStringLiteral("replay-%1.png").arg(QLatin1String(GetParam().name));
    EXPECT_TRUE(folderOfPictures.isEmpty() || window->grab().save(QDir(folderOfPictures).filePath(file)));
}

INSTANTIATE_TEST_SUITE_P(All, ReplayLook,
                         ::testing::Values(Look{"day_1024", ThemeKind::Day, {1024, 700}},
                                           Look{"night_1280", ThemeKind::Night, {1280, 800}},
                                           Look{"red_1024", ThemeKind::Red, {1024, 700}}),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace boresight::ui
