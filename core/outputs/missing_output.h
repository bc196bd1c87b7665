// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/outputs/output.h"

#include <utility>

namespace boresight::outputs {

// An output that nothing can switch, with the reason. Station thread.
class MissingOutput final : public Output
{
public:
    explicit MissingOutput(QString reason) : m_reason(std::move(reason)) {}
    void set(bool /*on*/) override { Q_EMIT failed(m_reason); }

private:
    QString m_reason;
};

}  // namespace boresight::outputs
