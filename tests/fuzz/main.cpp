// SPDX-License-Identifier: GPL-3.0-or-later
//
// fuzz_NAME [--inputs N] [--seed S]    feeds N (20000) inputs made from seed S (1)
// fuzz_NAME --replay FILE              feeds one input, in this process
//
// A failing input is printed as hexadecimal text with its seed and kept in a file. The last line is
// "NAME: N inputs, N inputs/s, N.N % accepted, N failures". The status is 0 if nothing failed.
#include "core/base/hex.h"
#include "core/base/numbers.h"
#include "tests/fuzz/campaign.h"
#include "tests/fuzz/harness.h"

#include <QLoggingCategory>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <optional>
#include <string>

namespace boresight::fuzz {
namespace {

// A campaign tests little if nearly all its inputs are refused, or nearly all are accepted. With few inputs the share
// is not judged.
constexpr double kLeastAccepted = 5.0;  // percent
constexpr double kMostAccepted = 60.0;
constexpr std::size_t kEnoughForShare = 5'000;

int usage()
{
    std::cerr << "usage: [--inputs N] [--seed S] | --replay FILE\n";
    return EXIT_FAILURE;
}

std::optional<std::map<std::string, std::string>> options(int count, char** words)
{
    std::map<std::string, std::string> given;
    for (int i = 1; i < count; i += 2) {
        const std::string name = words[i];
        if ((name != "--inputs" && name != "--seed" && name != "--replay") || i + 1 == count) {
            return std::nullopt;
        }
        given[name] = words[i + 1];
    }
    return given;
}

int replay(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        std::cerr << path << " cannot be read\n";
        return EXIT_FAILURE;
    }
    const std::string input{std::istreambuf_iterator<char>(file), {}};
    feed(asBytes(input));
    std::cout << "nothing broken, " << (takeAccepted() ? "accepted" : "not accepted") << '\n';
    return EXIT_SUCCESS;
}

void tell(const std::string& name, const Campaign& campaign, const Failure& failure)
{
    const std::string path =
        name + "-seed" + std::to_string(campaign.seed) + "-input" + std::to_string(failure.number) + ".bin";
    std::ofstream(path, std::ios::binary) << failure.input;
    std::cout << name << ": input " << failure.number << " of seed " << campaign.seed << " failed (" << failure.how
              << "), " << failure.input.size() << " bytes:\n"
              << toHex(asBytes(failure.input)) << '\n'
              << "replay it: " << name << " --replay " << std::filesystem::absolute(path).string() << '\n';
}

int feedMany(const std::string& name, const Campaign& campaign)
{
    const Outcome outcome = run(campaign);
    if (outcome.failure) {
        tell(name, campaign, *outcome.failure);
    }
    const double fed = static_cast<double>(outcome.fed);
    const double share = outcome.fed == 0 ? 0.0 : 100.0 * static_cast<double>(outcome.accepted) / fed;
    std::cout << name << ": " << outcome.fed << " inputs, " << formatFixed(fed / outcome.seconds, 0) << " inputs/s, "
              << formatFixed(share, 1) << " % accepted, " << (outcome.failure ? 1 : 0) << " failures\n";
    if (outcome.fed >= kEnoughForShare && (share < kLeastAccepted || share > kMostAccepted)) {
        std::cout << "the accepted share is to lie between " << formatFixed(kLeastAccepted, 0) << " and "
                  << formatFixed(kMostAccepted, 0) << " %: the corpus or the mutations must change\n";
        return EXIT_FAILURE;
    }
    return outcome.failure ? EXIT_FAILURE : EXIT_SUCCESS;
}

}  // namespace
}  // namespace boresight::fuzz

int main(int count, char** words)
{
    using namespace boresight;
    QLoggingCategory::setFilterRules(QStringLiteral("boresight.*=false"));  // a million inputs would log too much
    const auto given = fuzz::options(count, words);
    if (!given) {
        return fuzz::usage();
    }
    if (const auto file = given->find("--replay"); file != given->end()) {
        return given->size() == 1 ? fuzz::replay(file->second) : fuzz::usage();
    }
    fuzz::Campaign campaign;
    for (const auto& [name, text] : *given) {
        const auto number = parseInteger(text);
        if (!number || *number < 0) {
            return fuzz::usage();
        }
        (name == "--seed" ? campaign.seed : campaign.inputs) = static_cast<std::uint64_t>(*number);
    }
    return fuzz::feedMany(std::filesystem::path(words[0]).filename().string(), campaign);
}
