// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/bus_name.h"
#include "core/base/result.h"
#include "core/base/text.h"
#include "core/profile/profile.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

// Every setting, described once: the file's reader and writer, the commented default file, the dialog and the manual's
// table are made from this list. The default is what a default Profile holds. The rows of the profile's lists (horizon,
// keep-outs, presets, watch list, satellites) are described in the same way, each with a list of its own.
namespace boresight::profile {

enum class SettingType
{
    Text,
    Integer,
    Number,
    Choice,  // one of `choices`
    TextList
};

enum class Applies
{
    Now,
    OnReconnect
};

using TextList = std::vector<std::string>;
using SettingValue = std::variant<std::string, std::int64_t, double, TextList>;  // Choice is a string

template <class Owner>
struct SettingOf
{
    std::string key;    // "azimuth.travel_min_deg": table and key of the file; of a row only the key
    std::string title;  // "Travel from": its name for people; English, to be shown by Text::of()
    SettingType type = SettingType::Text;
    std::string unit;  // "°/s"; empty without one
    double min = 0.0;  // of Integer and Number, ends included
    double max = 0.0;
    std::vector<std::string> choices;
    std::string text;  // what it does, in sentences; English, to be shown by Text::of()
    Applies applies = Applies::Now;
    std::function<SettingValue(const Owner&)> get;
    // Refuses a value of a wrong type or outside the range, with the reason. Then the owner stays unchanged.
    std::function<Result<>(Owner&, const SettingValue&)> set;
    // Set where the keys of a table are given all together or not at all; then the value counts only if this holds.
    std::function<bool(const Owner&)> isGiven = {};
    // Set where the default depends on other settings: makes the value that a file without the key means. The writer
    // leaves the key out, as a comment, where it says nothing else.
    std::function<void(Owner&)> assume = {};
    bool mayBeLeftOut = false;  // of a row: it then has the default of the row
    bool secret = false;        // not for logs, diagnostics and eyes over the shoulder; the file has it

    [[nodiscard]] bool counts(const Owner& owner) const { return !isGiven || isGiven(owner); }
};

using Setting = SettingOf<Profile>;

[[nodiscard]] std::span<const Setting> settings();
[[nodiscard]] const Setting* findSetting(std::string_view key);

// What the lists are called in the file; problems name a row "keep_out[2]" and what it holds "keep_out[2].name",
// from 1.
inline constexpr std::string_view kHorizonKey = "limits.horizon";
inline constexpr std::string_view kKeepOutKey = "keep_out";
inline constexpr std::string_view kPresetKey = "preset";
inline constexpr std::string_view kWatchKey = "watch";
inline constexpr std::string_view kSatelliteKey = "satellite";
inline constexpr std::string_view kAntennaKey = "antenna";

// One per tenth of a degree: the region is laid out again whenever it changes.
inline constexpr std::size_t kMaxHorizonPoints = 3600;
// More would make the control tick wait for the search for a way (core/pointing/METHOD.md).
inline constexpr std::size_t kMaxKeepOuts = 32;
// More antennas cannot be chosen at a glance.
inline constexpr std::size_t kMaxAntennas = 12;

// The settings of one row of each list, in the order of the file. They apply at once.
[[nodiscard]] std::span<const SettingOf<pointing::HorizonPoint>> horizonSettings();
[[nodiscard]] std::span<const SettingOf<pointing::KeepOut>> keepOutSettings();
[[nodiscard]] std::span<const SettingOf<Preset>> presetSettings();
[[nodiscard]] std::span<const SettingOf<schedule::WatchEntry>> watchSettings();
[[nodiscard]] std::span<const SettingOf<orbit::SatelliteMark>> satelliteSettings();
[[nodiscard]] std::span<const SettingOf<pointing::Antenna>> antennaSettings();

struct Problem
{
    std::string key;
    QString text;

    bool operator==(const Problem&) const = default;
};
[[nodiscard]] QString toText(const Problem& problem);  // "KEY: TEXT"
// What one setting alone does not show: min below max, park where the mount may be, different ids, names used once.
[[nodiscard]] std::vector<Problem> crossCheck(const Profile& profile);
// Everything that reading the profile's own file would complain of: ranges, then the above.
[[nodiscard]] std::vector<Problem> problemsOf(const Profile& profile);
// The same for a mount that is not simulated: its sensor is not simulated either.
[[nodiscard]] std::vector<Problem> problemsOfReal(const Profile& profile);
// Fails with the first problem of problemsOfReal().
[[nodiscard]] Result<> fitsRealMount(const Profile& profile);

// The text of rotctld.listen, also for the command line that overrides it.
[[nodiscard]] Result<ListenAddress> parseListenAddress(std::string_view text);  // "127.0.0.1:4533", "[::1]:4533"
[[nodiscard]] std::string toText(const ListenAddress& address);
// True if this rotctld is the server of this station. Then the station would send requests to itself.
[[nodiscard]] bool isOwnServer(const BusName& rotctld, const ListenAddress& own);
// What the setting would look like in the file, without its key.
[[nodiscard]] std::string toText(const SettingValue& value);
// What a secret that is set looks like where it must not be read.
inline constexpr const char* kHidden = QT_TRANSLATE_NOOP("Text", "(hidden)");
[[nodiscard]] bool hasSecrets(const Profile& profile);
// The profile for logs and diagnostics: each secret that is set is replaced by kHidden.
[[nodiscard]] Profile withoutSecrets(Profile profile);

}  // namespace boresight::profile
