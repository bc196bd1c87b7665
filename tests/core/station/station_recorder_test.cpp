// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/station_recorder.h"

#include "core/recording/record_reader.h"
#include "core/recording/record_writer.h"
#include "core/tables/table_reader.h"
#include "tests/core/station/moving_station.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <string>
#include <vector>

namespace boresight {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

constexpr Seconds kRecordedTick{0.02};

class StationRecorderTest : public testing::Test
{
protected:
    // 4° in each minute for three minutes, at 20° elevation.
    [[nodiscard]] targets::Target moving() const
    {
        const auto start = std::chrono::floor<std::chrono::seconds>(m_rig->clock.utc().time_since_epoch()).count();
        std::string text;
        for (int i = 0; i <= 3; ++i) {
            text += std::to_string(start + 60 * i) + ' ' + std::to_string(4 * i) + " 20\n";
        }
        return targets::tableTarget(tables::readTable(text, QStringLiteral("/tmp/way.txt")).value());
    }
    void ask(const Request& request)
    {
        m_rig->station->request({.id = ++m_asked, .request = request});
        const auto answer = m_rig->answerTo(m_asked);
        ASSERT_TRUE(answer);
        EXPECT_FALSE(answer->error) << answer->error->text.toStdString();
    }
    // The recordings in the folder, also those without an end.
    [[nodiscard]] std::vector<recording::Recording> stored() const
    {
        std::vector<recording::Recording> all;
        const QDir folder(recordingsPath(m_folder.path(), QStringLiteral("Boresight mount"), true));
        for (const QString& name : folder.entryList(QDir::Files, QDir::Name)) {
            all.push_back(recording::loadRecording(folder.filePath(name)).value_or(recording::Recording{}));
        }
        return all;
    }
    // All recordings, as soon as the last one, which must have ended, is written.
    [[nodiscard]] std::vector<recording::Recording> recordings()
    {
        EXPECT_TRUE(fakes::waitUntil([this] {
            m_rig->run(kRecordedTick);
            const auto all = stored();
            return !all.empty() && std::ranges::all_of(all, &recording::Recording::hasEnd);
        }));
        return stored();
    }
    [[nodiscard]] bool isNothingStored()
    {
        m_rig.reset();
        return stored().empty();
    }

    QTemporaryDir m_folder;
    std::unique_ptr<MovingStation> m_rig = std::make_unique<MovingStation>(m_folder.path());

private:
    std::uint64_t m_asked = 0;
};

}  // namespace

// REQ-RECORD-12: Without a window, too, each pass is recorded: from when the mount begins to track a moving target
// until 10 s after that, with the lines of the log.
TEST_F(StationRecorderTest, APassIsRecordedFromItsBeginningToItsEnd)
{
    ask(request::Track{moving()});
    m_rig->run(Seconds(30.0));
    EXPECT_EQ(m_rig->station->status().state, StationState::Track);
    ask(request::Hold{});
    m_rig->run(Seconds(30.0));
    const auto all = recordings();
    ASSERT_THAT(all, SizeIs(1));
    const recording::Recording& pass = all.front();
    EXPECT_THAT(pass.problems, IsEmpty());
    EXPECT_TRUE(pass.hasEnd);
    EXPECT_TRUE(pass.header.isSimulated);
    EXPECT_EQ(pass.header.client, QString());
    EXPECT_FALSE(pass.header.target.isEmpty());
    // 30 s of tracking and 10 s more.
    EXPECT_NEAR(static_cast<double>(pass.ticks.size()) * kRecordedTick.count(), 40.0, 0.5);
    EXPECT_EQ(pass.header.stateWord(pass.ticks.back().state), QStringLiteral("HOLD"));
    EXPECT_TRUE(std::ranges::any_of(pass.ticks, [&](const recording::Tick& tick) {
        return pass.header.stateWord(tick.state) == QStringLiteral("TRACK") && tick.error && *tick.error < 0.1_deg &&
               tick.axes[0].actual && tick.axes[0].torque && tick.axes[1].commandedRate;
    }));
    EXPECT_TRUE(std::ranges::any_of(pass.events, [](const recording::Event& event) {
        return event.kind == recording::EventKind::MotionStart && event.source == QStringLiteral("operator");
    }));
    const auto isLater = [](const recording::Tick& a, const recording::Tick& b) { return a.utc >= b.utc; };
    EXPECT_EQ(std::ranges::adjacent_find(pass.ticks, isLater), pass.ticks.end());
}

