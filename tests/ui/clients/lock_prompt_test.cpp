// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/clients/lock_prompt.h"

#include "tests/ui/window_fixture.h"
#include "ui/kit/value_label.h"

#include <QAbstractItemModel>
#include <QPushButton>
#include <QTableView>

namespace boresight::ui {
namespace {

class LockPromptTest : public WindowFixture
{
protected:
    LockPrompt& prompt() { return *window.findChild<LockPrompt*>(); }
    void click(const char* name) { QTest::mouseClick(findNamed<QPushButton>(prompt(), name), Qt::LeftButton); }
    void offer(const QString& target, bool isLocked = false)
    {
        StationStatus status = samples::fighting();
        status.clients.resize(1);
        status.clientTarget = RecognisedTarget{.clientId = 1, .name = target, .isLocked = isLocked};
        give(samples::update(status));
    }
};

// REQ-UI-1800: The window offers to track the recognised target of a client from Boresight's own orbit, with every
// panel. Track it and Not now are answers to the station. The prompt is gone when nothing is offered any more.
TEST_F(LockPromptTest, OffersTheTargetOfAClient)
{
    EXPECT_FALSE(prompt().isVisible());
    offer(QStringLiteral("METEOR-M2 4"));
    EXPECT_TRUE(prompt().isVisible());
    EXPECT_EQ(text("Boresight knows the target of a client").toStdString(),
              "Gpredict or SatDump is tracking METEOR-M2 4. Track it from Boresight's own orbit?");
    EXPECT_FALSE(named<ValueLabel>("Boresight knows the target of a client")->isElided());
    elapse(Seconds(1.0));
    click("Track it");
    ASSERT_EQ(asked<request::TrackForClient>().size(), 1U);
    EXPECT_EQ(asked<request::TrackForClient>()[0].clientId, 1U);
    EXPECT_EQ(asked<request::TrackForClient>()[0].target, QStringLiteral("METEOR-M2 4"));
    EXPECT_TRUE(asked<request::TrackForClient>()[0].isWanted);
    offer(QStringLiteral("METEOR-M2 4"), true);
    EXPECT_FALSE(prompt().isVisible());
}

TEST_F(LockPromptTest, NotNowIsAnAnswer)
{
    offer(QStringLiteral("METEOR-M2 4"));
    elapse(Seconds(1.0));
    click("Not now");
    ASSERT_EQ(asked<request::TrackForClient>().size(), 1U);
    EXPECT_FALSE(asked<request::TrackForClient>()[0].isWanted);
    give(samples::update(samples::idle()));
    EXPECT_FALSE(prompt().isVisible());
}

// A press that was meant for the target before does nothing.
TEST_F(LockPromptTest, AnotherTargetNeedsAnotherLook)
{
    offer(QStringLiteral("METEOR-M2 4"));
    elapse(Seconds(1.0));
    offer(QStringLiteral("ISS (ZARYA)"));
    click("Track it");
    EXPECT_TRUE(asked<request::TrackForClient>().empty());
    elapse(Seconds(1.0));
    click("Track it");
    ASSERT_EQ(asked<request::TrackForClient>().size(), 1U);
    EXPECT_EQ(asked<request::TrackForClient>()[0].target, QStringLiteral("ISS (ZARYA)"));
}

// REQ-UI-1801: While Boresight tracks the target of a client, the page Clients shows the target.
TEST_F(LockPromptTest, ThePageClientsNamesTheLockedTarget)
{
    openPanel('4');
    offer(QStringLiteral("METEOR-M2 4"), true);
    const auto* const table = window.findChild<QTableView*>(QStringLiteral("clients"));
    bool isShown = false;
    for (int column = 0; column < table->model()->columnCount(); ++column) {
        const QString cell = table->model()->index(0, column).data().toString();
        isShown = isShown || cell == QLatin1String("Boresight tracks METEOR-M2 4");
    }
    EXPECT_TRUE(isShown);
}

}  // namespace
}  // namespace boresight::ui
