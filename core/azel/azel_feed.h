// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/azel/azel_text.h"
#include "core/base/clock.h"

#include <QString>

#include <optional>

// The state of an azel.dat that is read again and again: its last complete text, the age of that text, and whether a
// program still writes it. The file stays after its writer has ended, and it has no date. So it counts as fresh only
// while its time advances and is near the time of this computer. Pure, one thread.
namespace boresight::azel {

// The result of one read of the file.
struct AzelReading
{
    QString path;
    Result<AzelText> text;
    std::optional<UtcTime> written = {};  // the last change of the file
};

class AzelFeed
{
public:
    // An older text is not used for pointing. The Moon moves 0.125° in this time.
    static constexpr std::chrono::seconds kStale{30};
    // Some writers empty the file before they write it. A problem that lasts for a shorter time is not reported.
    static constexpr std::chrono::seconds kPatience{3};

    void take(const AzelReading& reading, SteadyTime now, UtcTime utc);

    [[nodiscard]] const QString& path() const { return m_path; }
    // The last complete text.
    [[nodiscard]] const std::optional<AzelText>& text() const { return m_text; }
    // The time in the text, with the date of this computer.
    [[nodiscard]] UtcTime time() const { return m_time; }
    // The clock of this computer minus the time in the file, when the text arrived.
    [[nodiscard]] Seconds clockOff() const { return m_clockOff; }
    // The time since a text with a new time arrived. Before that: the time since the file was written.
    [[nodiscard]] std::optional<Seconds> age(SteadyTime now, UtcTime utc) const;
    // Why the file cannot be read. Empty: no problem, or one that is too recent to report.
    [[nodiscard]] QString problem(SteadyTime now) const;
    // Whether the direction in the text is the present direction of the Moon. The error gives the reason.
    [[nodiscard]] Result<> isFresh(SteadyTime now) const;

private:
    void takeText(const AzelText& text, SteadyTime now, UtcTime utc);

    QString m_path;
    std::optional<AzelText> m_text;
    UtcTime m_time{};
    Seconds m_clockOff{0.0};
    std::optional<SteadyTime> m_changed;  // when the time in the text last changed; empty: not yet
    std::optional<UtcTime> m_written;
    std::optional<Error> m_problem;
    SteadyTime m_wrongSince{};
};

}  // namespace boresight::azel
