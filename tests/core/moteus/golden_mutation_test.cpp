// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/moteus/exercise.h"
#include "tests/core/moteus/golden.h"

#include <gtest/gtest.h>

#include <random>

namespace boresight::moteus {
namespace {

// exercise() aborts on a broken promise, and the sanitizers abort on a bad access.
// REQ-MOTEUS-10 (GoldenMutation.*): No received frame can crash the program: every truncation of every recorded frame,
// 20,000 seeded mutations, and random inputs. The random inputs found an identity register sent as f32 whose value did
// not fit an integer, and an infinite position that counted as measured.
TEST(GoldenMutation, EveryTruncationIsSurvived)
{
    int tried = 0;
    for (CanFrame frame : golden::allFrames()) {
        while (frame.size > 0) {
            --frame.size;
            exercise(frame);
            ++tried;
        }
    }
    EXPECT_GT(tried, 0);
}

class Mutator
{
public:
    explicit Mutator(std::vector<CanFrame> frames) : m_frames(std::move(frames)) {}

    CanFrame next()
    {
        CanFrame frame = m_frames[below(m_frames.size())];
        for (std::size_t i = 0, count = 1 + below(6); i < count; ++i) {
            mutate(frame);
        }
        return frame;
    }

private:
    std::size_t below(std::size_t limit) { return std::uniform_int_distribution<std::size_t>(0, limit - 1)(m_random); }

    void mutate(CanFrame& frame)
    {
        const std::size_t place = below(kMaxCanPayload);
        switch (below(5)) {
            case 0:  // flip a bit
                frame.data[place % std::max<std::size_t>(frame.size, 1)] ^= static_cast<std::uint8_t>(1U << below(8));
                break;
            case 1:  // any byte
                frame.data[place] = static_cast<std::uint8_t>(below(256));
                break;
            case 2:  // any length, with the bytes that are there
                frame.size = static_cast<std::uint8_t>(below(kMaxCanPayload + 1));
                break;
            case 3:  // the tail of another frame
            {
                const CanFrame& other = m_frames[below(m_frames.size())];
                std::copy(other.data.begin() + static_cast<std::ptrdiff_t>(place), other.data.end(),
                          frame.data.begin() + static_cast<std::ptrdiff_t>(place));
                break;
            }
            default:
                frame.id ^= 1U << below(29);
                break;
        }
    }

    std::mt19937 m_random{20261121};  // seeded, so that a failure can be repeated
    std::vector<CanFrame> m_frames;
};

TEST(GoldenMutation, SeededMutationsAreSurvived)
{
    constexpr int kTries = 20'000;
    auto frames = golden::allFrames();
    ASSERT_FALSE(frames.empty());
    Mutator mutator(std::move(frames));
    for (int i = 0; i < kTries; ++i) {
        exercise(mutator.next());
    }
}

}  // namespace
}  // namespace boresight::moteus
