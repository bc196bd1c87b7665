// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/fuzz/grammar.h"

#include <cstdint>
#include <random>
#include <string>

// Makes damaged, strange and valid inputs from valid ones. Bits, bytes, words and numbers are changed, left out,
// repeated, exchanged, or taken from other inputs. The same grammar, seed and calls give the same inputs on every
// computer.
namespace boresight::fuzz {

class Mutator
{
public:
    Mutator(Grammar grammar, std::uint64_t seed);

    [[nodiscard]] std::string next();
    // `input` was accepted: later inputs may be derived from it.
    void keep(const std::string& input);

private:
    struct Part
    {
        std::size_t start;
        std::size_t size;
    };

    [[nodiscard]] std::size_t below(std::size_t count);  // 0…count-1; 0 for 0
    [[nodiscard]] bool percent(unsigned chance) { return below(100) < chance; }
    [[nodiscard]] const std::string& anyValid();
    [[nodiscard]] const std::string& anyToken();
    [[nodiscard]] Part anyPart(const std::string& text, std::size_t longest);
    [[nodiscard]] Part anyWord(const std::string& text);
    [[nodiscard]] Part anyNumber(const std::string& text);

    void mutate(std::string& text);
    void mutateBytes(std::string& text);
    void mutateWords(std::string& text);
    void mutateShape(std::string& text);
    void exchangeWords(std::string& text);

    Grammar m_grammar;
    std::mt19937_64 m_random;
    std::vector<std::string> m_kept;
};

}  // namespace boresight::fuzz
