// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/sim/fault_injection.h"

#include <string>
#include <string_view>

// Injected faults as options of the command line: --NAME [AXIS:]VALUE[@START][+DURATION], for example --wind
// az:30Nm@5+3. AXIS is az or el; without AXIS the fault is on both. START and DURATION are times ("5", "5s", "500ms")
// on the clock of the simulated pair. Without them the fault is present from the beginning and for ever. A running
// station takes the same text without the dashes: "wind az:30Nm@5+3". Pure.
namespace boresight::sim {

enum class NeedOfValue
{
    None,
    Optional,
    Needed,
};

struct InjectionOption
{
    std::string_view name;  // without the dashes
    FaultKind kind;
    NeedOfValue need = NeedOfValue::None;
    std::string_view value;  // the name of the value in the help: "TORQUE"
    std::string_view unit;   // may follow the number; "s" also allows "ms"
    double min = 0.0;
    double max = 0.0;
    bool whole = false;     // no fractions
    bool takesAxis = true;  // false: a fault of the mount or the adapter
    bool ofAdapter = false;
    std::string_view text;  // "wind of # Nm": # is the value
};

// Null if no fault has this name.
[[nodiscard]] const InjectionOption* findInjectionOption(std::string_view name);

// The error names the option and what it expects.
[[nodiscard]] Result<Injection> parseInjection(const InjectionOption& option, std::string_view text);

// Of the name and the text after it: "wind az:30Nm@5+3". START is from 0. The error names what is wrong.
[[nodiscard]] Result<Injection> parseInjection(std::string_view text);

// True: the fault is one of the USB adapter. A CAN interface has no adapter.
[[nodiscard]] bool isOfAdapter(FaultKind kind);

// For example "elevation: wind of 30 Nm".
[[nodiscard]] std::string describe(const Injection& injection);

// One line per option, for the help.
[[nodiscard]] std::string injectionHelp();

}  // namespace boresight::sim
