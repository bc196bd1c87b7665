// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/bus_name.h"

#include <QString>

// What an operator should look at when a bus does not do what it should: the same words on every kind of bus. Pure.
namespace boresight {

// When frames leave but no controller on the bus acknowledges them. Without a full stop, to end a sentence.
[[nodiscard]] QString acknowledgeAdvice();

// When frames are damaged on the wire.
[[nodiscard]] QString errorAdvice();

// When the bus is up and drives stay silent: everything that keeps a drive from receiving or answering, the likely
// first, with the command that shows what is set. Whole sentences.
[[nodiscard]] QString silenceAdvice(const BusName& bus);

}  // namespace boresight
