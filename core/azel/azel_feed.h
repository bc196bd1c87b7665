// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/azel/azel_text.h"
#include "core/base/clock.h"

#include <QString>

#include <optional>

// What is known of an azel.dat that is read again and again: its last whole text, how old that is, and whether somebody
// still writes it. The file stays when its writer ends, and it has no date. So it is fresh only while its time is seen
// to go on, near the time of this computer. Pure, one thread.
namespace boresight::azel {

// What one look at the file found.
struct AzelReading
{
    QString path;
    Result<AzelText> text;
    std::optional<UtcTime> written = {};  // when the file was changed last
};

class AzelFeed
{
public:
    // A text older than this is not steered by: the Moon is 0.125° on.
    static constexpr std::chrono::seconds kStale{30};
    // Some writers empty the file before they write it: what is wrong for a shorter time is nobody's concern.
    static constexpr std::chrono::seconds kPatience{3};

    void take(const AzelReading& reading, SteadyTime now, UtcTime utc);

    [[nodiscard]] const QString& path() const { return m_path; }
    // The last whole one.
    [[nodiscard]] const std::optional<AzelText>& text() const { return m_text; }
    // The time that it shows, with the day of this computer.
    [[nodiscard]] UtcTime time() const { return m_time; }
    // By how much the clock of this computer was ahead of the file's when the text arrived.
    [[nodiscard]] Seconds clockOff() const { return m_clockOff; }
    // Since a text with another time arrived, else since the file was written.
    [[nodiscard]] std::optional<Seconds> age(SteadyTime now, UtcTime utc) const;
    // Why the file cannot be read; empty: it can, or has been until just now.
    [[nodiscard]] QString problem(SteadyTime now) const;
    // Whether its Moon is where the Moon is now. The error names what is in the way.
    [[nodiscard]] Result<> isFresh(SteadyTime now) const;

private:
    void takeText(const AzelText& text, SteadyTime now, UtcTime utc);

    QString m_path;
    std::optional<AzelText> m_text;
    UtcTime m_time{};
    Seconds m_clockOff{0.0};
    std::optional<SteadyTime> m_changed;  // seen to; empty: never
    std::optional<UtcTime> m_written;
    std::optional<Error> m_problem;
    SteadyTime m_wrongSince{};
};

}  // namespace boresight::azel
