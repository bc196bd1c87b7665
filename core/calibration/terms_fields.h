// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/terms_text.h"

// Every key in the header of a sheet of terms, described once. `headerFields(visitor, sheet)` calls the visitor for
// each key, and the visitor writes or reads it. Below the header follow the terms, in the order of kAllTerms.
namespace boresight::calibration {

template <class Visitor>
void headerFields(Visitor& visitor, TermSheet& sheet)
{
    visitor.text("mount", sheet.mountName);
    visitor.date("date", sheet.when);
    visitor.site("site", sheet.mount.site);
    visitor.text("azimuth drive", sheet.mount.azimuthDrive);
    visitor.text("elevation drive", sheet.mount.elevationDrive);
}

}  // namespace boresight::calibration
