// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text.h"
#include "core/station/adapters.h"
#include "tests/ui/guide/guide_fixture.h"
#include "ui/guide/guide_connect.h"
#include "ui/guide/guide_directions.h"
#include "ui/guide/guide_zero.h"

#include <QComboBox>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QSpinBox>

// A rotator with a box of its own, connected by the guide.
namespace boresight::ui {
namespace {

constexpr int kGs232 = 1;  // in the list of what turns the mount
constexpr int kRotctld = 2;

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
    QString words() { return inGuide<QPlainTextEdit>("Who answers").toPlainText(); }
    bool isShown(const char* name) { return findNamed<QWidget>(guide(), name)->isVisible(); }
    QString whyNoConnect()
    {
        const auto& button = inGuide<QPushButton>("Connect");
        return button.isEnabled() ? QString() : button.toolTip();
    }
    // The station works on the rotator that was applied last.
    void answerAs(const QString& kind)
    {
        status.drives.reset();
        status.line = {.state = MountLine::State::Up, .kind = kind};
        goThroughWithReconnect();
    }

    SerialPortFacts ftdi{.device = QStringLiteral("/dev/ttyUSB0"),
                         .stableName = {},
                         .manufacturer = QStringLiteral("FTDI"),
                         .description = QStringLiteral("FT232R USB UART"),
                         .serialNumber = QStringLiteral("A5069RR4"),
                         .vendor = 0x0403,
                         .product = 0x6001};
};

// REQ-UI-985: The guide connects a rotator behind a rotctld by host and port, and a GS-232 rotator by its serial port
// or HOST:PORT. It says what Connect asks and that nothing moves.
TEST_F(GuideRotatorTest, ARotctldIsConnectedByHostAndPort)
{
    EXPECT_FALSE(isShown("Host of rotctld"));
    choose(kRotctld);
    EXPECT_FALSE(isShown("Adapters of this computer"));
    EXPECT_FALSE(isShown("Scan"));
    EXPECT_TRUE(words().contains(QStringLiteral("rotctld -m 901"))) << words().toStdString();
    EXPECT_TRUE(words().contains(QStringLiteral("Nothing moves")));
    EXPECT_TRUE(whyNoConnect().contains(QStringLiteral("Enter the host"))) << whyNoConnect().toStdString();
    EXPECT_EQ(inGuide<QSpinBox>("Port of rotctld").value(), 4533);
    inGuide<QLineEdit>("Host of rotctld").setText(QStringLiteral("tower.local"));
    inGuide<QSpinBox>("Port of rotctld").setValue(4534);
    requests.clear();
    click("Connect");
    const profile::Profile wanted = lastApplied();
    EXPECT_EQ(wanted.bus, "rotctld:tower.local:4534");
    EXPECT_EQ(wanted.azimuth.driver, profile::AxisDriver::Rotctld);
    EXPECT_EQ(wanted.elevation.driver, profile::AxisDriver::Rotctld);
    EXPECT_TRUE(profile::fitsRealMount(wanted));
}

// REQ-UI-985
TEST_F(GuideRotatorTest, AGs232RotatorIsConnectedByItsPortOrItsHost)
{
    choose(kGs232);
    auto& line = inGuide<QComboBox>("Port of the rotator");
    EXPECT_EQ(line.currentText(), QStringLiteral("/dev/ttyUSB0")) << "the only port that may be one";
    inGuide<QComboBox>("Speed of the serial port").setCurrentText(QStringLiteral("4800 Bd"));
    requests.clear();
    click("Connect");
    EXPECT_EQ(lastApplied().bus, "serial:/dev/ttyUSB0");
    EXPECT_EQ(lastApplied().baud, 4800);
    EXPECT_EQ(lastApplied().azimuth.driver, profile::AxisDriver::Gs232);
    goThroughWithReconnect();
    line.setEditText(QStringLiteral("10.0.0.7:4001"));
    requests.clear();
    click("Connect");
    EXPECT_EQ(lastApplied().bus, "tcp:10.0.0.7:4001");
}

// REQ-UI-985
TEST_F(GuideRotatorTest, WhatCannotBeAnAddressIsRefusedWithTheReason)
{
    choose(kRotctld);
    for (const char* const host : {"two words", "a/b", "[::1", "x]"}) {
        inGuide<QLineEdit>("Host of rotctld").setText(QString::fromLatin1(host));
        EXPECT_TRUE(whyNoConnect().contains(QStringLiteral("is no address"))) << whyNoConnect().toStdString();
    }
    inGuide<QLineEdit>("Host of rotctld").setText(QStringLiteral("::1"));
    inGuide<QSpinBox>("Port of rotctld").setValue(4600);
    EXPECT_EQ(whyNoConnect(), QString()) << "an IPv6 address needs no brackets here";
    inGuide<QLineEdit>("Host of rotctld").setText(QStringLiteral("localhost"));
    inGuide<QSpinBox>("Port of rotctld").setValue(4533);
    EXPECT_TRUE(whyNoConnect().contains(QStringLiteral("rotctld -t 4534"))) << whyNoConnect().toStdString();
    choose(kGs232);
    inGuide<QComboBox>("Port of the rotator").setEditText(QStringLiteral("ttyUSB0"));
    EXPECT_TRUE(whyNoConnect().contains(QStringLiteral("is no address"))) << whyNoConnect().toStdString();
}

// REQ-UI-986: When nothing answers, the guide shows the alarm and what to check. What answers is named, with where it
// points.
TEST_F(GuideRotatorTest, WhatAnswersAndWhatToCheckIsShown)
{
    choose(kRotctld);
    inGuide<QLineEdit>("Host of rotctld").setText(QStringLiteral("tower.local"));
    requests.clear();
    click("Connect");
    answerAs(QStringLiteral("rotctld"));
    EXPECT_TRUE(words().contains(QStringLiteral("It answers as: rotctld"))) << words().toStdString();
    EXPECT_TRUE(words().contains(QStringLiteral("azimuth: 10.0°"))) << words().toStdString();
    EXPECT_FALSE(words().contains(QStringLiteral("firewall")));

    status.state = StationState::Disconnected;
    status.alarms = {{.name = QStringLiteral("rotator.line-down"),
                      .what = QStringLiteral("The line to the rotator is down: refused"),
                      .remedy = QStringLiteral("Check the cable")},
                     {.name = QStringLiteral("rotator.no-answer"), .what = QStringLiteral("old"), .active = false}};
    give(samples::update(status));
    EXPECT_TRUE(words().contains(QStringLiteral("No answer yet"))) << words().toStdString();
    EXPECT_TRUE(words().contains(QStringLiteral("is down: refused. Check the cable.")));
    EXPECT_TRUE(words().contains(QStringLiteral("option -t of rotctld")));
    EXPECT_TRUE(words().contains(QStringLiteral("firewall")));
    EXPECT_FALSE(words().contains(QStringLiteral("old")));
    EXPECT_EQ(stepButton(GuideStep::Connect).state(), StepState::NeedsYou);
}

// REQ-UI-986
TEST_F(GuideRotatorTest, WhatIsEnteredStays)
{
    choose(kRotctld);
    inGuide<QLineEdit>("Host of rotctld").setText(QStringLiteral("tower"));
    give(samples::update(status));
    Q_EMIT window.host().adaptersFound(adaptersOf({}, {}));
    EXPECT_EQ(inGuide<QLineEdit>("Host of rotctld").text(), QStringLiteral("tower"));
    EXPECT_EQ(inGuide<QComboBox>("What turns the mount").currentIndex(), kRotctld);
}

// REQ-UI-987: A rotator with a box counts its angles itself: the guide offers neither another direction nor another
// zero, and says that this is done at the box.
TEST_F(GuideRotatorTest, NothingIsOfferedThatTheBoxDecides)
{
    choose(kRotctld);
    inGuide<QLineEdit>("Host of rotctld").setText(QStringLiteral("tower"));
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

}  // namespace
}  // namespace boresight::ui
