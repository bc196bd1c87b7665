// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Which passes are recorded, and for how long the recordings are kept. Plain values.
namespace boresight::profile {

enum class RecordPasses
{
    Off,
    On
};

struct RecordSettings
{
    RecordPasses passes = RecordPasses::On;
    int keepDays = 30;
    int keepMegabytes = 2000;  // of all recordings of this mount

    bool operator==(const RecordSettings&) const = default;
};

}  // namespace boresight::profile
