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

// Describes every setting once. This list is used by the reader and the writer of the file, the commented default file,
// the dialog and the table in the manual. The default is the value in a default Profile. Each list of the profile
// (horizon, keep-outs, presets, watch list, satellites) has such a list for its rows. More than 600 lines with its
// source, which is a table.
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
using SettingValue = std::variant<std::string, std::int64_t, double, TextList>;  // Choice is a string: its word

struct SettingChoice
{
    std::string word;   // in the file, "unwind"
    std::string title;  // English name for people, "Unwrap the cable"; Text::of() translates it
};

template <class Owner>
struct SettingOf
{
    std::string key;    // table and key in the file, "azimuth.travel_min_deg"; in a row only the key
    std::string title;  // English name for people, "Travel from"; Text::of() translates it
    SettingType type = SettingType::Text;
    std::string unit;  // "°/s"; empty: no unit
    double min = 0.0;  // of Integer and Number; both ends are included
    double max = 0.0;
    std::vector<SettingChoice> choices;
    std::string text;  // English sentences about its purpose; Text::of() translates them
    Applies applies = Applies::Now;
    std::function<SettingValue(const Owner&)> get;
    // Refuses a value of the wrong type or out of range, with the reason. The owner is then unchanged.
    std::function<Result<>(Owner&, const SettingValue&)> set;
    // Only in tables whose keys must be given all together or not at all. The value counts only if this returns true.
    std::function<bool(const Owner&)> isGiven = {};
    // Only where the default depends on other settings. Sets the value that a missing key means. If the present value
    // is this one, the writer writes the key as a comment.
    std::function<void(Owner&)> assume = {};
    bool mayBeLeftOut = false;  // in a row: a missing key means the default of the row
    bool secret = false;        // must not appear in logs, diagnostics or on the screen

    [[nodiscard]] bool counts(const Owner& owner) const { return !isGiven || isGiven(owner); }
};

using Setting = SettingOf<Profile>;

[[nodiscard]] std::span<const Setting> settings();
[[nodiscard]] const Setting* findSetting(std::string_view key);

// The names of the lists in the file. Problems name a row as "keep_out[2]" and a key of it as "keep_out[2].name",
// counted from 1.
inline constexpr std::string_view kHorizonKey = "limits.horizon";
inline constexpr std::string_view kKeepOutKey = "keep_out";
inline constexpr std::string_view kPresetKey = "preset";
inline constexpr std::string_view kWatchKey = "watch";
inline constexpr std::string_view kSatelliteKey = "satellite";
inline constexpr std::string_view kAntennaKey = "antenna";

// One per tenth of a degree. The limit exists because the region is computed again with each change.
inline constexpr std::size_t kMaxHorizonPoints = 3600;
// With more keep-outs, the search for a route would delay the control tick (core/pointing/METHOD.md).
inline constexpr std::size_t kMaxKeepOuts = 32;
// More antennas would be confusing to choose from.
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
    QString advice{};  // a sentence about what to do, for a reader of the file; may be empty

    bool operator==(const Problem&) const = default;
};
[[nodiscard]] QString toText(const Problem& problem);  // "KEY: TEXT"
// Conflicts between settings: minimum above maximum, park position where the mount may not be, equal ids, a name used
// twice.
[[nodiscard]] std::vector<Problem> crossCheck(const Profile& profile);
// All problems that reading this profile from its file would report: values out of range, then the conflicts.
[[nodiscard]] std::vector<Problem> problemsOf(const Profile& profile);
// The same for a real mount: in addition, its sensor must not be simulated.
[[nodiscard]] std::vector<Problem> problemsOfReal(const Profile& profile);
// Fails with the first problem of problemsOfReal().
[[nodiscard]] Result<> fitsRealMount(const Profile& profile);

// Parses the text of rotctld.listen, or the command-line option that overrides it.
[[nodiscard]] Result<ListenAddress> parseListenAddress(std::string_view text);  // "127.0.0.1:4533", "[::1]:4533"
[[nodiscard]] std::string toText(const ListenAddress& address);
// True if this rotctld is the server of this station. Then the station would send requests to itself.
[[nodiscard]] bool isOwnServer(const BusName& rotctld, const ListenAddress& own);
// The text of the value in the file.
[[nodiscard]] std::string toText(const SettingValue& value);
// The name of the choice with this word, for people. A word that is no choice stays as it is.
[[nodiscard]] QString choiceName(const std::vector<SettingChoice>& choices, std::string_view word);
// Shown in place of a secret.
inline constexpr const char* kHidden = QT_TRANSLATE_NOOP("Text", "(hidden)");
[[nodiscard]] bool hasSecrets(const Profile& profile);
// The profile for logs and diagnostics: each secret that is set is replaced by kHidden.
[[nodiscard]] Profile withoutSecrets(Profile profile);

}  // namespace boresight::profile
