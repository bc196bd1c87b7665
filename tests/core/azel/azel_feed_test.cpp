// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/azel/azel_feed.h"

#include "tests/fakes/manual_clock.h"
#include "tests/fakes/text_of.h"

#include <gmock/gmock.h>

namespace boresight::azel {
namespace {

using std::chrono::hours;
using std::chrono::seconds;
using testing::HasSubstr;

const QString kPath = QStringLiteral("/some/azel.dat");

class AzelFeedTest : public ::testing::Test
{
protected:
    // Writes a text with the time of this computer's clock, or this much later.
    void write(Seconds later = Seconds(0.0), const QString& path = kPath)
    {
        const auto utc = std::chrono::floor<seconds>(clock.utc() + std::chrono::round<UtcTime::duration>(later));
        const AzelText text{.timeOfDay = utc - std::chrono::floor<std::chrono::days>(utc),
                            .moon = {105.3_deg, 59.9_deg}};
        feed.take({.path = path, .text = text, .written = clock.utc()}, clock.now(), clock.utc());
    }
    void spoil(const QString& why)
    {
        feed.take({.path = kPath, .text = failure(ErrorCode::NoAnswer, why)}, clock.now(), clock.utc());
    }
    void writeFor(int count, Seconds later = Seconds(0.0))
    {
        for (int i = 0; i < count; ++i) {
            clock.advance(Seconds(1.0));
            write(later);
        }
    }
    [[nodiscard]] std::string whyNotFresh() const
    {
        const Result<> fresh = feed.isFresh(clock.now());
        return fresh ? std::string() : textOf(fresh.error());
    }

    fakes::ManualClock clock;
    AzelFeed feed;
};

// REQ-AZEL-905: The file is fresh while its time advances. It is not fresh before its first change, and from 30 s after
// the last change.
TEST_F(AzelFeedTest, IsFreshWhileItsTimeGoesOn)
{
    EXPECT_EQ(whyNotFresh(), "the file was not read yet");
    write();
    EXPECT_THAT(whyNotFresh(), HasSubstr("nothing writes the file")) << "it may be of yesterday at this time";
    writeFor(2);
    EXPECT_EQ(whyNotFresh(), "");
    clock.advance(seconds(30));
    EXPECT_EQ(whyNotFresh(), "");
    EXPECT_EQ(feed.age(clock.now(), clock.utc()), Seconds(30.0));
    clock.advance(seconds(1));
    EXPECT_THAT(whyNotFresh(), HasSubstr("nothing writes the file"));
    writeFor(1);
    EXPECT_EQ(whyNotFresh(), "");
}

// REQ-AZEL-906: A file whose time is more than 30 s off the clock of this computer is not fresh, and the reason names
// the difference. A smaller difference is known. Midnight between the two times is not a difference of a day.
TEST_F(AzelFeedTest, TheClocksAreCompared)
{
    writeFor(2, Seconds(-20.0));
    EXPECT_EQ(whyNotFresh(), "");
    EXPECT_NEAR(feed.clockOff().count(), 20.0, 1.0);
    writeFor(2, Seconds(-90.0));
    EXPECT_THAT(whyNotFresh(), HasSubstr("differ by 9"));
    writeFor(2, Seconds(90.0));
    EXPECT_THAT(whyNotFresh(), HasSubstr("differ by 9"));

    const auto midnight = std::chrono::ceil<std::chrono::days>(clock.utc() + hours(1));
    clock.stepUtc(midnight - clock.utc() + std::chrono::milliseconds(200));
    for (const Seconds later : {Seconds(-1.0), Seconds(-2.0), Seconds(1.0)}) {
        write(later);
        EXPECT_EQ(whyNotFresh(), "") << later.count();
        EXPECT_LT(std::chrono::abs(feed.time() - clock.utc()), seconds(3));
    }
}

// REQ-AZEL-907: While a text cannot be read the last complete text is used. After 3 s this is reported, until the next
// complete text.
TEST_F(AzelFeedTest, WhatCannotBeReadIsReportedAfterAWhile)
{
    spoil(QStringLiteral("gone"));
    EXPECT_EQ(feed.problem(clock.now()).toStdString(), "gone") << "there is no text to go on with";
    EXPECT_EQ(whyNotFresh(), "gone");
    writeFor(2);
    EXPECT_EQ(feed.problem(clock.now()).toStdString(), "");
    spoil(QStringLiteral("empty"));
    clock.advance(seconds(2));
    spoil(QStringLiteral("cut"));
    EXPECT_EQ(feed.problem(clock.now()).toStdString(), "");
    EXPECT_TRUE(feed.text());
    clock.advance(seconds(1));
    EXPECT_EQ(feed.problem(clock.now()).toStdString(), "cut");
    EXPECT_EQ(whyNotFresh(), "") << "its last text is not old yet";
    writeFor(1);
    EXPECT_EQ(feed.problem(clock.now()).toStdString(), "");
    write(Seconds(0.0), QStringLiteral("/another/azel.dat"));
    EXPECT_THAT(whyNotFresh(), HasSubstr("nothing writes the file")) << "nothing is known of another file";
}

}  // namespace
}  // namespace boresight::azel
