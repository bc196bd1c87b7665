// SPDX-License-Identifier: GPL-3.0-or-later
// With the simulated pair, in real time: a second or two each.
#include "app/host_search.h"

#include "core/moteus_mount/link_factory.h"
#include "core/sim_bus/simulated_link.h"
#include "tests/fakes/wait_until.h"

#include <QDir>

#include <gtest/gtest.h>

namespace boresight::app {
namespace {

class HostSearchTest : public testing::Test
{
protected:
    HostSearchTest()
    {
        QObject::connect(&search, &HostSearch::scanned, &search,
                         [this](const ScanResult& result) { results.push_back(result); });
    }

    bool answered(std::size_t count)
    {
        return fakes::waitUntil([this, count] { return results.size() >= count; });
    }

    HostSearch search{makeLink};
    std::vector<ScanResult> results;
};

TEST_F(HostSearchTest, ScansABusOnAThreadOfItsOwnAndTellsWhoIsThere)
{
    search.scan(QStringLiteral("simulated"));
    EXPECT_TRUE(results.empty()) << "nobody waits for it";
    ASSERT_TRUE(answered(1));
    ASSERT_EQ(results[0].drives.size(), 2u);
    EXPECT_EQ(results[0].bus, QStringLiteral("simulated"));
    EXPECT_EQ(results[0].drives[0].id, 1);
    EXPECT_EQ(results[0].drives[1].id, 2);
    EXPECT_EQ(results[0].drives[0].uuid.size(), 36);
    ASSERT_TRUE(results[0].drives[0].voltage);
    EXPECT_GT(*results[0].drives[0].voltage, 10.0);
    ASSERT_TRUE(results[0].drives[1].temperature);
    EXPECT_EQ(results[0].problems, QStringList());
}

TEST_F(HostSearchTest, APortThatIsNotThereIsToldWithItsRemedyAndTheNextScanWorks)
{
    search.scan(QStringLiteral("fdcanusb:/dev/no-such-port"));
    ASSERT_TRUE(answered(1));
    EXPECT_TRUE(results[0].drives.empty());
    ASSERT_EQ(results[0].problems.size(), 1);
    EXPECT_TRUE(results[0].problems[0].contains(QStringLiteral("Plug the adapter in")));
    search.scan(QStringLiteral("simulated"));
    ASSERT_TRUE(answered(2));
    EXPECT_EQ(results[1].drives.size(), 2u);
}

TEST_F(HostSearchTest, ASecondScanDoesNotDisturbTheFirst)
{
    search.scan(QStringLiteral("simulated"));
    search.scan(QStringLiteral("socketcan:can0"));
    ASSERT_TRUE(answered(2));
    EXPECT_EQ(results[0].bus, QStringLiteral("socketcan:can0"));
    EXPECT_FALSE(results[0].problems.isEmpty());
    EXPECT_EQ(results[1].drives.size(), 2u);
}

TEST_F(HostSearchTest, AClosedProgramLeavesNoScanBehind)
{
    {
        HostSearch short_{makeLink};
        short_.scan(QStringLiteral("simulated"));
    }
    search.scan(QStringLiteral("simulated"));
    EXPECT_TRUE(answered(1));
}

// The list itself: HamlibModels.
TEST_F(HostSearchTest, ListsTheModelsOfRotatorsInTheBackground)
{
    RotatorModels models;
    QObject::connect(&search, &HostSearch::rotatorModelsFound, &search, [&](const auto& found) { models = found; });
    search.findRotatorModels();
    EXPECT_TRUE(fakes::waitUntil([&] { return models != RotatorModels{}; }));
    EXPECT_NE(models.list.empty(), models.problem.isEmpty());
}

TEST_F(HostSearchTest, ListsAdaptersAndGpredictInTheBackground)
{
    std::vector<Adapter> adapters;
    bool gpredict = false;
    QObject::connect(&search, &HostSearch::adaptersFound, &search, [&](const auto& found) { adapters = found; });
    QObject::connect(&search, &HostSearch::gpredictFound, &search, [&](const auto&) { gpredict = true; });
    search.findAdapters({});
    search.findGpredict(QDir::tempPath());
    EXPECT_TRUE(fakes::waitUntil([&] { return !adapters.empty() && gpredict; }));
    EXPECT_EQ(adapters.back().bus, QStringLiteral("simulated"));
}

}  // namespace
}  // namespace boresight::app