// REQ-RECORD-12
TEST_F(StationRecorderTest, AMotionToAFixedPlaceIsNoPass)
{
    ask(request::PointSky{{.azimuth = 40_deg, .elevation = 30_deg}});
    m_rig->run(Seconds(20.0));
    EXPECT_TRUE(isNothingStored());
}

// REQ-RECORD-13: The profile can switch the recording off.
TEST_F(StationRecorderTest, TheProfileMaySayNo)
{
    profile::Profile quiet = *m_rig->station->status().profile;
    quiet.record.passes = profile::RecordPasses::Off;
    ask(request::ApplyProfile{quiet});
    ask(request::Track{moving()});
    m_rig->run(Seconds(20.0));
    EXPECT_TRUE(isNothingStored());
}

// A short break of the tracking does not split the recording.
TEST_F(StationRecorderTest, ATargetThatIsTrackedAgainContinuesTheRecording)
{
    ask(request::Track{moving()});
    m_rig->run(Seconds(10.0));
    ask(request::Hold{});
    m_rig->run(Seconds(5.0));
    ask(request::Track{moving()});
    m_rig->run(Seconds(10.0));
    ask(request::Hold{});
    m_rig->run(Seconds(15.0));
    EXPECT_THAT(recordings(), SizeIs(1));
}

// Story: the first events of a recording were lines of the log of the day before.
TEST_F(StationRecorderTest, OldLinesOfTheLogAreNotOfThePass)
{
    ask(request::PointSky{{.azimuth = 40_deg, .elevation = 30_deg}});
    m_rig->run(Seconds(70.0));
    ask(request::Track{moving()});
    m_rig->run(Seconds(5.0));
    ask(request::Hold{});
    m_rig->run(Seconds(15.0));
    const auto all = recordings();
    ASSERT_THAT(all, SizeIs(1));
    ASSERT_FALSE(all[0].ticks.empty());
    ASSERT_FALSE(all[0].events.empty());
    for (const recording::Event& event : all[0].events) {
        EXPECT_GT(event.utc, all[0].ticks.front().utc - std::chrono::seconds(60)) << event.text.toStdString();
    }
    EXPECT_FALSE(std::ranges::any_of(all[0].events, [](const recording::Event& event) {
        return event.kind == recording::EventKind::MotionStart && event.text.contains(QStringLiteral("go to"));
    }));
}

// REQ-RECORD-20: Events have the clock of the ticks, also while the station points by an old time.
TEST_F(StationRecorderTest, EventsHaveTheClockOfTheTicks)
{
    m_rig->clock.setAhead(Seconds(3'600.0));
    ask(request::Track{moving()});
    m_rig->run(Seconds(5.0));
    ask(request::Hold{});
    m_rig->run(Seconds(15.0));
    const auto all = recordings();
    ASSERT_THAT(all, SizeIs(1));
    ASSERT_FALSE(all[0].ticks.empty());
    EXPECT_TRUE(std::ranges::any_of(
        all[0].events, [](const recording::Event& event) { return event.kind == recording::EventKind::MotionStart; }));
    for (const recording::Event& event : all[0].events) {
        EXPECT_LT(event.utc, all[0].ticks.back().utc + std::chrono::seconds(1)) << event.text.toStdString();
    }
}

// REQ-RECORD-17
TEST_F(StationRecorderTest, AgeDeletesOnlyWhileTheClockIsSet)
{
    const QDir folder(recordingsPath(m_folder.path(), QStringLiteral("Boresight mount"), true));
    ASSERT_TRUE(folder.mkpath(QStringLiteral(".")));
    const QString old =
        recorder::recordingName(m_rig->clock.utc() - std::chrono::hours(24 * 400), QStringLiteral("OLD"));
    const QByteArray bytes = recording::fileStart({}) + recording::fileEnd();
    ASSERT_TRUE(recorder::appendWhole(folder.filePath(old), bytes));
    const auto pass = [this](std::size_t files) {
        ask(request::Track{moving()});
        m_rig->run(Seconds(5.0));
        ask(request::Hold{});
        m_rig->run(Seconds(15.0));
        EXPECT_THAT(recordings(), SizeIs(files));
    };
    m_rig->clock.setSynchronised(false);
    pass(2);
    EXPECT_TRUE(QFile::exists(folder.filePath(old)));
    m_rig->clock.setSynchronised(true);
    pass(2);
    EXPECT_FALSE(QFile::exists(folder.filePath(old)));
}

}  // namespace boresight
