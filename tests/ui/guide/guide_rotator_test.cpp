// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text.h"
#include "core/station/adapters.h"
#include "tests/ui/guide/guide_fixture.h"
#include "ui/guide/guide_connect.h"
#include "ui/guide/guide_directions.h"
#include "ui/guide/guide_ready.h"
#include "ui/guide/guide_zero.h"
#include "ui/link/host_desk.h"

#include <QComboBox>
#include <QCompleter>
#include <QListWidget>
#include <QPlainTextEdit>

// A rotator with its own control box, connected by the guide.
namespace boresight::ui {
namespace {

constexpr int kGs232 = 1;  // index in the list of rotator kinds
constexpr int kRotctld = 2;
constexpr int kHamlib = 3;

class GuideRotatorTest : public GuideTest
{
protected:
    GuideRotatorTest()
    {
        profile::Profile real = *status.profile;
        real.bus = "socketcan:can0";
        putInForce(real);
        open<GuideConnect>(GuideStep::Connect);
        Q_EMIT window.host().adaptersFound(adaptersOf({ftdi}, {{QStringLiteral("can0"), true}}));
    }

    void choose(int kind) { inGuide<QComboBox>("What turns the mount").setCurrentIndex(kind); }
    QComboBox& place() { return inGuide<QComboBox>("Port or address of the rotator"); }
    void enter(const char* where) { place().setEditText(QString::fromLatin1(where)); }
    QString words() { return inGuide<QPlainTextEdit>("Who answers").toPlainText(); }
    bool isShown(const char* name) { return findNamed<QWidget>(guide(), name)->isVisible(); }
    QString whyNoConnect()
    {
        const auto& button = inGuide<QPushButton>("Connect");
        return button.isEnabled() ? QString() : button.toolTip();
    }
    // The station uses the rotator that was applied last.
    void answerAs(const QString& kind)
    {
        status.drives.reset();
        status.line = {.state = MountLine::State::Up, .kind = kind};
        goThroughWithReconnect();
    }

