// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/target_stream.h"

#include "tests/core/tracking/sky_track.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace boresight;
using namespace boresight::tracking;

namespace {

// A target that rises at `rate` °/s, sent every second with two decimals. The last point is sent at 20 s.
TargetStream risingStream(double rate)
{
    TargetStream stream;
    for (int i = 0; i <= 20; ++i) {
        stream.add(at(i), axes(100, std::round(100.0 * (10 + rate * i)) / 100.0));
    }
    return stream;
}

}  // namespace

// REQ-TRACKING-12: A single command, or points that form no path, mean the last point itself.
TEST(TargetStream, OneCommandIsItsPoint)
{
    TargetStream stream;
    EXPECT_FALSE(stream.target(at(0)));
    EXPECT_FALSE(stream.lastPoint());
    stream.add(at(0), axes(400, 95));
    for (const double time : {0.0, 0.5, 100.0}) {
        const auto target = stream.target(at(time));
        ASSERT_TRUE(target);
        EXPECT_EQ(target->position, axes(400, 95));
        EXPECT_EQ(target->rates, AxisRates{});
        EXPECT_FALSE(target->streaming);
    }
    EXPECT_EQ(stream.lastPoint(), axes(400, 95));
    stream.clear();
    EXPECT_FALSE(stream.target(at(101)));
}

// REQ-TRACKING-401: A stream knows the step between its last two points, and the rms error at the next point of the
// path that is followed. Without a judged path there is no such error. One point and an ended stream have neither.
TEST(TargetStream, KnowsHowWellItsPointsShowTheTarget)
{
    EXPECT_FALSE(TargetStream().error(at(0)));
    const TargetStream rising = risingStream(0.5);
    const auto fine = rising.error(at(20.5));
    ASSERT_TRUE(fine && fine->foretold);
    EXPECT_NEAR(fine->step.degrees(), 0.5, 0.001);
    EXPECT_LT(fine->foretold->degrees(), 0.01);  // the points are rounded to 0.01°
    EXPECT_FALSE(rising.error(at(45)));
    TargetStream coarse;
    coarse.add(at(0), axes(100, 10));
    EXPECT_FALSE(coarse.error(at(0)));
    for (int i = 1; i <= 6; ++i) {
        coarse.add(at(4.0 * i), axes(100, 10 + 5 * i));
    }
    const auto wide = coarse.error(at(24));
    ASSERT_TRUE(wide);
    EXPECT_NEAR(wide->step.degrees(), 5.0, 0.01);
    EXPECT_FALSE(wide->foretold) << "points 5° apart are no path";
}

// Story: at the cable end, where each point is the same, a bent path through the points before it led back for 2 s.
// REQ-TRACKING-12b: A target that turns or stops is followed from the second point on, however long it moved straight.
TEST(TargetStream, APathThatEndsIsLeftAtTheSecondPoint)
{
    TargetStream stream;
    for (int i = 0; i <= 40; ++i) {
        stream.add(at(i), axes(100 + i, 30));
    }
    for (int i = 41; i <= 50; ++i) {
        stream.add(at(i), axes(140, 30));
        const auto target = stream.target(at(i + 0.5));
        EXPECT_LE(skyDistance(target->position, axes(140, 30)), i < 42 ? 1.0 : i < 47 ? 0.7 : 0.01) << i;
    }
}

// Gpredict repeats a P every 0.8 s while the antenna moves, and with some settings for ever.
// REQ-TRACKING-13: Equal or nearly equal points do not disturb.
TEST(TargetStream, ARepeatedPointIsThatPoint)
{
    TargetStream stream;
    for (int i = 0; i < 100; ++i) {
        stream.add(at(0.8 * i), axes(359.9, 30));
        const auto target = stream.target(at(0.8 * i + 0.5));
        ASSERT_EQ(target->position, axes(359.9, 30));
        ASSERT_FALSE(target->streaming);
    }
}

// REQ-TRACKING-13
TEST(TargetStream, NearlyEqualPointsDoNotDisturb)
{
    TargetStream stream;
    for (int i = 0; i < 200; ++i) {
        stream.add(at(0.8 * i), axes(200 + 0.1 * (i % 2), 30));
        for (const double later : {0.0, 0.4, 0.79}) {
            const auto target = stream.target(at(0.8 * i + later));
            ASSERT_LE(skyDistance(target->position, axes(200.05, 30)), 0.12);
            ASSERT_LE(std::abs(target->rates.azimuth.degrees()), 0.1);
        }
    }
}

