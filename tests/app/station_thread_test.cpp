// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/station_thread.h"

#include "core/base/clock.h"
#include "core/moteus_mount/link_factory.h"
#include "core/moteus_mount/moteus_connection.h"
#include "core/profile/setting.h"
#include "tests/fakes/wait_until.h"

#include <QSignalSpy>
#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <optional>

namespace boresight::app {
namespace {

profile::Profile mount(const char* name)
{
    profile::Profile profile;
    profile.mount.name = name;
    profile.rotctld.listen.port = 0;
    return profile;
}

// Real threads and a real event loop. The drives are simulated.
class StationThreadTest : public ::testing::Test
{
protected:
    StationThreadTest()
    {
        QObject::connect(&thread, &StationThread::nextWanted, &thread, [this](const profile::Profile& wanted) {
            if (aDiskHangs) {
                waiting = wanted;
            } else {
                thread.begin(wanted);
            }
        });
        QObject::connect(&thread, &StationThread::updated, &thread, [this](const StationUpdate& update) {
            inForce = update.status.profile;
            isStopped = update.status.stopLatched;
            alarms = update.status.alarms;
            for (const Answer& answer : update.answers) {
                answers.push_back(answer);
            }
            Q_EMIT thread.updateTaken();
        });
    }
    ~StationThreadTest() override
    {
        QSignalSpy finished(&thread, &StationThread::finished);
        Q_EMIT thread.shutDownRequested();
        EXPECT_TRUE(finished.count() > 0 || finished.wait(60'000));
    }

    std::unique_ptr<Station> station(const profile::Profile& profile)
    {
        return std::make_unique<Station>(profile,
                                         moteusRotator(links.make(profile.bus), {folder.path(), Simulation::Reference}),
                                         folder.path(), clock);
    }
    std::unique_ptr<Station> build(const profile::Profile& profile)
    {
        ++built;
        builder = QThread::currentThread();
        return station(profile);
    }
    void ask(const Request& request) { Q_EMIT thread.requested({.id = ++lastId, .request = request}); }
    // Requests a reconnect, during which the profile of the next mount is not found.
    [[nodiscard]] bool getsStuckBetweenTwo()
    {
        aDiskHangs = true;
        ask(request::Reconnect{mount("Field")});
        return fakes::waitUntil([this] { return waiting.has_value(); });
    }
    // The reason why this request was refused. Empty if it was not.
    [[nodiscard]] QString refusalOf(std::uint64_t id) const
    {
        const auto answer = std::ranges::find(answers, id, &Answer::requestId);
        if (answer == answers.end()) {
            return QStringLiteral("no answer");
        }
        return answer->error ? answer->error->text : QString();
    }
    bool shows(const std::string& name)
    {
        return fakes::waitUntil([&] { return inForce && inForce->mount.name == name; });
    }

    QTemporaryDir folder;
    SystemClock clock;
    std::shared_ptr<const profile::Profile> inForce;
    std::vector<Answer> answers;
    std::uint64_t lastId = 0;
    std::atomic<int> built = 0;
    std::atomic<QThread*> builder = nullptr;
    bool aDiskHangs = false;
    std::optional<profile::Profile> waiting;
    bool isStopped = false;
    std::vector<Alarm> alarms;
    LinkMaker links{profile::Profile{}, clock};
    StationThread thread{station(mount("Roof")), [this](const profile::Profile& profile) { return build(profile); }};
};

TEST_F(StationThreadTest, AReconnectRunsTheOtherMountInItsPlace)
{
    thread.start();
    ASSERT_TRUE(shows("Roof"));
    QSignalSpy finished(&thread, &StationThread::finished);
    ask(request::Reconnect{mount("Field")});
    ASSERT_TRUE(shows("Field"));
    EXPECT_TRUE(finished.isEmpty()) << "the window would close";

    ask(request::TakeAuthority{});
    EXPECT_TRUE(fakes::waitUntil([this] { return !answers.empty() && answers.back().requestId == lastId; }))
        << "the requests reach the station that runs";
    ask(request::Reconnect{mount("Roof")});
    EXPECT_TRUE(shows("Roof")) << "and back";
    EXPECT_EQ(built, 2);
    EXPECT_NE(builder, QThread::currentThread()) << "it reads files";
}

TEST_F(StationThreadTest, TheAskerOfAReconnectHasItsAnswer)
{
    thread.start();
    ASSERT_TRUE(shows("Roof"));
    ask(request::Reconnect{mount("Field")});
    ASSERT_TRUE(shows("Field"));
    ASSERT_FALSE(answers.empty());
    EXPECT_EQ(answers.front().requestId, 1u);
    EXPECT_FALSE(answers.front().error);
}

TEST_F(StationThreadTest, TheNextStationListensWhereTheOldOneDid)
{
    QSignalSpy started(&thread, &StationThread::started);
    thread.start();
    ASSERT_TRUE(started.wait(60'000));
    const QString listening = started.front().at(0).toString();
    profile::Profile next = mount("Field");
    next.rotctld.listen = *profile::parseListenAddress(listening.toStdString());
    ask(request::Reconnect{next});
    ASSERT_TRUE(started.wait(60'000));
    EXPECT_EQ(started.back().at(0).toString(), listening);
    EXPECT_EQ(started.back().at(1).toString(), QString());
}

// There is always a station. Otherwise the window would show the last status for ever and accept no request.
TEST_F(StationThreadTest, AMountWhoseBusCanNotBeUsedIsShownAndTheOtherOneComesBack)
{
    thread.start();
    ASSERT_TRUE(shows("Roof"));
    for (const char* const bus : {"socketcan:nosuch0", "fdcanusb:/dev/there/is/none"}) {
        profile::Profile field = mount("Field");
        field.bus = bus;
        ask(request::Reconnect{field});
        ASSERT_TRUE(shows("Field")) << bus;
        EXPECT_TRUE(fakes::waitUntil([&] { return !alarms.empty(); })) << bus;
        EXPECT_EQ(alarms.front().severity, Severity::Alarm);
        EXPECT_FALSE(alarms.front().what.isEmpty());
        EXPECT_TRUE(alarms.front().remedy.contains(QStringLiteral("on the page Profile")));
        ask(request::Reconnect{mount("Roof")});
        ASSERT_TRUE(shows("Roof")) << bus;
    }
}

// REQ-APP-44
TEST_F(StationThreadTest, AStopBetweenTwoStationsHoldsAtTheNextOne)
{
    thread.start();
    ASSERT_TRUE(shows("Roof"));
    ASSERT_TRUE(getsStuckBetweenTwo());
    ask(request::Stop{});
    ask(request::TakeAuthority{});
    thread.begin(*waiting);
    thread.begin(mount("Roof"));  // nobody has requested a third one
    ASSERT_TRUE(shows("Field"));
    EXPECT_TRUE(fakes::waitUntil([this] { return isStopped; }));
    EXPECT_EQ(refusalOf(lastId - 1), QString());
    EXPECT_EQ(refusalOf(lastId), QStringLiteral("No mount was connected at that moment. Try again."));
    EXPECT_EQ(built, 1);
}

// REQ-APP-44
TEST_F(StationThreadTest, TheProgramEndsBetweenTwoStations)
{
    thread.start();
    ASSERT_TRUE(shows("Roof"));
    ASSERT_TRUE(getsStuckBetweenTwo());
    QSignalSpy finished(&thread, &StationThread::finished);
    Q_EMIT thread.shutDownRequested();
    EXPECT_EQ(finished.count(), 1);
    thread.begin(*waiting);
    EXPECT_EQ(built, 0) << "the answer comes too late";
}

// REQ-APP-44
TEST_F(StationThreadTest, TheProgramEndsWhileTheNextStationIsBuilt)
{
    thread.start();
    ASSERT_TRUE(shows("Roof"));
    ASSERT_TRUE(getsStuckBetweenTwo());
    QSignalSpy started(&thread, &StationThread::started);
    QSignalSpy finished(&thread, &StationThread::finished);
    thread.begin(*waiting);
    Q_EMIT thread.shutDownRequested();
    EXPECT_EQ(finished.count(), 1);
    EXPECT_TRUE(fakes::waitUntil([this] { return built == 1; }));
    EXPECT_TRUE(started.isEmpty());
}

TEST_F(StationThreadTest, NothingIsBegunAnewOnceTheProgramIsToEnd)
{
    thread.start();
    ASSERT_TRUE(shows("Roof"));
    QSignalSpy finished(&thread, &StationThread::finished);
    ask(request::Reconnect{mount("Field")});
    Q_EMIT thread.shutDownRequested();  // the station is already ending
    ASSERT_TRUE(finished.wait(60'000));
    EXPECT_EQ(built, 0);
}

}  // namespace
}  // namespace boresight::app
