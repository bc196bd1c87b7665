// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drive_check/read_protections.h"
#include "core/moteus/codec.h"

#include <QString>

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

// The changes in the drive of one axis from one complete reading to the next. The bus may have been lost in between.
// Pure.
namespace boresight::drive_check {

// A setting, or the board itself, differs from the previous reading.
struct Change
{
    QString text;          // "azimuth: servo.timeout_mode was 12, is 10"
    bool written = false;  // by our own Fix

    bool operator==(const Change&) const = default;
};

class DriveChanges
{
public:
    // Compares a complete reading with the one before. `written`: indices of the settings that Fix wrote in between.
    void note(Axis axis, const moteus::Uuid& board, const ReadProtections& now, std::span<const std::size_t> written);
    // The changes found since the last call.
    [[nodiscard]] std::vector<Change> take();

private:
    struct CompleteReading
    {
        moteus::Uuid board{};
        std::map<std::string, Reading> readings;  // by key
    };

    std::optional<CompleteReading> m_last;
    std::vector<Change> m_changes;
};

}  // namespace boresight::drive_check
