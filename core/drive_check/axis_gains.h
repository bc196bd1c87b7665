// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/drive_check/console_run.h"
#include "core/drive_check/gain_list.h"
#include "core/units/sky.h"

#include <optional>
#include <utility>
#include <vector>

// The gains of the drive of one axis, over its console: reads them, writes one within its bounds and reads it back,
// puts the values back that were found first, and stores the values in force. Knows nothing of motion. Its owner
// ensures that the axis stands still, that the drive is off if necessary, and that nothing else uses the console. Pure.
// At most one frame per call.
namespace boresight::drive_check {

class AxisGains
{
public:
    AxisGains(Axis axis, int drive) : m_axis(axis), m_drive(drive) {}

    // The values that were found first are kept for this board.
    void read(const QString& board);
    [[nodiscard]] Result<> mayWrite(Gain gain, double value) const;
    void write(Gain gain, double value);
    // The gains that putBack() would change. Empty if none would change.
    [[nodiscard]] std::vector<Gain> toPutBack() const;
    void putBack();
    void store();
    // The drive was without power, so values that were not stored are lost. Or it is another drive.
    void forget();
    // All gains of the drive were changed. The next values that are read count as the first ones.
    void startOver();
    // Ends the running work.
    void interrupt(const QString& why);

    [[nodiscard]] std::optional<CanFrame> frame(SteadyTime now);
    void take(const moteus::Reply& reply);

    [[nodiscard]] bool isBusy() const { return m_run.has_value(); }
    // Writing or storing, so no motion may begin.
    [[nodiscard]] bool isWriting() const { return m_run && m_doing != Doing::Reading; }
    [[nodiscard]] bool isRead() const { return m_read && !m_doubtful; }
    // A value is in force that the drive has not stored, or this is possible.
    [[nodiscard]] bool isOnTrial() const;
    [[nodiscard]] bool isOf(const QString& board) const { return m_board == board; }
    [[nodiscard]] DriveGains status() const;
    // True once after the encoder started its count again.
    [[nodiscard]] bool takeCountsAnew() { return std::exchange(m_countsAnew, false); }
    // The changes to the drive, for the log.
    [[nodiscard]] std::vector<QString> takeNotes() { return std::exchange(m_notes, {}); }

private:
    struct Change
    {
        Gain gain;
        double value;
    };
    enum class Doing
    {
        Reading,
        Writing,
        Storing,
    };

    void writeAll(std::vector<Change> changes, const QString& what);
    void begin(Doing doing, std::vector<std::string> commands, const QString& text);
    void finish();
    void finishReading();
    void finishWriting();
    void finishStoring();
    [[nodiscard]] bool writesFilter() const;
    void takeValues(std::size_t first);
    void end(const QString& text, bool failed);

    Axis m_axis;
    int m_drive;
    QString m_board;
    bool m_read = false;
    bool m_doubtful = false;  // writing was interrupted
    GainValues m_values{};
    GainValues m_first{};
    GainValues m_stored{};
    std::optional<ConsoleRun> m_run;
    Doing m_doing = Doing::Reading;
    std::vector<Change> m_changes;  // being written
    QString m_text;
    bool m_failed = false;
    bool m_countsAnew = false;
    std::vector<QString> m_notes;
};

}  // namespace boresight::drive_check
