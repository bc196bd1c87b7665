// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/inputs/station_elements.h"
#include "tests/core/inputs/elements_fixture.h"
#include "tests/fakes/canned_web.h"

#include <QDir>

#include <gmock/gmock.h>

namespace boresight {
namespace {

using StationDownloads = StationElementsTest;

// REQ-ELEMENTWEB-09: The station downloads the addresses of the profile and uses them like files. Without a network it
// starts with the cache. A problem is in the log once, and in the status while it lasts.
TEST_F(StationDownloads, DownloadsTheAddressesOfTheProfile)
{
    fakes::CannedWeb server;
    server.answersWith("/good", "200 OK", {}, kFirst);
    server.answersWith("/gone", "404 Not Found", {}, {});
    profile::InForce profile(naming({server.address("/good"), server.address("/gone")}));
    {
        StationElements elements(profile, log, clock, nullptr);
        elements.open();
        ASSERT_TRUE(waitFor(elements, 1));
        ASSERT_TRUE(fakes::waitUntil([&] { return !elements.problems().isEmpty(); }));
        const auto isGone = testing::StartsWith(server.address("/gone") + ": The server answers 404 Not Found.");
        EXPECT_THAT(elements.problems().constFirst().toStdString(), isGone);
        EXPECT_THAT(lines(Severity::Warning), testing::ElementsAre(isGone));
        const auto before = profile.shared();
        profile.apply(naming({server.address("/good")}));
        elements.profileChanged(*before, *profile);
        ASSERT_TRUE(fakes::waitUntil([&] { return elements.problems().isEmpty(); }));
        EXPECT_EQ(elements.satellites()->size(), 1U);
    }
    server.stopListening();
    StationElements later(profile, log, clock, nullptr);
    later.open();
    EXPECT_TRUE(waitFor(later, 1)) << "from the cache";
}

// A profile that has only addresses does not use the files of Gpredict while nothing is downloaded.
TEST_F(StationDownloads, WithoutAnAnswerThereAreNoSatellites)
{
    fakes::CannedWeb server;
    server.answersWith("/gone", "404 Not Found", {}, {});
    profile::Profile wanted = naming({server.address("/gone")});
    QDir().mkpath(file() + QStringLiteral("/satdata"));
    wanted.gpredict.folder = file().toStdString();
    profile::InForce profile(wanted);
    StationElements elements(profile, log, clock, nullptr);
    elements.open();
    ASSERT_TRUE(fakes::waitUntil([&] { return !elements.problems().isEmpty(); }));
    EXPECT_THAT(lines(Severity::Warning), testing::SizeIs(1));
}

}  // namespace
}  // namespace boresight