    const RotatorModels kModels{.list = {{202, QStringLiteral("Hamlib EasycommII")},
                                         {901, QStringLiteral("SPID Rot2Prog")},
                                         {902, QStringLiteral("SPID Rot1Prog")}},
                                .problem = {}};
    SerialPortFacts ftdi{.device = QStringLiteral("/dev/ttyUSB0"),
                         .stableName = {},
                         .manufacturer = QStringLiteral("FTDI"),
                         .description = QStringLiteral("FT232R USB UART"),
                         .serialNumber = QStringLiteral("A5069RR4"),
                         .vendor = 0x0403,
                         .product = 0x6001};
};

// REQ-UI-985: The guide lists the kinds of rotator that can be connected, each with the text of its driver, and asks
// for its address: a host with a port, or a serial port with its speed. It says what Connect sends and that nothing
// moves.
TEST_F(GuideRotatorTest, ARotctldIsConnectedByItsAddress)
{
    EXPECT_FALSE(isShown("Port or address of the rotator"));
    choose(kRotctld);
    EXPECT_FALSE(isShown("Adapters of this computer"));
    EXPECT_FALSE(isShown("Scan"));
    EXPECT_FALSE(isShown("Speed of the serial port"));
    EXPECT_TRUE(words().contains(QStringLiteral("rotctld -m 901"))) << words().toStdString();
    EXPECT_TRUE(words().contains(QStringLiteral("Nothing moves")));
    EXPECT_TRUE(whyNoConnect().contains(QStringLiteral("for example 192.168.1.20:4533")))
        << whyNoConnect().toStdString();
    enter("tower.local:4534");
    requests.clear();
    click("Connect");
    const profile::Profile wanted = lastApplied();
    EXPECT_EQ(wanted.bus, "rotctld:tower.local:4534");
    EXPECT_EQ(wanted.azimuth.driver, profile::AxisDriver::Rotctld);
    EXPECT_EQ(wanted.elevation.driver, profile::AxisDriver::Rotctld);
    EXPECT_TRUE(profile::fitsRealMount(wanted));
}

// REQ-UI-985
TEST_F(GuideRotatorTest, AHostAloneHasTheUsualPort)
{
    choose(kRotctld);
    for (const auto& [entered, bus] :
         {std::pair{"tower.local", "rotctld:tower.local:4533"}, std::pair{" 10.0.0.7 ", "rotctld:10.0.0.7:4533"},
          std::pair{"fe80::2", "rotctld:[fe80::2]:4533"}, std::pair{"[fe80::3]", "rotctld:[fe80::3]:4533"},
          std::pair{"[fe80::2]:4600", "rotctld:[fe80::2]:4600"}}) {
        enter(entered);
        requests.clear();
        click("Connect");
        ASSERT_EQ(asked<request::ApplyProfile>().size(), 1u) << entered;
        EXPECT_EQ(lastApplied().bus, bus);
        goThroughWithReconnect();
    }
    enter("::1");
    EXPECT_TRUE(whyNoConnect().contains(QStringLiteral("rotctld -t 4534"))) << "that is this program";
}

// REQ-UI-985
TEST_F(GuideRotatorTest, AGs232RotatorIsConnectedByItsPortOrItsAddress)
{
    choose(kGs232);
    EXPECT_EQ(place().currentText(), QStringLiteral("/dev/ttyUSB0")) << "the only port that may be one";
    inGuide<QComboBox>("Speed of the serial port").setCurrentText(QStringLiteral("4800 Bd"));
    requests.clear();
    click("Connect");
    EXPECT_EQ(lastApplied().bus, "serial:/dev/ttyUSB0");
    EXPECT_EQ(lastApplied().baud, 4800);
    EXPECT_EQ(lastApplied().azimuth.driver, profile::AxisDriver::Gs232);
    goThroughWithReconnect();
    enter("10.0.0.7:4001");
    requests.clear();
    click("Connect");
    EXPECT_EQ(lastApplied().bus, "tcp:10.0.0.7:4001");
}

// REQ-UI-1654: A rotator from Hamlib's list is connected by its model, its serial port and its speed. The list is asked
// for when the kind is chosen. Typing shows those that fit. Without Hamlib the guide says what to install.
TEST_F(GuideRotatorTest, AModelOfHamlibIsConnectedByItsPort)
{
    int wanted = 0;
    QObject::connect(&window.host(), &HostDesk::rotatorModelsWanted, &window, [&] { ++wanted; });
    EXPECT_FALSE(isShown("Model of the rotator"));
    choose(kHamlib);
    EXPECT_EQ(wanted, 1);
    Q_EMIT window.host().rotatorModelsFound(kModels);
    auto& model = inGuide<QComboBox>("Model of the rotator");
    EXPECT_EQ(model.count(), 3);
    EXPECT_TRUE(words().contains(QStringLiteral("Choose the model of the rotator."))) << words().toStdString();
    model.completer()->setCompletionPrefix(QStringLiteral("spid"));
    EXPECT_EQ(model.completer()->completionCount(), 2);
    model.setEditText(QStringLiteral("902 SPID Rot1Prog"));
    EXPECT_EQ(place().currentText(), QStringLiteral("/dev/ttyUSB0")) << "the only port that may be one";
    inGuide<QComboBox>("Speed of the serial port").setCurrentText(QStringLiteral("1200 Bd"));
    EXPECT_TRUE(words().contains(QStringLiteral("starts rotctld"))) << words().toStdString();
    requests.clear();
    click("Connect");
    EXPECT_EQ(lastApplied().bus, "hamlib:902:/dev/ttyUSB0");
    EXPECT_EQ(lastApplied().baud, 1200);
    EXPECT_EQ(lastApplied().azimuth.driver, profile::AxisDriver::Rotctld);
    answerAs(QStringLiteral("rotctld"));
    EXPECT_TRUE(words().contains(QStringLiteral("It answers as: rotctld"))) << words().toStdString();
    choose(kRotctld);
    choose(kHamlib);
    EXPECT_EQ(wanted, 1) << "it is known";
}

// REQ-UI-1654
TEST_F(GuideRotatorTest, WithoutHamlibTheGuideSaysWhatToInstall)
{
    profile::Profile spid = *status.profile;
    spid.azimuth.driver = spid.elevation.driver = profile::AxisDriver::Rotctld;
    spid.bus = "hamlib:901:/dev/ttyS0";
    spid.baud = 600;
    putInForce(spid);
    EXPECT_EQ(inGuide<QComboBox>("What turns the mount").currentIndex(), kHamlib);
    EXPECT_EQ(inGuide<QComboBox>("Speed of the serial port").currentText(), QStringLiteral("600 Bd"));
    EXPECT_EQ(place().currentText(), QStringLiteral("/dev/ttyS0"));
    EXPECT_EQ(inGuide<QComboBox>("Model of the rotator").currentText(), QStringLiteral("901"));
    Q_EMIT window.host().rotatorModelsFound({.problem = QStringLiteral("Install libhamlib-utils")});
    EXPECT_TRUE(whyNoConnect().contains(QStringLiteral("libhamlib-utils"))) << whyNoConnect().toStdString();
    place().setEditText({});
    EXPECT_TRUE(words().contains(QStringLiteral("libhamlib-utils"))) << words().toStdString();
    int wanted = 0;
    QObject::connect(&window.host(), &HostDesk::rotatorModelsWanted, &window, [&] { ++wanted; });
    click("Refresh");
    EXPECT_EQ(wanted, 1) << "after it was installed";
    Q_EMIT window.host().rotatorModelsFound(kModels);
    EXPECT_EQ(inGuide<QComboBox>("Model of the rotator").currentText(), QStringLiteral("901 SPID Rot2Prog"));
}

// REQ-UI-985
TEST_F(GuideRotatorTest, WhatCannotBeAnAddressIsRefusedWithTheReason)
{
    choose(kRotctld);
    for (const char* const host : {"two words", "a/b", "[::1", "x]", "tower:", "tower:99999", "tower:port"}) {
        enter(host);
        EXPECT_TRUE(whyNoConnect().contains(QStringLiteral("is not an address"))) << host;
    }
    enter("localhost");
    EXPECT_TRUE(whyNoConnect().contains(QStringLiteral("rotctld -t 4534"))) << whyNoConnect().toStdString();
    EXPECT_TRUE(words().contains(QStringLiteral("rotctld -t 4534"))) << words().toStdString();
    choose(kGs232);
    for (const char* const port : {"ttyUSB0", "10.0.0.7"}) {
        enter(port);
        EXPECT_TRUE(whyNoConnect().contains(QStringLiteral("is not an address"))) << port;
    }
}

// REQ-UI-985
TEST_F(GuideRotatorTest, EachKindKeepsWhatWasEnteredForIt)
{
    choose(kRotctld);
    enter("tower");
    choose(kGs232);
    EXPECT_EQ(place().currentText(), QStringLiteral("/dev/ttyUSB0"));
    enter("/dev/ttyS0");
    choose(kRotctld);
    EXPECT_EQ(place().currentText(), QStringLiteral("tower"));
    EXPECT_EQ(place().findText(QStringLiteral("/dev/ttyUSB0")), -1) << "no serial port is one of these";
    EXPECT_EQ(place().itemText(0), QStringLiteral("127.0.0.1:4534")) << "beside Boresight on this computer";
    choose(kGs232);
    EXPECT_EQ(place().currentText(), QStringLiteral("/dev/ttyS0"));
}

// REQ-UI-986: If nothing answers, the guide shows the alarm and what to check. A rotator that answers is named, with
// its direction.
TEST_F(GuideRotatorTest, WhatAnswersAndWhatToCheckIsShown)
{
    choose(kRotctld);
    enter("tower.local");
    requests.clear();
    click("Connect");
    answerAs(QStringLiteral("rotctld"));
    EXPECT_TRUE(words().contains(QStringLiteral("It answers as: rotctld"))) << words().toStdString();
    EXPECT_TRUE(words().contains(QStringLiteral("azimuth: 10.0°"))) << words().toStdString();
    EXPECT_FALSE(words().contains(QStringLiteral("firewall")));
    status.line.condition = QStringLiteral("Its sensor is half calibrated");
    give(samples::update(status));
    EXPECT_TRUE(words().contains(status.line.condition)) << words().toStdString();

    status.state = StationState::Disconnected;
    status.alarms = {{.name = QStringLiteral("rotator.line-down"),
                      .what = QStringLiteral("The line to the rotator is down: refused"),
                      .remedy = QStringLiteral("Check the cable")},
                     {.name = QStringLiteral("rotator.no-answer"), .what = QStringLiteral("old"), .active = false}};
    give(samples::update(status));
    EXPECT_TRUE(words().startsWith(QStringLiteral("Not connected. Boresight tries again each second.\n")))
        << words().toStdString();
    EXPECT_TRUE(words().contains(QStringLiteral("is down: refused. Check the cable.")));
    EXPECT_TRUE(words().contains(QStringLiteral("option -t of rotctld")));
    EXPECT_TRUE(words().contains(QStringLiteral("firewall")));
    EXPECT_FALSE(words().contains(QStringLiteral("old")));
    EXPECT_EQ(stepButton(GuideStep::Connect).state(), StepState::NeedsYou);

    status.alarms = {{.name = QStringLiteral("rotator.no-answer"), .what = QStringLiteral("The rotator is silent")}};
    give(samples::update(status));
    EXPECT_TRUE(words().startsWith(QStringLiteral("In use. No answer yet.\n"))) << words().toStdString();

    status.alarms = {{.name = QStringLiteral("rotator.foreign"),
                      .what = QStringLiteral("The device on rotctld:tower.local:4533 is not a rotctld"),
                      .remedy = QStringLiteral("Check the port")}};
    give(samples::update(status));
    EXPECT_TRUE(words().startsWith(QStringLiteral("Not connected. Something else answers there.\n")))
        << words().toStdString();
    EXPECT_TRUE(words().contains(QStringLiteral("is not a rotctld. Check the port.")));
    EXPECT_FALSE(words().contains(QStringLiteral("has power"))) << "it has answered";
}

// Story: for a port without permission the guide asked for the power and the speed of the box.
// REQ-UI-986
TEST_F(GuideRotatorTest, APortThatDoesNotOpenAsksForNothingOfTheBox)
{
    choose(kGs232);
    click("Connect");
    answerAs(QStringLiteral("GS-232"));
    status.state = StationState::Disconnected;
    status.alarms = {{.name = QStringLiteral("rotator.line-down"),
                      .what = QStringLiteral("The line to the rotator is down. Join the group dialout")}};
    give(samples::update(status));
    EXPECT_TRUE(words().contains(QStringLiteral("Join the group dialout."))) << words().toStdString();
    EXPECT_FALSE(words().contains(QStringLiteral("speed"))) << words().toStdString();
    EXPECT_FALSE(words().contains(QStringLiteral("power"))) << words().toStdString();
}

// REQ-UI-986
TEST_F(GuideRotatorTest, WhatIsEnteredStays)
{
    choose(kRotctld);
    enter("tower");
    give(samples::update(status));
    Q_EMIT window.host().adaptersFound(adaptersOf({}, {}));
    EXPECT_EQ(place().currentText(), QStringLiteral("tower"));
    EXPECT_EQ(inGuide<QComboBox>("What turns the mount").currentIndex(), kRotctld);
}

// REQ-UI-987: A rotator with a control box counts its angles itself. The guide offers no change of directions or zeros,
// and says that this is done at the box.
TEST_F(GuideRotatorTest, NothingIsOfferedThatTheBoxDecides)
{
    choose(kRotctld);
    enter("tower");
    requests.clear();
    click("Connect");
    answerAs(QStringLiteral("rotctld"));
    EXPECT_FALSE(stepButton(GuideStep::Protection).isVisible());
    open<GuideDirections>(GuideStep::Directions);
    EXPECT_FALSE(isShown("AZ moved the wrong way"));
    EXPECT_FALSE(isShown("EL moved the wrong way"));
    EXPECT_TRUE(isShown("Both directions are right"));
    open<GuideZero>(GuideStep::Level);
    EXPECT_FALSE(isShown("True elevation of the antenna"));
    EXPECT_FALSE(isShown("Set"));
    EXPECT_TRUE(inGuide<ValueLabel>("What to do").text().contains(QStringLiteral("calibrate the box")));
}

// REQ-UI-1650: The steps of the guide are numbered as shown, even if some steps do not exist for this mount.
TEST_F(GuideRotatorTest, TheStepsAreNumberedAsTheyAreShown)
{
    EXPECT_EQ(stepButton(GuideStep::Directions).accessibleName(), QStringLiteral("Step 3: Turning"));
    choose(kRotctld);
    enter("tower");
    requests.clear();
    click("Connect");
    answerAs(QStringLiteral("rotctld"));
    EXPECT_EQ(stepButton(GuideStep::Connect).accessibleName(), QStringLiteral("Step 1: Connect"));
    EXPECT_EQ(stepButton(GuideStep::Directions).accessibleName(), QStringLiteral("Step 2: Turning"));
    EXPECT_EQ(stepButton(GuideStep::Ready).accessibleName(), QStringLiteral("Step 8: Ready"));
    open<GuideReady>(GuideStep::Ready);
    EXPECT_TRUE(isShown("Go to step 2: Turning"));
    const auto top = [this](const char* name) { return inGuide<StepButton>(name).geometry().top(); };
    EXPECT_EQ(top("Go to step 1: Connect"), top("Go to step 5: North")) << "two columns";
    EXPECT_EQ(top("Go to step 2: Turning"), top("Go to step 6: Site"));
    EXPECT_GT(top("Go to step 2: Turning"), top("Go to step 1: Connect"));
    const int height = inGuide<StepButton>("Go to step 1: Connect").height();
    EXPECT_LT(top("Go to step 2: Turning"), top("Go to step 1: Connect") + 2 * height) << "no gap";
}

}  // namespace
}  // namespace boresight::ui
