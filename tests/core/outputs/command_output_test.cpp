// SPDX-License-Identifier: GPL-3.0-or-later
// Real programs are started.
#include "core/outputs/command_output.h"

#include "tests/fakes/wait_until.h"

#include <QFile>
#include <QTemporaryDir>

#include <gmock/gmock.h>

#include <memory>
#include <string>
#include <vector>

namespace boresight::outputs {
namespace {

using testing::ElementsAre;
using testing::StartsWith;

// Long enough for a slow computer.
constexpr programs::Limits kPatient{.longest = std::chrono::minutes(1), .patience = std::chrono::minutes(1), .most = 1};

// The program for "on" runs until letGo("on").
const QString kOnHangs = QStringLiteral(
    "echo $2 >>\"$0/journal\"; test $2 = off && exit; while [ ! -e \"$0/go-on\" ]; do sleep 0.05; done; "
    "echo late >>\"$0/journal\"");

// Each program runs until letGo() of its word. The one for "on" fails.
const QString kBothHang = QStringLiteral(
    "echo $2 >>\"$0/journal\"; while [ ! -e \"$0/go-$2\" ]; do sleep 0.05; done; test $2 = off && exit; "
    "echo late >>\"$0/journal\"; exit 1");

class CommandOutputTest : public testing::Test
{
protected:
    // A script that receives its own folder as $0, its other argument as $1, and "on" or "off" as $2.
    void begin(const QString& script)
    {
        output = std::make_unique<CommandOutput>(
            QStringLiteral("/bin/sh"),
            QStringList{QStringLiteral("-c"), script, folder.path(), QStringLiteral("an argument")}, kPatient);
        QObject::connect(output.get(), &Output::reached, output.get(),
                         [this](bool on) { told.emplace_back(on ? "on" : "off"); });
        QObject::connect(output.get(), &Output::failed, output.get(),
                         [this](const QString& reason) { told.push_back(reason.toStdString()); });
    }
    // "off" runs while "on" still does.
    void switchOffDuringOn(const QString& script)
    {
        begin(script);
        output->set(true);
        ASSERT_TRUE(fakes::waitUntil([this] { return journal() == "on\n"; }));
        output->set(false);
        ASSERT_TRUE(fakes::waitUntil([this] { return journal() == "on\noff\n"; }));
    }
    [[nodiscard]] bool tells(std::size_t count) const
    {
        return fakes::waitUntil([this, count] { return told.size() >= count; });
    }
    [[nodiscard]] QByteArray journal() const
    {
        QFile file(folder.filePath(QStringLiteral("journal")));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    void letGo(const char* word) const
    {
        QFile go(folder.filePath(QStringLiteral("go-%1").arg(QLatin1String(word))));
        ASSERT_TRUE(go.open(QIODevice::WriteOnly));
    }

    // The process of a program that wrote its number is gone, so its end is known before that of a later one.
    [[nodiscard]] bool hasEnded(const char* word) const
    {
        QFile number(folder.filePath(QStringLiteral("pid-%1").arg(QLatin1String(word))));
        return number.open(QIODevice::ReadOnly) &&
               !QFile::exists(QStringLiteral("/proc/%1").arg(QString::fromLatin1(number.readAll().trimmed())));
    }

    QTemporaryDir folder;
    std::unique_ptr<CommandOutput> output;
    std::vector<std::string> told;
};

// REQ-TRANSMIT-16: The program runs with "on" or "off" after its arguments, when the state changes. An exit status
// other than 0 is reported, with the error output of the program.
TEST_F(CommandOutputTest, RunsWhenTheStateChanges)
{
    begin(QStringLiteral("echo \"$1 $2\" >>\"$0/journal\""));
    output->set(false);
    ASSERT_TRUE(tells(1));
    output->set(false);
    ASSERT_EQ(told.size(), 2U) << "it is off, and says so without a program";
    output->set(true);
    ASSERT_TRUE(tells(3));
    output->set(true);
    output->set(false);
    ASSERT_TRUE(tells(5));
    EXPECT_THAT(told, ElementsAre("off", "off", "on", "on", "off"));
    EXPECT_EQ(journal(), "an argument off\nan argument on\nan argument off\n");
}

// REQ-TRANSMIT-16
TEST_F(CommandOutputTest, ATroubleIsToldAndTriedAgain)
{
    begin(QStringLiteral("echo no radio >&2; test $2 = off"));
    output->set(true);
    ASSERT_TRUE(tells(1));
    EXPECT_THAT(told.back(), StartsWith("/bin/sh ended with status 1 after "));
    EXPECT_THAT(told.back(), testing::EndsWith(": no radio"));
    output->set(false);
    ASSERT_TRUE(tells(2));
    EXPECT_EQ(told.back(), "off");
    output = std::make_unique<CommandOutput>(QStringLiteral("/no/such/program"), QStringList{});
    std::string reason;
    QObject::connect(output.get(), &Output::failed, output.get(),
                     [&reason](const QString& text) { reason = text.toStdString(); });
    output->set(false);
    EXPECT_TRUE(fakes::waitUntil([&] { return !reason.empty(); }));
    EXPECT_EQ(reason, "/no/such/program could not be started: No such file or directory");
}

// REQ-TRANSMIT-17: "off" does not wait for an "on" that hangs, and runs once more when both have ended.
TEST_F(CommandOutputTest, OffDoesNotWaitForOn)
{
    ASSERT_NO_FATAL_FAILURE(switchOffDuringOn(kOnHangs));
    ASSERT_TRUE(tells(1));
    EXPECT_FALSE(output->isIdle()) << "\"on\" still runs";
    letGo("on");
    ASSERT_TRUE(fakes::waitUntil([this] { return journal() == "on\noff\nlate\noff\n"; }));
    ASSERT_TRUE(tells(2)) << "an \"off\" without a word of its end would never be let go";
    EXPECT_THAT(told, ElementsAre("off", "off"));
    EXPECT_TRUE(output->isIdle());
}

// An "on" that ends while "off" runs may have taken effect last. So that "off" does not count.
// REQ-TRANSMIT-17
TEST_F(CommandOutputTest, OffRunsAgainWhenOnEndedWithinIt)
{
    ASSERT_NO_FATAL_FAILURE(switchOffDuringOn(kBothHang));
    letGo("on");
    ASSERT_TRUE(tells(1)) << "\"on\" failed";
    EXPECT_FALSE(output->isIdle()) << "\"off\" still runs";
    letGo("off");
    ASSERT_TRUE(tells(2));
    EXPECT_EQ(journal(), "on\noff\nlate\noff\n");
    EXPECT_EQ(told.back(), "off");
    EXPECT_TRUE(output->isIdle());
}

// Story: "on" was wanted again while "on" and "off" still ran. The end of that "on" counted, although "off" took effect
// after it.
// REQ-TRANSMIT-17
TEST_F(CommandOutputTest, OnRunsAgainWhenOffRanBesideIt)
{
    ASSERT_NO_FATAL_FAILURE(switchOffDuringOn(QStringLiteral(
        "echo $$ >\"$0/pid-$2\"; echo $2 >>\"$0/journal\"; while [ ! -e \"$0/go-$2\" ]; do sleep 0.05; done")));
    output->set(true);
    letGo("on");
    ASSERT_TRUE(fakes::waitUntil([this] { return hasEnded("on"); }));
    letGo("off");
    ASSERT_TRUE(tells(1));
    EXPECT_EQ(journal(), "on\noff\non\n");
    EXPECT_THAT(told, ElementsAre("on"));
}

// REQ-TRANSMIT-17
TEST_F(CommandOutputTest, TheLastWordIsOffAlsoWhereOnEndedWithinIt)
{
    ASSERT_NO_FATAL_FAILURE(switchOffDuringOn(kBothHang));
    letGo("on");
    ASSERT_TRUE(tells(1));
    letGo("off");
    output.reset();  // it has not yet received the end of "off"
    EXPECT_EQ(journal(), "on\noff\nlate\noff\n");
}

// A station lets go of an output that it no longer needs when a signal comes and the output is idle.
// REQ-TRANSMIT-17
TEST_F(CommandOutputTest, AnOutputThatIsNotIdleGivesASignalLater)
{
    begin(kBothHang);
    output->set(true);
    output->set(false);
    output->set(true);
    output->set(false);
    letGo("on");
    letGo("off");
    bool wasIdle = false;
    QObject::connect(output.get(), &outputs::Output::reached, output.get(), [&] { wasIdle = output->isIdle(); });
    EXPECT_TRUE(fakes::waitUntil([&] { return wasIdle; }));
    EXPECT_EQ(told.back(), "off");
}

// REQ-TRANSMIT-17
TEST_F(CommandOutputTest, TheLastWordAtItsEndIsOff)
{
    begin(QStringLiteral("echo $2 >>\"$0/journal\""));
    output->set(true);
    ASSERT_TRUE(tells(1));
    output->set(false);
    output.reset();
    EXPECT_EQ(journal(), "on\noff\n");
}

// REQ-TRANSMIT-17
TEST_F(CommandOutputTest, TheLastWordIsOffAlsoWhereOnHangs)
{
    ASSERT_NO_FATAL_FAILURE(switchOffDuringOn(kOnHangs));
    ASSERT_TRUE(tells(1));
    letGo("on");
    output.reset();  // it has not yet received the end of "on"
    EXPECT_EQ(journal(), "on\noff\nlate\noff\n");
}

}  // namespace
}  // namespace boresight::outputs
