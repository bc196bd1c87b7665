// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

// The mutator's knowledge about one kind of input. Bytes of text and of binary inputs are in std::string.
namespace boresight::fuzz {

struct Grammar
{
    std::vector<std::string> corpus;  // valid inputs, not empty
    std::vector<std::string> tokens;  // words of the language, not empty; also extreme numbers
    std::string separators;           // bytes between words; empty for binary input
    std::size_t maxLength = 1024;
    // The probability of each further mutation of an input, in percent.
    unsigned persistence = 50;
    // Corrects lengths and checksums, so that damaged inputs pass these checks. Most inputs are corrected.
    std::function<void(std::string&)> repair;
};

}  // namespace boresight::fuzz
