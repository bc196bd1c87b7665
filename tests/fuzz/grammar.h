// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

// What the mutator knows of one kind of input. Bytes, text or not, are held as std::string.
namespace boresight::fuzz {

struct Grammar
{
    std::vector<std::string> corpus;  // valid inputs, not empty
    std::vector<std::string> tokens;  // words of the language, not empty; also numbers at their extremes
    std::string separators;           // bytes between words; empty for binary input
    std::size_t maxLength = 1024;
    // Each further mutation of one input is this likely, in percent.
    unsigned persistence = 50;
    // Makes lengths and checksums right again, so that damage gets past them; most inputs are repaired.
    std::function<void(std::string&)> repair;
};

}  // namespace boresight::fuzz
