// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/boresightctl/record_table.h"
#include "app/boresightctl/subcommand.h"
#include "core/base/result.h"

#include <QString>

// The command lines of `export` and `replay`. Pure.
namespace boresight::ctl {

enum class RecordedPart
{
    Ticks,
    Events,
    Plan,
    Info
};

struct ExportOptions
{
    QString file;
    TableFormat format = TableFormat::Csv;
    RecordedPart part = RecordedPart::Ticks;
};

struct ReplayOptions
{
    QString file;
    double speed = 1.0;
};

[[nodiscard]] Result<ExportOptions> parseExportOptions(Arguments arguments);
[[nodiscard]] Result<ReplayOptions> parseReplayOptions(Arguments arguments);

}  // namespace boresight::ctl
