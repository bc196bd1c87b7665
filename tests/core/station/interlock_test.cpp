// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/interlock.h"

#include <gtest/gtest.h>

namespace boresight {
namespace {

const Source kOperator{.kind = SourceKind::Operator, .name = QStringLiteral("operator")};
const Source kClient{.kind = SourceKind::Client, .clientId = 1, .name = QStringLiteral("client")};

TEST(Interlock, AdmitsEverybodyAtFirst)
{
    const Interlock interlock;
    EXPECT_TRUE(interlock.admits(kOperator));
    EXPECT_TRUE(interlock.admits(kClient));
}

TEST(Interlock, StopShutsOutEverybodyUntilReset)
{
    Interlock interlock;
    interlock.latchStop();
    EXPECT_EQ(interlock.admits(kOperator).error().code, ErrorCode::Refused);
    EXPECT_EQ(interlock.admits(kClient).error().code, ErrorCode::Refused);
    EXPECT_TRUE(interlock.resetStop());
    EXPECT_TRUE(interlock.admits(kOperator));
}

TEST(Interlock, AfterStopTheClientsWaitForTheOperator)
{
    Interlock interlock;
    interlock.latchStop();
    ASSERT_TRUE(interlock.resetStop());
    EXPECT_FALSE(interlock.admits(kClient));
    interlock.setAuthority(Authority::Clients);
    EXPECT_TRUE(interlock.admits(kClient));
}

TEST(Interlock, ResetWithoutStopIsRefused)
{
    Interlock interlock;
    EXPECT_FALSE(interlock.resetStop());
}

TEST(Interlock, TheFirstFaultOfASeriesIsTheReason)
{
    Interlock interlock;
    interlock.latchFault(QStringLiteral("first"));
    interlock.latchFault(QStringLiteral("second"));
    const auto admitted = interlock.admits(kOperator);
    ASSERT_FALSE(admitted);
    EXPECT_EQ(admitted.error().text, "first: re-arm first");
    interlock.clearFault();
    EXPECT_TRUE(interlock.admits(kOperator));
}

}  // namespace
}  // namespace boresight
