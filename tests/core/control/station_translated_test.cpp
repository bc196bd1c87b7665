// SPDX-License-Identifier: GPL-3.0-or-later
// The decisions of the control do not depend on the language.
#include "tests/core/control/station_rig.h"
#include "tests/fakes/one_word.h"

#include <gmock/gmock.h>

#include <optional>
#include <string>
#include <vector>

namespace boresight {
namespace {

// The events of a mount whose drive falls silent, comes back and then has a fault: states, alarms and log lines,
// without their texts.
class Story
{
public:
    Story()
    {
        EXPECT_TRUE(m_rig.setsOff(100.0, 60.0, Seconds(2.0)));
        for (int loss = 0; loss < 2; ++loss) {
            setSilent(true);
            goOn(Seconds(1.0));
            setSilent(false);
            goOn(Seconds(2.0));
        }
        rearm();
        EXPECT_TRUE(m_rig.point(120.0, 60.0, kOperator));
        for (const int code : {38, 43}) {
            m_rig.azimuth.mode = moteus::Mode::Fault;
            m_rig.azimuth.fault = code;
            goOn(Seconds(1.0));
            rearm();
        }
    }

    std::vector<std::string> told()
    {
        for (const LogEntry& line : m_rig.log.since(0, EventLog::kCapacity)) {
            m_told.push_back("log " + std::to_string(static_cast<int>(line.severity)) + " " +
                             std::to_string(static_cast<int>(line.kind)) + " " + line.alarm.name.toStdString());
        }
        return m_told;
    }

private:
    void setSilent(bool silent)
    {
        m_rig.azimuth.silent = silent;
        m_rig.azimuth.mode = silent ? moteus::Mode::PositionTimeout : m_rig.azimuth.mode;
    }
    void rearm()
    {
        EXPECT_TRUE(m_rig.ask(request::Rearm{}));
        goOn(Seconds(1.5));
    }
    void goOn(Seconds time)
    {
        m_rig.run(time);
        const StationStatus status = m_rig.control.status();
        m_told.push_back("state " + std::to_string(static_cast<int>(status.state)));
        for (const Alarm& alarm : status.alarms) {
            m_told.push_back(
                alarm.name.toStdString() + " " + alarm.about.toStdString() + (alarm.active ? " active " : " over ") +
                (alarm.help == AlarmHelp::None ? "" : "with help ") + (alarm.acknowledged ? "acknowledged" : "new"));
        }
    }

    StationRig m_rig;
    std::vector<std::string> m_told;
};

// Story: a check whether a remedy began with "re-arm" worked in English only and chose the wrong sentence. Where two
// texts differed, one alarm replaced another.
// REQ-CONTROL-502: A translated text decides nothing. Alarms appear, replace each other and disappear, and a re-arm
// completes, in the same way in every language.
TEST(StationTranslated, AlarmsAndRearmAreTheSameInOneWord)
{
    const std::vector<std::string> inEnglish = Story().told();
    EXPECT_THAT(inEnglish, testing::Contains(testing::HasSubstr("drive.answers-again")));
    EXPECT_THAT(inEnglish, testing::Contains(testing::HasSubstr("drive.fault")));
    const fakes::OneWord translator;
    EXPECT_EQ(Text::tr("any text"), QStringLiteral("Wort"));
    EXPECT_EQ(Story().told(), inEnglish);
}

}  // namespace
}  // namespace boresight
