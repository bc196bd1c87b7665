// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/contacts/input_name.h"

#include <QObject>
#include <QThreadPool>

#include <functional>
#include <optional>

// Reads the status lines of one serial port again and again. A call to the port may block, so a thread makes the calls,
// one at a time. A port that fails is tried again each second. Station thread.
namespace boresight::status_lines {

// Whether each line is high.
struct StatusLines
{
    bool cts = false;
    bool dsr = false;
    bool dcd = false;
    bool ri = false;
};

class LineReader : public QObject
{
    Q_OBJECT

public:
    // Called on the worker thread. Opens the port if that is needed.
    using Read = std::function<Result<StatusLines>()>;

    static constexpr std::chrono::seconds kRetry{1};
    // A reading that is older than this does not count.
    static constexpr std::chrono::milliseconds kLongestAge{500};

    // The clock outlives this.
    LineReader(Read read, const Clock& clock, QObject* parent = nullptr);
    ~LineReader() override;

    // Begins the next reading, unless one is under way. Once per tick.
    void poll();
    [[nodiscard]] bool isBusy() const { return m_isBusy; }
    [[nodiscard]] contacts::InputReading reading(contacts::InputKind line) const;

private:
    void finish(const Result<StatusLines>& read);

    Read m_read;
    const Clock& m_clock;
    std::optional<StatusLines> m_lines;
    SteadyTime m_received{};
    QString m_problem;
    std::optional<SteadyTime> m_retry;  // not before
    bool m_isBusy = false;
    QThreadPool m_worker;  // the last member, so that it is destroyed first
};

}  // namespace boresight::status_lines
