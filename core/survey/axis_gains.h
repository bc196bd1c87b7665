// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/survey/console_run.h"
#include "core/survey/gain_list.h"
#include "core/units/sky.h"

#include <optional>
#include <utility>
#include <vector>

// The gains of the drive of one axis over its console: reads them, writes one within its bounds and reads it back, puts
// back what was found first, stores what is in force. Knows nothing of motion: its owner sees to it that the axis
// stands, that the drive is off where it must be, and that nobody else uses the console. Pure; at most one frame a
// call.
namespace boresight::survey {

class AxisGains
{
public:
    AxisGains(Axis axis, int drive) : m_axis(axis), m_drive(drive) {}

    // What was found first is kept for this board.
    void read(const QString& board);
    [[nodiscard]] Result<> mayWrite(Gain gain, double value) const;
    void write(Gain gain, double value);
    // The gains of these that would change. Empty: nothing is to be put back.
    [[nodiscard]] std::vector<Gain> toPutBack() const;
    void putBack();
    void store();
    // The drive was without power, so what was only in force is gone; or it is another one.
    void forget();
    // All of its gains were changed: those that are read next are the first ones.
    void startOver();
    // Ends what runs.
    void interrupt(const QString& why);

    [[nodiscard]] std::optional<CanFrame> frame(SteadyTime now);
    void take(const moteus::Reply& reply);

    [[nodiscard]] bool isBusy() const { return m_run.has_value(); }
    // Writing or storing: no motion begins meanwhile.
    [[nodiscard]] bool isWriting() const { return m_run && m_doing != Doing::Reading; }
    [[nodiscard]] bool isRead() const { return m_read && !m_doubtful; }
    // Something is in force that the drive has not stored, or may be.
    [[nodiscard]] bool isOnTrial() const;
    [[nodiscard]] bool isOf(const QString& board) const { return m_board == board; }
    [[nodiscard]] DriveGains status() const;
    // True once after the count of the encoder was begun again.
    [[nodiscard]] bool takeCountsAnew() { return std::exchange(m_countsAnew, false); }
    // What was done to the drive, for the log.
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

}  // namespace boresight::survey
