// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/window_fixture.h"
#include "ui/clients/client_model.h"
#include "ui/clients/control_prompt.h"
#include "ui/kit/choice_button.h"

#include <QApplication>
#include <QClipboard>
#include <QPushButton>
#include <QTableView>

namespace boresight::ui {
namespace {

// A Gpredict in control, a logging program that wants control, and a third client that is read-only.
class ClientsPanelTest : public WindowFixture
{
protected:
    ClientsPanelTest()
    {
        give(samples::update(samples::fighting()));
        openPanel('4');
    }

    QTableView& table() { return *named<QTableView>("Clients"); }
    QString cell(int row, ClientModel::Column column) { return table().model()->index(row, column).data().toString(); }
    void select(int row)
    {
        const QRect place = table().visualRect(table().model()->index(row, 0));
        QTest::mouseClick(table().viewport(), Qt::LeftButton, {}, place.center());
    }
    void click(const char* name) { QTest::mouseClick(named<QPushButton>(name), Qt::LeftButton); }
    void choose(const QString& text)
    {
        for (ChoiceButton* const button : window.findChildren<ChoiceButton*>()) {
            if (button->text() == text && button->isVisible()) {
                QTest::mouseClick(button, Qt::LeftButton);
                return;
            }
        }
        ADD_FAILURE() << "no choice " << text.toStdString();
    }
    static StationUpdate with(profile::ControlRule lead, const char* lockedTo, const char* controlObstacle)
    {
        StationStatus status = samples::fighting();
        profile::Profile profile = *status.profile;
        profile.rotctld.control = lead;
        profile.rotctld.lockedTo = lockedTo;
        status.profile = std::make_shared<const profile::Profile>(profile);
        for (ClientStatus& client : status.clients) {
            client.controlObstacle = QLatin1String(controlObstacle);
        }
        return samples::update(status);
    }
};

// Story: a client that sent 6553 commands a second had "655…" in its row.
// REQ-UI-992: The rate in the list of clients is never cut, however large it is.
TEST_F(ClientsPanelTest, NoRateIsCut)
{
    StationStatus status = samples::fighting();
    for (const auto& [rate, text] : std::initializer_list<std::pair<double, const char*>>{{0.0, "0.0"},
                                                                                          {99.94, "99.9"},
                                                                                          {99.96, "100"},
                                                                                          {655.36, "655"},
                                                                                          {999.6, "1.0 k"},
                                                                                          {6553.6, "6.6 k"},
                                                                                          {65536.0, "66 k"},
                                                                                          {655360.0, "655 k"}}) {
        status.clients.front().commandsPerSecond = rate;
        give(samples::update(status));
        EXPECT_EQ(cell(0, ClientModel::Rate).toStdString(), text);
        const QModelIndex index = table().model()->index(0, ClientModel::Rate);
        EXPECT_LE(table().sizeHintForIndex(index).width(), table().columnWidth(ClientModel::Rate)) << text;
    }
}

// REQ-UI-25: The panel Clients shows the connected clients, which of them moves the mount, and by which rule. It shows
// the rule in effect. If a client asks in vain, a prompt over the plot asks the operator, with every panel, until it is
// answered.
TEST_F(ClientsPanelTest, ShowsWhoIsThereAndWhatEachMayDo)
{
    ASSERT_EQ(table().model()->rowCount(), 3);
    EXPECT_EQ(cell(0, ClientModel::Address).toStdString(), "127.0.0.1:51234");
    EXPECT_EQ(cell(0, ClientModel::Program).toStdString(), "Gpredict or SatDump");
    EXPECT_EQ(cell(0, ClientModel::Rate).toStdString(), "1.3");
    EXPECT_EQ(cell(0, ClientModel::LastCommand).toStdString(), "P 339.50 57.00");
    EXPECT_EQ(cell(0, ClientModel::Role).toStdString(), "● in control");
    EXPECT_EQ(cell(1, ClientModel::Role).toStdString(), "▲ waiting");
    EXPECT_EQ(cell(2, ClientModel::Role).toStdString(), "read-only");
    EXPECT_EQ(cell(2, ClientModel::Program).toStdString(), "unknown");
    EXPECT_TRUE(text("About the selected client").contains(QStringLiteral("Set Threshold to 0.1")));
    EXPECT_FALSE(named<ValueLabel>("About the selected client")->isElided());
}

// REQ-UI-1785: The line of the selected client shows how many of its commands were odd, if any were. The tooltips of
// the line and of the row explain what an odd command is.
TEST_F(ClientsPanelTest, CountsTheOddCommandsOfAClient)
{
    const auto detail = [this] { return named<ValueLabel>("About the selected client"); };
    const auto rowHelp = [this](int row) {
        return table().model()->index(row, ClientModel::Address).data(Qt::ToolTipRole).toString();
    };
    select(2);
    EXPECT_EQ(detail()->text().toStdString(), "10.0.0.12:40007: last command p");
    EXPECT_EQ(detail()->toolTip(), QString());
    EXPECT_FALSE(rowHelp(2).contains(QStringLiteral("Odd commands")));
    StationStatus status = samples::fighting();
    status.clients[0].oddCommands = 2;
    status.clients[2].oddCommands = 5;
    give(samples::update(status));
    EXPECT_EQ(detail()->text().toStdString(), "10.0.0.12:40007 (odd commands: 5): last command p");
    const QString help = QStringLiteral("\nOdd commands: 5. A command is odd if");
    EXPECT_TRUE(detail()->toolTip().startsWith(detail()->text() + help));
    EXPECT_TRUE(rowHelp(2).contains(help));
    select(0);
    EXPECT_TRUE(detail()->text().startsWith(QStringLiteral("127.0.0.1:51234 (odd commands: 2): This Gpredict")));
    give(samples::update(samples::fighting()));
    EXPECT_EQ(detail()->toolTip(), QString());
}

// REQ-UI-1786: The advice that Gpredict is about to disengage is complete at 1024×700, with its remedy.
TEST_F(ClientsPanelTest, TheAdviceBeforeGpredictDisengagesIsWhole)
{
    StationStatus status = samples::fighting();
    status.clients[0].advice =
        QStringLiteral("5 errors in a row. Gpredict disengages after 6. Set rotctld.outside_limits to \"nearest\".");
    give(samples::update(status));
    EXPECT_TRUE(text("About the selected client").contains(QStringLiteral("Gpredict disengages after 6")));
    EXPECT_FALSE(named<ValueLabel>("About the selected client")->isElided());
}

// Story: 17 s after the last command of a client the list said that it was "in control", and the header "Control:
// clients".
// REQ-UI-977: A client is shown as in control only while others are refused. Otherwise the client whose target is
// tracked is shown as moving the mount.
TEST_F(ClientsPanelTest, WhoMovesTheMountIsInControlOnlyWhereOthersAreRefused)
{
    StationStatus status = samples::fighting();
    status.clients[0].inControl = false;
    give(samples::update(status));
    EXPECT_EQ(cell(0, ClientModel::Role).toStdString(), "● moves the mount");
    status.clients[0].driving = false;
    status.clients[0].inControl = true;
    give(samples::update(status));
    EXPECT_EQ(cell(0, ClientModel::Role).toStdString(), "in control");
}

TEST_F(ClientsPanelTest, TellsOfTheBrokerIfThereIsToBeOne)
{
    EXPECT_EQ(text("MQTT broker"), QString());
    StationStatus status = samples::fighting();
    status.broker = {.wanted = true, .connected = true, .name = QStringLiteral("broker.example:1883")};
    give(samples::update(status));
    EXPECT_EQ(text("MQTT broker").toStdString(), "Connected to the MQTT broker broker.example:1883");
    status.broker.connected = false;
    give(samples::update(status));
    EXPECT_EQ(text("MQTT broker").toStdString(), "Connecting to the MQTT broker broker.example:1883");
    status.broker.problem = QStringLiteral("MQTT broker broker.example:1883: no connection");
    status.broker.retryIn = Seconds(3.2);
    give(samples::update(status));
    EXPECT_EQ(text("MQTT broker").toStdString(),
              "MQTT broker broker.example:1883: no connection (next attempt in 4 s)");
}

TEST_F(ClientsPanelTest, NothingCanBeDoneAboutNobody)
{
    for (const char* const name : {"Give control", "Read-only", "Disconnect", "Lock"}) {
        EXPECT_FALSE(named<QPushButton>(name)->isEnabled()) << name;
        EXPECT_TRUE(named<QPushButton>(name)->toolTip().endsWith(QStringLiteral("Select a client first."))) << name;
        click(name);
    }
    EXPECT_TRUE(requests.empty());
}

TEST_F(ClientsPanelTest, GivesControlToTheSelectedOne)
{
    select(0);
    EXPECT_FALSE(named<QPushButton>("Give control")->isEnabled()) << "it has it";
    select(1);
    click("Give control");
    ASSERT_EQ(asked<request::GiveControl>().size(), 1U);
    EXPECT_EQ(asked<request::GiveControl>()[0].clientId, 2U);
}

TEST_F(ClientsPanelTest, RowsThatMoveKeepTheirSelection)
{
    select(1);
    StationStatus left = samples::fighting();
    left.clients.erase(left.clients.begin());
    give(samples::update(left));
    EXPECT_EQ(table().currentIndex().row(), 0);
    click("Disconnect");
    ASSERT_EQ(asked<request::Disconnect>().size(), 1U);
    EXPECT_EQ(asked<request::Disconnect>()[0].clientId, 2U);
    left.clients.erase(left.clients.begin());
    give(samples::update(left));
    EXPECT_FALSE(named<QPushButton>("Disconnect")->isEnabled()) << "the selected one has left";
}

TEST_F(ClientsPanelTest, MakesReadOnlyAndBack)
{
    select(1);
    click("Read-only");
    select(2);
    click("May move");
    const auto set = asked<request::SetReadOnly>();
    ASSERT_EQ(set.size(), 2U);
    EXPECT_EQ(set[0].clientId, 2U);
    EXPECT_TRUE(set[0].readOnly);
    EXPECT_EQ(set[1].clientId, 3U);
    EXPECT_FALSE(set[1].readOnly);
}

TEST_F(ClientsPanelTest, WorksByKeys)
{
    table().setFocus();  // this makes the first line the current one
    QTest::keyClick(&table(), Qt::Key_Down);
    EXPECT_EQ(table().currentIndex().row(), 1);
    QTest::keyClick(&table(), Qt::Key_Tab);
    EXPECT_EQ(QApplication::focusWidget(), named<QPushButton>("Give control"));
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
    EXPECT_EQ(asked<request::GiveControl>().size(), 1U);
}

TEST_F(ClientsPanelTest, LocksToTheHostOfTheSelectedOne)
{
    select(1);
    click("Lock");
    const auto applied = asked<request::ApplyProfile>();
    ASSERT_EQ(applied.size(), 1U);
    EXPECT_EQ(applied[0].profile.rotctld.control, profile::ControlRule::Locked);
    EXPECT_EQ(applied[0].profile.rotctld.lockedTo, "192.168.100.109");
    profile::Profile otherwise = applied[0].profile;
    otherwise.rotctld.control = profile::ControlRule::First;
    otherwise.rotctld.lockedTo.clear();
    EXPECT_EQ(otherwise, *samples::fighting().profile) << "nothing else is changed";
}

// REQ-UI-25
TEST_F(ClientsPanelTest, TheRuleFollowsTheStatusNotTheClick)
{
    choose(QStringLiteral("Last"));
    const auto applied = asked<request::ApplyProfile>();
    ASSERT_EQ(applied.size(), 1U);
    EXPECT_EQ(applied[0].profile.rotctld.control, profile::ControlRule::Last);
    EXPECT_TRUE(
        named<ChoiceButton>("The first client moves the mount until it disconnects or commands no motion for 10 s")
            ->isChecked());
    StationUpdate answer = with(profile::ControlRule::Last, "", "whoever sends last moves the mount");
    answer.answers.push_back({requests.back().id, std::nullopt});
    give(answer);
    EXPECT_TRUE(
        named<ChoiceButton>("The client that sent the last target moves the mount, as with Hamlib")->isChecked());
    select(1);
    EXPECT_FALSE(named<QPushButton>("Give control")->isEnabled()) << "whoever sends last moves it";
}

TEST_F(ClientsPanelTest, ARefusedRuleSaysWhyAndLeavesNoEdit)
{
    choose(QStringLiteral("Last"));
    give(samples::refusal(samples::fighting(), requests.back().id, "the mount moves"));
    bool said = false;
    for (const ValueLabel* const label : window.findChildren<ValueLabel*>()) {
        said = said || label->text() == QStringLiteral("Control goes to: the mount moves");
    }
    EXPECT_TRUE(said);
    requests.clear();
    choose(QStringLiteral("Last"));
    EXPECT_EQ(asked<request::ApplyProfile>().size(), 1U);
}

TEST_F(ClientsPanelTest, WhoIsLockedOutCanNotBeGivenControl)
{
    give(with(profile::ControlRule::Locked, "10.0.0.77", "The mount is locked to 10.0.0.77. Unlock it first."));
    select(1);
    EXPECT_TRUE(named<QPushButton>("Give control")
                    ->toolTip()
                    .endsWith(QStringLiteral("The mount is locked to 10.0.0.77. Unlock it first.")));
    choose(QStringLiteral("First"));
    ASSERT_EQ(asked<request::ApplyProfile>().size(), 1U);
    EXPECT_EQ(asked<request::ApplyProfile>()[0].profile.rotctld.control, profile::ControlRule::First);
    EXPECT_EQ(asked<request::ApplyProfile>()[0].profile.rotctld.lockedTo, "");
}

TEST_F(ClientsPanelTest, CopiesWhatGpredictMustBeTold)
{
    click("Copy the settings for Gpredict");
    EXPECT_EQ(QApplication::clipboard()->text().toStdString(),
              "Gpredict: Edit > Preferences > Interfaces > Rotators > Add New\n"
              "Host: address of this computer\n"
              "Port: 4533\n"
              "Az type: 0° → 180° → 360°\n"
              "Min Az: 0  Max Az: 360  Min El: 0  Max El: 90\n"
              "Antenna Control: Cycle 1000 msec, Threshold 0.1 deg\n");
}

TEST_F(ClientsPanelTest, ShowsWhoMayConnect)
{
    EXPECT_EQ(text("Who may connect").toStdString(), "Every computer that reaches 0.0.0.0:4533 may connect");
    StationStatus status = samples::fighting();
    profile::Profile profile = *status.profile;
    profile.rotctld.allow = {"127.0.0.1", "10.0.0.0/8"};
    status.profile = std::make_shared<const profile::Profile>(profile);
    give(samples::update(status));
    EXPECT_EQ(text("Who may connect").toStdString(), "May connect to 0.0.0.0:4533: 127.0.0.1, 10.0.0.0/8");
    give(samples::update(samples::idle()));
    EXPECT_EQ(text("Who may connect").toStdString(), "Any program on this computer may connect (127.0.0.1:4533)");
}

class ControlPromptTest : public WindowFixture
{
protected:
    ControlPromptTest()
    {
        give(samples::update(samples::fighting()));
        elapse(Seconds(1.0));
    }
    ControlPrompt& prompt() { return *window.findChild<ControlPrompt*>(); }
    void click(const char* name) { QTest::mouseClick(findNamed<QPushButton>(prompt(), name), Qt::LeftButton); }
};

// REQ-UI-25 (ControlPromptTest.*)
TEST_F(ControlPromptTest, AsksOverThePlotWhateverPanelIsOpen)
{
    EXPECT_TRUE(prompt().isVisible());
    EXPECT_EQ(text("A client asks for control").toStdString(), "192.168.100.109 asks for control");
    EXPECT_FALSE(named<ValueLabel>("A client asks for control")->isElided());
    click("Allow control");
    ASSERT_EQ(asked<request::GiveControl>().size(), 1U);
    EXPECT_EQ(asked<request::GiveControl>()[0].clientId, 2U);
    give(samples::update(samples::idle()));
    EXPECT_FALSE(prompt().isVisible()) << "nobody wants to any more";
}

TEST_F(ControlPromptTest, WhoIsIgnoredIsNotAskedAboutAgain)
{
    click("Ignore");
    give(samples::update(samples::fighting()));
    EXPECT_FALSE(prompt().isVisible());
    EXPECT_TRUE(asked<request::GiveControl>().empty());
    StationStatus another = samples::fighting();
    another.clients[1].id = 7;  // its program has reconnected
    give(samples::update(another));
    EXPECT_TRUE(prompt().isVisible());
}

// Story: the second press of a double click gave control back to the client that had just lost it.
TEST_F(ControlPromptTest, TheSecondPressOfADoubleClickGivesNothing)
{
    click("Allow control");
    StationStatus other = samples::fighting();
    std::swap(other.clients[0].id, other.clients[1].id);
    give(samples::acceptance(other, requests.back().id));
    click("Allow control");
    EXPECT_EQ(asked<request::GiveControl>().size(), 1U);
    elapse(Seconds(1.0));
    click("Allow control");
    ASSERT_EQ(asked<request::GiveControl>().size(), 2U);
    EXPECT_EQ(asked<request::GiveControl>()[1].clientId, 1U);
}

TEST_F(ControlPromptTest, AsksAboutOneUntilThatIsAnswered)
{
    StationStatus two = samples::fighting();
    two.clients[0].wanting = true;  // an earlier client wants it, too
    two.clients[0].address = QStringLiteral("192.168.100.109:40001");
    give(samples::update(two));
    EXPECT_EQ(text("A client asks for control").toStdString(), "192.168.100.109:50112 asks for control");
    click("Allow control");
    ASSERT_EQ(asked<request::GiveControl>().size(), 1U);
    EXPECT_EQ(asked<request::GiveControl>()[0].clientId, 2U);
}

}  // namespace
}  // namespace boresight::ui