// REQ-TRACKING-11
TEST(TargetStream, RunsAheadSmoothlyBetweenThePoints)
{
    const TargetStream stream = risingStream(0.5);
    for (const double time : {20.0, 20.3, 20.9, 21.5}) {
        const auto target = stream.target(at(time));
        EXPECT_TRUE(target->streaming);
        EXPECT_NEAR(target->position.elevation.degrees(), 10 + 0.5 * time, 0.02);
        EXPECT_NEAR(target->rates.elevation.degrees(), 0.5, 0.02);
        EXPECT_NEAR(target->position.azimuth.degrees(), 100, 1e-6);
    }
}

// At any speed the target stays within two pauses and 2° of the last point, and ends at that point.
// REQ-TRACKING-14: When the points cease the target is exactly the last one, after two pauses at most. It is never more
// than 2° ahead of the last point.
TEST(TargetStream, AStreamThatStopsEndsExactlyAtItsLastPoint)
{
    for (const double rate : {0.01, 0.1, 0.5, 1.0, 1.5, 2.3}) {
        const TargetStream stream = risingStream(rate);
        const AxisPosition last = *stream.lastPoint();
        for (double time = 20.0; time < 30.0; time += 0.02) {
            const auto target = stream.target(at(time));
            ASSERT_LE(skyDistance(target->position, last), 2.001);
            ASSERT_EQ(target->streaming, target->position != last);
            if (time > 22.0) {
                ASSERT_EQ(target->position, last);
                ASSERT_EQ(target->rates, AxisRates{});
            }
        }
    }
}

// Story: a Gpredict that was tracked well sends nothing and only reads. Going back to its last point swung the antenna
// 1.5° backwards.
// REQ-TRACKING-14a: A client that reads the position every 2 s and sends no point is content. The target continues for
// at most 12 s or 5°, waits there for 12 s more, and only then becomes the last point.
TEST(TargetStream, ASilentClientThatReadsOnIsContent)
{
    for (const double rate : {0.02, 0.1, 0.4, 1.0, 2.3}) {
        TargetStream stream = risingStream(rate);
        const double last = stream.lastPoint()->elevation.degrees();
        const double runsFor = std::min(12.0, 5.0 / rate);
        double before = last - 0.1;
        for (int i = 0; 0.02 * i < 30.0; ++i) {
            const double silent = 0.02 * i;
            if (i % 40 == 5) {
                stream.confirm(at(20.0 + silent));
            }
            const auto target = stream.target(at(20.0 + silent));
            const double elevation = target->position.elevation.degrees();
            if (silent < runsFor + 11.9) {
                ASSERT_TRUE(target->streaming);
                ASSERT_GE(elevation, before) << rate << ' ' << silent;
                ASSERT_NEAR(elevation, last + rate * std::min(silent, runsFor), 0.02 + 0.12 * rate)
                    << rate << ' ' << silent;
                before = elevation;
            } else if (silent > runsFor + 12.1) {
                ASSERT_FALSE(target->streaming);
                ASSERT_EQ(target->position, *stream.lastPoint());
                ASSERT_EQ(target->rates, AxisRates{});
            }
        }
    }
}

// REQ-TRACKING-14a
TEST(TargetStream, AClientThatReadsNoMoreIsNot)
{
    TargetStream stream = risingStream(0.5);
    for (const double time : {20.8, 21.6, 22.4, 23.2}) {
        stream.confirm(at(time));
    }
    EXPECT_TRUE(stream.target(at(25.1))->streaming);
    EXPECT_EQ(stream.target(at(25.3))->position, *stream.lastPoint());
}

// A stream that came back would move the mount again by itself, seconds after it stood still.
// REQ-TRACKING-14a
TEST(TargetStream, ReadingDoesNotBringAnEndedStreamBack)
{
    TargetStream stream = risingStream(0.5);
    EXPECT_EQ(stream.target(at(25))->position, *stream.lastPoint());
    stream.confirm(at(25));
    EXPECT_EQ(stream.target(at(25))->position, *stream.lastPoint());
    EXPECT_EQ(stream.target(at(25.5))->position, *stream.lastPoint());
}

// REQ-TRACKING-12
TEST(TargetStream, AnotherTargetIsTakenAtOnce)
{
    TargetStream stream = risingStream(0.5);
    stream.add(at(21), axes(300, 60));
    EXPECT_EQ(stream.target(at(21.5))->position, axes(300, 60));
    EXPECT_FALSE(stream.target(at(21.5))->streaming);

    TargetStream told = risingStream(0.5);
    told.restart(at(21), axes(100, 20.5));
    EXPECT_EQ(told.target(at(21.5))->position, axes(100, 20.5));
    EXPECT_FALSE(told.target(at(21.5))->streaming);
}

