// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contacts/output_name.h"
#include "core/outputs/output.h"

#include <memory>

namespace boresight::outputs {

// The output of a simulated mount. It switches nothing and answers at once. Station thread.
class SimulatedOutput final : public Output
{
public:
    using Output::Output;
    void set(bool on) override { Q_EMIT reached(on); }
};

// Null for OutputKind::None.
[[nodiscard]] inline std::unique_ptr<Output> simulatedOutput(const contacts::OutputName& name)
{
    return name.kind == contacts::OutputKind::None ? nullptr : std::make_unique<SimulatedOutput>();
}

}  // namespace boresight::outputs
