// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/bus_name.h"

#include <QString>

// Advice for the operator about a bus that does not work, in the same words for every kind of bus. Pure.
namespace boresight {

// For a bus on which no controller acknowledges our frames. Without a full stop, for the end of a sentence.
[[nodiscard]] QString acknowledgeAdvice();

// For frames that are damaged on the bus.
[[nodiscard]] QString errorAdvice();

// For a bus that is up although the drives are silent. Lists everything that keeps a drive from receiving or answering,
// the most likely reason first, with the command that shows the settings. Complete sentences.
[[nodiscard]] QString silenceAdvice(const BusName& bus);

}  // namespace boresight
