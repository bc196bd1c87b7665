// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/transmit_output/transmit_output.h"

#include <QThreadPool>

#include <functional>
#include <memory>
#include <optional>

// An output that is set by a call that may take long: a file on a disk, a line of an adapter. One thread makes the
// calls, one at a time. Its end waits for the last one.
namespace boresight::transmit {

class ThreadedOutput final : public TransmitOutput
{
    Q_OBJECT

public:
    // Called on the thread, and at the end once more on the owner's.
    using Write = std::function<Result<>(bool on)>;

    explicit ThreadedOutput(Write write, QObject* parent = nullptr);
    ~ThreadedOutput() override;

    void set(bool on) override;
    [[nodiscard]] bool isIdle() const override { return !m_begun && !m_asked; }

private:
    void begin();
    void finish(bool on, const Result<>& outcome);

    Write m_write;
    bool m_wanted = false;
    std::optional<bool> m_begun;  // is being written; empty: nothing is
    bool m_asked = false;         // set() was called meanwhile
    QThreadPool m_worker;         // last, so that it ends first
};

}  // namespace boresight::transmit
