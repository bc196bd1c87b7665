// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/profile_saver.h"

#include "tests/app/profile_rig.h"
#include "tests/fakes/wait_until.h"

#include <QFile>
#include <QTimer>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <vector>

namespace boresight::app {
namespace {

// In the order of arrival on the main thread.
struct Answers
{
    explicit Answers(const ProfileSaver& saver)
    {
        QObject::connect(&saver, &ProfileSaver::nextFound, &context,
                         [this](const profile::Profile& profile) { found.push_back(profile); });
        QObject::connect(&saver, &ProfileSaver::failed, &context, [this](const QString& reason) { failed << reason; });
    }
    [[nodiscard]] bool waitForNext(std::size_t count = 1) const
    {
        return fakes::waitUntil([&] { return found.size() >= count; });
    }
    [[nodiscard]] bool waitForFailure() const
    {
        return fakes::waitUntil([&] { return !failed.isEmpty(); });
    }

    QObject context;
    std::vector<profile::Profile> found;
    QStringList failed;
};

// Story: when the folder of the profiles did not respond, choosing another mount blocked the window.
// REQ-APP-44: No slow disk blocks the window when another mount is chosen. STOP and the end of the program work
// meanwhile.
TEST(ProfileSaver, ADiskThatHangsHoldsUpNobody)
{
    ProfileRig rig;
    rig.keep(realMount("Field"));
    rig.keep(realMount());
    ProfileSaver saver(rig.options);
    Answers answers(saver);
    const QByteArray path = QFile::encodeName(rig.options.profilePath);
    ASSERT_TRUE(QFile::remove(rig.options.profilePath));
    ASSERT_EQ(mkfifo(path.constData(), 0600), 0);  // opening it waits for a writer
    saver.findNext(realMount("Field"));
    QFile writer(rig.options.profilePath);
    ASSERT_TRUE(writer.open(QIODevice::WriteOnly | QIODevice::Unbuffered)) << "the worker reads it";
    bool turned = false;
    QTimer::singleShot(0, &saver, [&turned] { turned = true; });
    EXPECT_TRUE(fakes::waitUntil([&turned] { return turned; })) << "the window goes on";
    EXPECT_TRUE(answers.found.empty());
    writer.close();
    ASSERT_TRUE(answers.waitForNext());
    EXPECT_EQ(answers.found[0], realMount("Field"));
}

TEST(ProfileSaver, WhatIsAskedForIsDoneInItsOrder)
{
    ProfileRig rig;
    rig.keep(realMount("Field"));
    rig.keep(realMount());
    ProfileSaver saver(rig.options);
    Answers answers(saver);
    profile::Profile changed = realMount();
    changed.jog.slow = 0.7_deg_s;
    saver.save(changed);
    saver.findNext(realMount("Field"));
    saver.findNext(changed);
    ASSERT_TRUE(answers.waitForNext(2));
    EXPECT_EQ(answers.found[0], realMount("Field"));
    EXPECT_EQ(answers.found[1], changed);
    EXPECT_EQ(rig.loaded(), changed);
    EXPECT_EQ(*rig.store().findCurrent(), rig.options.profilePath);
}

TEST(ProfileSaver, ItsEndWaitsForTheLastChange)
{
    ProfileRig rig;
    rig.keep(realMount());
    profile::Profile changed = realMount();
    for (const auto speed : {0.6_deg_s, 0.7_deg_s}) {
        ProfileSaver saver(rig.options);
        changed.jog.slow = speed;
        saver.save(changed);
    }
    EXPECT_EQ(rig.loaded(), changed);
}

TEST(ProfileSaver, SaysWhyItCouldNot)
{
    ProfileRig rig;
    rig.options.profile = realMount();
    rig.options.profilePath = rig.folder.filePath(QStringLiteral("gone.toml"));
    ProfileSaver saver(rig.options);
    Answers answers(saver);
    profile::Profile wanted = realMount();
    wanted.jog.slow = 0.7_deg_s;
    saver.save(wanted);
    ASSERT_TRUE(answers.waitForFailure());
    EXPECT_TRUE(answers.failed.constFirst().contains(QStringLiteral("gone.toml")));
}

// The previous mount continues, and the operator reads the reason.
TEST(ProfileSaver, SaysWhyTheNextStationIsNotTheOneThatWasWanted)
{
    ProfileRig rig;
    rig.keep(realMount());
    ProfileSaver saver(rig.options);
    Answers answers(saver);
    profile::Profile unfit = realMount("Field");
    unfit.sensor.source = profile::SensorSource::Simulated;
    saver.findNext(unfit);
    ASSERT_TRUE(answers.waitForNext());
    EXPECT_EQ(answers.found[0], realMount());
    ASSERT_EQ(answers.failed.size(), 1);
    EXPECT_TRUE(answers.failed.constFirst().startsWith(QStringLiteral("sensor.source: ")));
}

TEST(ProfileSaver, SaysOnceSomebodyListensThatTheFirstSimulationIsNotKept)
{
    ProfileRig rig;
    QFile file(rig.state());
    ASSERT_TRUE(file.open(QIODevice::WriteOnly)) << "a file where a folder should be";
    ProfileSaver saver(rig.options);
    EXPECT_EQ(saver.first(), rig.options.profile);
    Answers answers(saver);
    ASSERT_TRUE(answers.waitForFailure());
    EXPECT_TRUE(answers.failed.constFirst().contains(rig.state()));
}

}  // namespace
}  // namespace boresight::app