// REQ-TRACKING-12
TEST(TargetStream, WhatIsTooFastOrTooSparseIsNoStream)
{
    TargetStream hand;  // an operator clicks here and there on the sky
    TargetStream sparse;
    for (int i = 0; i < 20; ++i) {
        hand.add(at(i), axes(100 + 5 * i, 10));
        EXPECT_FALSE(hand.target(at(i + 0.9))->streaming);
        sparse.add(at(6 * i), axes(100, 10 + i));
        EXPECT_EQ(sparse.target(at(6 * i + 3))->position, axes(100, 10 + i));
    }
}

// The pauses of Gpredict with its default threshold of 5° and with its finest, while it keeps reading.
// REQ-TRACKING-14c
TEST(TargetStream, SparsePointsOfAReaderAreAStreamIfTheirStepsAreFine)
{
    for (const double step : {0.2, 2.0}) {
        TargetStream stream;
        for (int i = 0; i <= 10; ++i) {
            for (int read = 0; read < 10; ++read) {
                stream.confirm(at(8 * i - 7.9 + 0.8 * read));
            }
            stream.add(at(8 * i), axes(100, 10 + step * i));
        }
        EXPECT_EQ(stream.target(at(81))->streaming, step < 1.0) << step;
    }
}

// Story: a client that floods with P sends eight points within eight milliseconds. A step of 0.1° between two of them
// looked like a satellite at 12°/s.
// REQ-TRACKING-15: A flood of points does not turn rounding into speed.
TEST(TargetStream, AFloodOfPointsIsThinned)
{
    TargetStream stream;
    for (int i = 0; i < 20000; ++i) {
        const double time = 0.001 * i;
        const AxisPosition point = axes(100, std::round(10 * (10 + 0.5 * time)) / 10);
        stream.add(at(time), point);
        const auto target = stream.target(at(time));
        ASSERT_LE(skyDistance(target->position, axes(100, 10 + 0.5 * time)), 0.2) << time;
        ASSERT_EQ(stream.lastPoint(), point);
        if (time > 5.0) {
            ASSERT_TRUE(target->streaming);
            ASSERT_NEAR(target->rates.elevation.degrees(), 0.5, 0.1) << time;
        }
    }
}

// REQ-TRACKING-16: The wrap of the azimuth and the side of the zenith are kept. At the zenith the target does not run
// ahead.
TEST(TargetStream, KeepsTheTurnAndTheSideOfTheZenith)
{
    TargetStream turned;
    TargetStream flipped;
    for (int i = 0; i <= 20; ++i) {
        turned.add(at(i), axes(350 + i, 10));
        flipped.add(at(i), axes(-20 + 0.3 * i, 120 + 0.5 * i));
    }
    const auto onward = turned.target(at(20.5));
    EXPECT_NEAR(onward->position.azimuth.degrees(), 370.5, 0.05);
    EXPECT_NEAR(onward->rates.azimuth.degrees(), 1.0, 0.05);
    const auto over = flipped.target(at(20.5));
    EXPECT_TRUE(over->streaming);
    EXPECT_NEAR(over->position.azimuth.degrees(), -13.85, 0.1);
    EXPECT_NEAR(over->position.elevation.degrees(), 130.25, 0.1);
    EXPECT_NEAR(over->rates.azimuth.degrees(), 0.3, 0.05);
    EXPECT_NEAR(over->rates.elevation.degrees(), 0.5, 0.05);
}

// Through the zenith the azimuth turns by 180° at once: the target must not run after it.
// REQ-TRACKING-16
TEST(TargetStream, AtTheZenithItDoesNotRunAhead)
{
    TargetStream stream;
    for (int i = 0; i <= 40; ++i) {
        const double elevation = 80 + 0.5 * i;
        stream.add(at(i), elevation <= 90 ? axes(10, elevation) : axes(190, 180 - elevation));
        for (double later = 0.0; later < 1.0; later += 0.02) {
            const auto target = stream.target(at(i + later));
            ASSERT_TRUE(std::isfinite(target->rates.azimuth.radians()));
            ASSERT_TRUE(std::isfinite(target->rates.elevation.radians()));
            ASSERT_LE(abs(target->position.azimuth - stream.lastPoint()->azimuth), 45_deg);
            ASSERT_LE(skyDistance(target->position, *stream.lastPoint()), 2.001);
        }
    }
}
