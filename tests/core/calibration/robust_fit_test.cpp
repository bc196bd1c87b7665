// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/robust_fit.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

namespace boresight::calibration {
namespace {

// A straight line 2 + 3 x with noise of 0.1. Every fifth value is far off to one side.
RobustProblem line(int rows, bool outliers, unsigned seed = 1)
{
    std::mt19937_64 random(seed);
    std::normal_distribution<double> noise(0.0, 0.1);
    RobustProblem problem(2);
    for (int i = 0; i < rows; ++i) {
        const double x = static_cast<double>(i) / rows;
        problem.add(std::array{1.0, x}, 2.0 + 3.0 * x + noise(random) + (outliers && i % 5 == 0 ? 7.0 : 0.0));
    }
    return problem;
}

TEST(RobustFit, FindsALineAndItsSigma)
{
    const auto fit = fitRobustly(line(400, false), 0.01);
    ASSERT_TRUE(fit.has_value());
    EXPECT_NEAR(fit->solution[0], 2.0, 0.03);
    EXPECT_NEAR(fit->solution[1], 3.0, 0.05);
    EXPECT_NEAR(fit->rms, 0.1, 0.01);
    // For n values over 0…1 with a slope: σ √(4/n) for the start, σ √(12/n) for the slope.
    EXPECT_NEAR(std::sqrt(fit->variance(0)), 0.1 * std::sqrt(4.0 / 400), 0.002);
    EXPECT_NEAR(std::sqrt(fit->variance(1)), 0.1 * std::sqrt(12.0 / 400), 0.003);
}

TEST(RobustFit, IsNotLedAstrayByAFifthOfOutliers)
{
    const auto fit = fitRobustly(line(400, true), 0.01);
    ASSERT_TRUE(fit.has_value());
    EXPECT_NEAR(fit->solution[0], 2.0, 0.04);
    EXPECT_NEAR(fit->solution[1], 3.0, 0.06);
    for (std::size_t i = 0; i < 400; i += 5) {
        EXPECT_FALSE(fit->used[i]) << i;
    }
    EXPECT_GE(fit->usedRows(), 310U);
}

TEST(RobustFit, TheSigmaIsHonestForFewRows)
{
    int inside = 0;
    int fitted = 0;
    constexpr int kRuns = 1000;
    for (unsigned seed = 0; seed < kRuns; ++seed) {
        const auto fit = fitRobustly(line(8, false, seed), 0.01);
        if (fit) {
            ++fitted;
            inside += std::abs(fit->solution[0] - 2.0) < 2.0 * std::sqrt(fit->variance(0)) ? 1 : 0;
        }
    }
    EXPECT_GE(fitted, kRuns * 80 / 100);
    EXPECT_GE(inside, fitted * 93 / 100);
}

TEST(RobustFit, AWeightIsAnInverseSquareOfNoise)
{
    std::mt19937_64 random(3);
    std::normal_distribution<double> noise;
    RobustProblem problem(1);
    for (int i = 0; i < 1000; ++i) {
        const bool good = i % 2 == 0;
        problem.add(std::array{1.0}, noise(random) * (good ? 0.1 : 0.2), good ? 1.0 : 0.25);
    }
    const auto fit = fitRobustly(problem, 0.001);
    ASSERT_TRUE(fit.has_value());
    EXPECT_NEAR(fit->rms, 0.1, 0.006);
    EXPECT_NEAR(std::sqrt(fit->variance(0)), 0.1 / std::sqrt(500 * 1.25), 0.0005);
}

TEST(RobustFit, IsNothingWhereTheRowsDoNotDetermineTheUnknowns)
{
    RobustProblem same(2);
    for (int i = 0; i < 50; ++i) {
        same.add(std::array{1.0, 1.0}, i);
    }
    EXPECT_FALSE(fitRobustly(same, 0.01).has_value());
    EXPECT_FALSE(fitRobustly(line(2, false), 0.01).has_value());
    EXPECT_FALSE(fitRobustly(RobustProblem(2), 0.01).has_value());
}

// A drift from the first row to the last: the rows are hardly independent of each other.
TEST(RobustFit, SaysWhenTheRowsDriftTogether)
{
    RobustProblem drift(1);
    for (int i = 0; i < 50; ++i) {
        drift.add(std::array{1.0}, 0.1 * i);
    }
    const auto fit = fitRobustly(drift, 0.01);
    ASSERT_TRUE(fit.has_value());
    EXPECT_LT(fit->free, 1.0);
    EXPECT_GT(std::sqrt(fit->variance(0)), fit->rms);
}

}  // namespace
}  // namespace boresight::calibration
