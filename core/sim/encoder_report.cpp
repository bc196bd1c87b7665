// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim/encoder_report.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace boresight::sim {
namespace {

constexpr double kCountsPerTurn = 16384.0;                      // of the encoder on the board
constexpr double kStep = 16777216.0;                            // positions have steps of 2^-24 turns
constexpr std::int64_t kCountsPerStep = std::int64_t{1} << 24;  // one step in counts of 2^-48 turns

std::int64_t counts(double turns)
{
    return std::llround(turns * kStep) * kCountsPerStep;
}

float shown(std::int64_t counts)
{
    return static_cast<float>(static_cast<double>(counts) / kStep / static_cast<double>(kCountsPerStep));
}

std::vector<ArchiveField> slot(const std::string& name, bool used, double fraction)
{
    const auto cpr = static_cast<float>(used ? fraction * kCountsPerTurn : 0.0);
    const ArchiveUnsigned raw{static_cast<std::uint64_t>(cpr), 4};
    std::vector<ArchiveField> fields{
        {"active_velocity", used}, {"active_theta", used}, {"active_absolute", used}, {"raw", raw}};
    for (const char* const unused : {"time_since_update", "old_delta", "prev_time_since_update"}) {
        fields.push_back({unused, 0.0F});
    }
    fields.push_back({"slow_count", ArchiveUnsigned{255, 1}});
    for (const char* const unused : {"hall_prev_dt", "hall_v2", "hall_bias_est"}) {
        fields.push_back({unused, 0.0F});
    }
    fields.push_back({"nonce", ArchiveUnsigned{0, 1}});
    fields.push_back({"offset_value", raw});
    fields.push_back({"compensated_value", cpr});
    fields.push_back({"filtered_value", cpr});
    fields.push_back({"integral", 0.0F});
    fields.push_back({"velocity", 0.0F});
    for (ArchiveField& field : fields) {
        field.name = "sources." + name + '.' + field.name;
    }
    return fields;
}

}  // namespace

std::vector<ArchiveField> encoderReport(const RotorEncoder& encoder)
{
    const std::int64_t relative = counts(encoder.relative());
    const std::int64_t position = relative + counts(encoder.position() - encoder.relative());
    std::vector<ArchiveField> fields{{"error", ArchiveEnum{0, {}}}};
    for (const char* const name : {"0", "1", "2"}) {
        std::ranges::move(slot(name, *name == '0', encoder.fractionOfTurn()), std::back_inserter(fields));
    }
    std::ranges::move(
        std::vector<ArchiveField>{
            {"epoch", ArchiveUnsigned{static_cast<std::uint64_t>(encoder.beginnings()) & 0xff, 1}},
            {"position_relative_valid", true},
            {"position_relative_ever_valid", true},
            {"position_relative_raw", ArchiveSigned{relative, 8}},
            {"position_relative", shown(relative)},
            {"position_relative_modulo", ArchiveSigned{0, 8}},
            {"position_raw", ArchiveSigned{position, 8}},
            {"position", shown(position)},
            {"homed", ArchiveEnum{static_cast<std::uint32_t>(encoder.homeState()), {}}},
            {"velocity", static_cast<float>(encoder.velocity())},
            {"theta_valid", true},
            {"electrical_theta", 0.0F}},
        std::back_inserter(fields));
    return fields;
}

}  // namespace boresight::sim
