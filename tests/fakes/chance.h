// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <random>

// Random numbers that are the same for the same seed.
namespace boresight::fakes {

[[nodiscard]] inline double uniform(std::mt19937_64& random, double from, double to)
{
    return std::uniform_real_distribution<double>(from, to)(random);
}

[[nodiscard]] inline double gaussian(std::mt19937_64& random, double sigma)
{
    return std::normal_distribution<double>(0.0, 1.0)(random) * sigma;
}

}  // namespace boresight::fakes
