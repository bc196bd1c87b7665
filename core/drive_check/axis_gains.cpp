// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drive_check/axis_gains.h"

#include "core/base/text.h"
#include "core/drive_check/protections.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace boresight::drive_check {
namespace {

QString gainText(double value)
{
    return std::abs(value) >= 1e5 ? QString::number(value, 'f', 0) : QString::number(value, 'g', 6);
}

bool isSame(double one, double other)
{
    return tookEffect(one, {.state = Reading::State::Read, .text = settingText(other)});
}

std::vector<std::string> getCommands()
{
    std::vector<std::string> commands;
    for (std::size_t i = 0; i < kGainCount; ++i) {
        commands.push_back("conf get " + gainKey(static_cast<Gain>(i)));
    }
    return commands;
}

std::optional<double> valueOf(const ConsoleRun::Answer& answer)
{
    if (!answer || answer->empty()) {
        return std::nullopt;  // this firmware does not have the key
    }
    const auto value = Reading{.state = Reading::State::Read, .text = answer->front()}.value();
    return value && std::isfinite(*value) ? value : std::nullopt;
}

}  // namespace

void AxisGains::read(const QString& board)
{
    if (board != m_board) {
        m_board = board;
        m_first = {};
        m_stored = {};
        m_values = {};
        m_read = false;
    }
    std::vector<std::string> commands{"tel stop"};
    std::ranges::copy(getCommands(), std::back_inserter(commands));
    begin(Doing::Reading, std::move(commands), Text::tr("Reading the gains of %1.").arg(axisText(m_axis)));
}

Result<> AxisGains::mayWrite(Gain gain, double value) const
{
    if (!isRead()) {
        return failure(ErrorCode::Refused, Text::tr("Read the gains first."));
    }
    const GainLine line = gainLines(m_stored)[indexOf(gain)];
    if (!m_values[indexOf(gain)]) {
        return failure(ErrorCode::NotAvailable, Text::tr("The firmware of this drive has no %1.").arg(line.key));
    }
    if (!(value >= line.least && value <= line.most)) {
        return failure(
            ErrorCode::OutOfRange,
            Text::tr("%1 must be %2 to %3. %4").arg(line.key, gainText(line.least), gainText(line.most), line.bounds));
    }
    return {};
}

void AxisGains::write(Gain gain, double value)
{
    writeAll({{gain, value}}, Text::tr("Writing %1 of %2.").arg(toQString(gainKey(gain)), axisText(m_axis)));
}

std::vector<Gain> AxisGains::toPutBack() const
{
    std::vector<Gain> gains;
    for (std::size_t i = 0; i < kGainCount; ++i) {
        if (isRead() && m_first[i] && m_values[i] && !isSame(*m_first[i], *m_values[i])) {
            gains.push_back(static_cast<Gain>(i));
        }
    }
    return gains;
}

void AxisGains::putBack()
{
    std::vector<Change> changes;
    for (const Gain gain : toPutBack()) {
        changes.push_back({gain, *m_first[indexOf(gain)]});
    }
    writeAll(std::move(changes), Text::tr("Putting the gains of %1 back.").arg(axisText(m_axis)));
}

void AxisGains::writeAll(std::vector<Change> changes, const QString& what)
{
    std::vector<std::string> commands{"tel stop"};
    for (const Change& one : changes) {
        commands.push_back("conf set " + gainKey(one.gain) + ' ' + settingText(one.value));
    }
    std::ranges::copy(getCommands(), std::back_inserter(commands));
    m_changes = std::move(changes);
    begin(Doing::Writing, std::move(commands), what);
}

void AxisGains::store()
{
    begin(Doing::Storing, {"tel stop", "conf write"}, Text::tr("Storing the gains of %1.").arg(axisText(m_axis)));
}

void AxisGains::begin(Doing doing, std::vector<std::string> commands, const QString& text)
{
    m_doing = doing;
    m_text = text;
    m_failed = false;
    m_run.emplace(m_drive, std::move(commands),
                  doing == Doing::Storing ? ConsoleRun::Patience::Storing : ConsoleRun::Patience::Reading);
}

void AxisGains::forget()
{
    m_text.clear();
    m_failed = false;
    interrupt(Text::tr("The %1 drive stopped replying. Read its gains again.").arg(axisText(m_axis)));
    m_read = false;
    m_doubtful = false;
    m_values = {};
    m_stored = {};  // the next reading shows the stored values
}

void AxisGains::startOver()
{
    forget();
    m_first = {};
}

