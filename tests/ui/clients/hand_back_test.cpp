// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/window_fixture.h"
#include "ui/clients/hand_back_prompt.h"
#include "ui/kit/value_label.h"
#include "ui/window/progress_line.h"

#include <QPushButton>

namespace boresight::ui {
namespace {

class HandBackTest : public WindowFixture
{
protected:
    HandBackPrompt& prompt() { return *window.findChild<HandBackPrompt*>(); }
    void press(const QString& text)
    {
        for (QPushButton* const button : prompt().findChildren<QPushButton*>()) {
            if (button->text() == text) {
                button->click();
            }
        }
    }
    void giveTaken(bool taken)
    {
        StationStatus status = samples::operatorMoving();
        status.tookControl = taken;
        give(samples::update(status));
    }
};

// REQ-UI-600: After an act of the operator that took control from waiting clients, one press hands it back.
TEST_F(HandBackTest, IsOfferedWhileClientsWaitAndGivesTheControl)
{
    giveTaken(false);
    EXPECT_FALSE(prompt().isVisible());
    giveTaken(true);
    EXPECT_TRUE(prompt().isVisible());
    press(QStringLiteral("Hand back"));
    EXPECT_EQ(asked<request::GiveAuthority>().size(), 1U);
}

// Story: at 1024×700 the question covered half of the words about the cable, and the legend.
// REQ-UI-1772: No prompt over the sky covers the cable in numbers.
TEST_F(HandBackTest, LeavesTheCableFree)
{
    for (const QSize size : {QSize(1024, 700), QSize(1280, 800), QSize(1920, 1080)}) {
        window.resize(size);
        giveTaken(true);
        QCoreApplication::sendPostedEvents();
        QCoreApplication::processEvents();
        ASSERT_TRUE(prompt().isVisible());
        const QRect bar(prompt().mapTo(&window, QPoint()), prompt().size());
        for (const char* const name : {"Azimuth cable", "Travel of the azimuth cable"}) {
            const auto* const words = named<ValueLabel>(name);
            const QRect place(words->mapTo(&window, QPoint()), words->size());
            EXPECT_FALSE(bar.intersects(place)) << size.width() << " " << name;
        }
    }
}

// REQ-UI-601: "Keep control" applies until control is taken again.
TEST_F(HandBackTest, KeepControlIsRememberedUntilTheControlIsTakenAnew)
{
    giveTaken(true);
    press(QStringLiteral("Keep control"));
    giveTaken(true);
    EXPECT_FALSE(prompt().isVisible());
    EXPECT_TRUE(asked<request::GiveAuthority>().empty());
    giveTaken(false);
    giveTaken(true);
    EXPECT_TRUE(prompt().isVisible());
}

// REQ-UI-602: The header says in one sentence what the mount does, when it will arrive, and by whose request. A line
// below shows how much of the slew is done.
TEST_F(HandBackTest, ASlewSaysWhenItIsThere)
{
    StationStatus status = samples::operatorMoving();
    status.slew = SlewProgress{.remaining = Seconds(8.3), .done = 0.25};
    give(samples::update(status));
    EXPECT_EQ(text("Target and its source"), QStringLiteral("Go to 113.0° 10.0°, there in 9 s, by operator"));
    EXPECT_EQ(window.findChild<ProgressLine*>()->done(), 0.25);
    status.slew.reset();
    give(samples::update(status));
    EXPECT_FALSE(window.findChild<ProgressLine*>()->done());
}

// REQ-UI-603: The header names who has control, the operator or the client that moves the mount, and how many wait. If
// there is little room, the beginning of the name and the number stay.
TEST_F(HandBackTest, TheHeaderNamesWhoHasTheControlAndHowManyWait)
{
    StationStatus status = samples::withClients(samples::tracking(1), 3);
    status.authority = Authority::Clients;
    for (ClientStatus& client : status.clients) {
        client.inControl = false;
        client.wanting = false;
    }
    status.clients[0].inControl = true;
    status.clients[0].program = QStringLiteral("A program with a longer name");
    status.clients[2].wanting = true;
    give(samples::update(status));
    EXPECT_TRUE(text("Who has control").startsWith(QStringLiteral("A prog"))) << "at 1024 px";
    EXPECT_TRUE(text("Who has control").endsWith(QStringLiteral("…, +1")));
    window.resize(1600, 900);
    status.clients[0].program = QStringLiteral("Gpredict");
    give(samples::update(status));
    EXPECT_EQ(text("Who has control"), QStringLiteral("Control: Gpredict, 1 waiting"));
    status.listening.clear();
    give(samples::update(status));
    EXPECT_EQ(text("Who has control"), QStringLiteral("Clients cannot connect"));
}

}  // namespace
}  // namespace boresight::ui
