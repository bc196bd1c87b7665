// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/outputs/output.h"

#include <QThreadPool>

#include <functional>
#include <memory>
#include <optional>

// An output that is set by a call that may take long: writing a file, or switching a line of an adapter. One thread
// makes the calls, one at a time. The destructor waits for the last call.
namespace boresight::outputs {

class ThreadedOutput final : public Output
{
    Q_OBJECT

public:
    // Called on the worker thread. The destructor may call it once more, on the thread of the owner.
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
    std::optional<bool> m_begun;  // the state that is being written; empty: none
    bool m_asked = false;         // set() was called during that write
    QThreadPool m_worker;         // the last member, so that it is destroyed first
};

}  // namespace boresight::outputs
