// SPDX-License-Identifier: GPL-3.0-or-later
// Profile files: gives any bytes to parseProfile(). An accepted profile is written and must read back as the same
// profile.
#include "core/profile/profile_file.h"
#include "core/profile/setting.h"
#include "tests/fakes/text_of.h"
#include "tests/fuzz/harness.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

namespace boresight::fuzz {
namespace {

using namespace boresight::profile;

constexpr std::size_t kProfileMaxInput = 2048;

bool isControl(unsigned char byte)
{
    return byte < 0x20 || byte == 0x7f;
}

void checkError(const std::string& text, std::size_t inputSize)
{
    require(!text.empty(), "a refused profile has a reason");
    require(text.size() < 4096 + 100 * inputSize, "the reason is no longer than the file deserves");
    for (std::size_t start = 0; start <= text.size();) {
        const std::size_t end = std::min(text.find('\n', start), text.size());
        const std::string line = text.substr(start, end - start);
        require(line.starts_with("a.toml:"), "each line of the reason begins with file and line");
        require(std::none_of(line.begin(), line.end(), isControl), "the reason is printable");
        start = end + 1;
    }
}

void checkAccepted(const Profile& profile)
{
    require(problemsOf(profile).empty(),
            "an accepted profile has its values in their ranges and makes sense as a whole");
    for (const Setting& setting : settings()) {
        const SettingValue value = setting.get(profile);
        if (const auto* const number = std::get_if<double>(&value)) {
            require(std::isfinite(*number), "an accepted number is finite");
        }
    }
}

void checkWrittenBack(const Profile& profile)
{
    const std::string written = toToml(profile);
    const auto again = parseProfile(written, QStringLiteral("b.toml"));
    require(again.has_value(), "a written profile can be read");
    require(*again == profile, "a written profile reads back as it was");
    require(toToml(*again) == written, "writing it again changes nothing");
}

std::string fileText(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::string withoutComments(const std::string& toml)
{
    std::string text;
    for (std::size_t start = 0; start < toml.size();) {
        const std::size_t end = std::min(toml.find('\n', start), toml.size() - 1) + 1;
        if (toml[start] != '#') {
            text += toml.substr(start, end - start);
        }
        start = end;
    }
    return text;
}

}  // namespace

Grammar grammar()
{
    const std::string whole = withoutComments(toToml(Profile{}));
    Grammar grammar;
    grammar.corpus = {
        whole,
        fileText(BORESIGHT_TEST_DATA "/dummy-like.toml"),
        "version = 1\n",
        "version = 1\n[mount]\nname = \"mast 2 \\u00e9\"\n[bus]\nname = \"fdcanusb:/dev/ttyACM0\"\n",
        "version = 1\nmount.name = 'x'\njog = {slow_deg_s = 0.1, normal_deg_s = 1, fast_deg_s = 2.5}\n",
        "version = 1\n[bus]\nname = \"socketcan:can0\"\n[azimuth]\nid = 3\nsign = -1\noffset_deg = -12.5\n"
        "gear_ratio = 61.5\ngear_in = \"host\"\ntravel_min_deg = -270\ntravel_max_deg = 270\n",
        "version = 1\n[control]\ntick_hz = 100\nwatchdog_s = 0.05\non_exit = \"brake\"\n[rotctld]\n"
        "listen = \"[::1]:4533\"\nazimuth = \"-180..180\"\nmax_clients = 5\n",
        "version = 1\n[limits]\nazimuth_min_deg = -10\nhorizon = [[0, -5], [90.5, -3.25],]\n[[keep_out]]\nname = "
        "\"mast\"\n"
        "azimuth_from_deg = 350\nazimuth_to_deg = 10\nelevation_min_deg = 40\nelevation_max_deg = 90\n[[keep_out]]\n"
        "name = \"roof\"\nazimuth_from_deg = 80\nazimuth_to_deg = 81.5\nelevation_min_deg = -90\nelevation_max_deg = "
        "-5\n",
        "version = 1\n[[preset]]\nname = \"north\"\nazimuth_deg = 0\nelevation_deg = 180\n[site]\nlatitude_deg = "
        "-33.9\n"
        "longitude_deg = 151.2\nheight_m = 12\n",
        "version = 1\n[rotctld]\nallow = [\"10.0.0.0/8\", \"fe80::1%eth0\"]\nlead = \"locked\"\nlocked_to = \"::1\"\n"};
    grammar.tokens = {"=",
                      "[",
                      "]",
                      "[[",
                      "]]",
                      "{",
                      "}",
                      ",",
                      ".",
                      "\"",
                      "'",
                      "\"\"\"",
                      "'''",
                      "#",
                      "\n",
                      "\r\n",
                      "true",
                      "false",
                      "1979-05-27T07:32:00Z",
                      "07:32:00",
                      "\\u0000",
                      "\\u007f",
                      "\\u001b",
                      "\\n",
                      "\\\"",
                      "\\\\",
                      "\\U0010ffff",
                      "\\ud800",
                      "\xc3\xa9",
                      "\xff",
                      "\xef\xbb\xbf",
                      "\"°\"",
                      "1e-10",
                      "0.0000000004",
                      "0x7fffffffffffffff",
                      "0b1",
                      "-0.0",
                      "version = 1\n",
                      "version"};
    for (const Setting& setting : settings()) {
        grammar.tokens.push_back(setting.key.substr(setting.key.find('.') + 1));
        grammar.tokens.push_back("[" + setting.key.substr(0, setting.key.find('.')) + "]\n");
        for (const SettingChoice& choice : setting.choices) {
            grammar.tokens.push_back("\"" + choice.word + "\"");
        }
    }
    for (const char* const token :
         {"[[keep_out]]\n", "[[preset]]\n", "horizon", "[0.0, 0.0],", "name", "azimuth_from_deg", "azimuth_to_deg",
          "elevation_min_deg", "elevation_max_deg", "azimuth_deg", "elevation_deg", "[]", "359.999999", "\"::1\"",
          "\"10.0.0.0/8\"", "%", "/"}) {
        grammar.tokens.push_back(token);
    }
    grammar.separators = " \n=[]\"";
    grammar.maxLength = kProfileMaxInput;
    grammar.persistence = 30;
    return grammar;
}

void feed(std::span<const std::uint8_t> input)
{
    const auto profile = parseProfile(asText(input), QStringLiteral("a.toml"));
    if (!profile) {
        checkError(textOf(profile.error()), input.size());
        return;
    }
    accept();
    checkAccepted(*profile);
    checkWrittenBack(*profile);
}

}  // namespace boresight::fuzz