void AxisGains::interrupt(const QString& why)
{
    if (!m_run) {
        return;
    }
    m_countsAnew = m_countsAnew || writesFilter();  // the write may have reached the drive
    m_doubtful = m_doubtful || m_doing == Doing::Writing;
    m_run.reset();
    end(why, true);
}

bool AxisGains::writesFilter() const
{
    return m_doing == Doing::Writing &&
           std::ranges::find(m_changes, Gain::EncoderFilter, &Change::gain) != m_changes.end();
}

std::optional<CanFrame> AxisGains::frame(SteadyTime now)
{
    if (!m_run) {
        return std::nullopt;
    }
    std::optional<CanFrame> frame = m_run->frame(now);
    if (m_run->isFinished()) {
        finish();
    }
    return frame;
}

void AxisGains::take(const moteus::Reply& reply)
{
    if (m_run && reply.source == m_drive) {
        m_run->take(reply);
    }
}

void AxisGains::finish()
{
    if (const QString trouble = m_run->trouble(); !trouble.isEmpty()) {
        interrupt(Text::tr("The %1 drive did not answer: %2. Read its gains again.").arg(axisText(m_axis), trouble));
        return;
    }
    switch (m_doing) {
        case Doing::Reading:
            finishReading();
            break;
        case Doing::Writing:
            finishWriting();
            break;
        case Doing::Storing:
            finishStoring();
            break;
    }
    m_run.reset();
}

void AxisGains::takeValues(std::size_t first)
{
    for (std::size_t i = 0; i < kGainCount; ++i) {
        m_values[i] = valueOf(m_run->answers()[first + i]);
    }
    m_doubtful = false;
}

void AxisGains::finishReading()
{
    takeValues(1);
    m_read = true;
    for (std::size_t i = 0; i < kGainCount; ++i) {
        m_first[i] = m_first[i] ? m_first[i] : m_values[i];
        m_stored[i] = m_stored[i] ? m_stored[i] : m_values[i];
    }
    end(Text::tr("The gains were read."), false);
}

// Compares the values that read back. The answer of the drive proves nothing: it reads garbage as 0 without an error.
void AxisGains::finishWriting()
{
    const GainValues before = m_values;
    m_countsAnew = m_countsAnew || writesFilter();
    takeValues(1 + m_changes.size());
    QString wrong;
    for (const Change& one : m_changes) {
        const auto& now = m_values[indexOf(one.gain)];
        const QString key = toQString(gainKey(one.gain));
        if (!now || !isSame(one.value, *now)) {
            wrong = Text::tr("%1 was set to %2 and reads back %3.")
                        .arg(key, gainText(one.value), now ? gainText(*now) : Text::tr("nothing"));
        } else if (const auto& was = before[indexOf(one.gain)]) {
            m_notes.push_back(Text::tr("gain of %1, in force until a power cycle: %2 %3 → %4")
                                  .arg(axisText(m_axis), key, gainText(*was), gainText(*now)));
        }
    }
    m_changes.clear();
    end(wrong.isEmpty() ? Text::tr("Written and read back.") : wrong, !wrong.isEmpty());
}

void AxisGains::finishStoring()
{
    if (const ConsoleRun::Answer& answer = m_run->answers().back(); !answer) {
        end(Text::tr("The %1 drive did not store its gains: %2.").arg(axisText(m_axis), answer.error().text), true);
        return;
    }
    m_stored = m_values;
    m_notes.push_back(Text::tr("the gains of %1 are stored in its drive").arg(axisText(m_axis)));
    end(Text::tr("The gains are stored. The drive keeps them after a power cycle."), false);
}

void AxisGains::end(const QString& text, bool failed)
{
    m_text = text;
    m_failed = failed;
}

bool AxisGains::isOnTrial() const
{
    for (std::size_t i = 0; i < kGainCount; ++i) {
        if (m_read && m_values[i] && m_stored[i] && !isSame(*m_stored[i], *m_values[i])) {
            return true;
        }
    }
    return m_doubtful;
}

DriveGains AxisGains::status() const
{
    DriveGains gains{.lines = gainLines(m_stored),
                     .read = isRead(),
                     .busy = isBusy(),
                     .onTrial = isOnTrial(),
                     .text = m_text,
                     .failed = m_failed};
    for (std::size_t i = 0; i < kGainCount; ++i) {
        gains.lines[i].value = m_values[i];
        gains.lines[i].first = m_first[i];
    }
    return gains;
}

}  // namespace boresight::drive_check
