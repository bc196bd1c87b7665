// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drive_check/drive_changes.h"

#include "core/base/text.h"
#include "core/moteus/describe.h"

#include <algorithm>
#include <utility>

namespace boresight::drive_check {

void DriveChanges::note(Axis axis, const moteus::Uuid& board, const ReadProtections& now,
                        std::span<const std::size_t> written)
{
    CompleteReading reading{board, {}};
    for (std::size_t i = 0; i < now.wanted().size(); ++i) {
        reading.readings[now.wanted()[i].key] = now.readings()[i];
    }
    const CompleteReading before = std::exchange(m_last, reading).value_or(reading);
    const auto add = [this, axis](const QString& what, const QString& was, const QString& is, bool byFix) {
        m_changes.push_back({Text::tr("%1: %2 was %3, is %4").arg(axisText(axis), what, was, is), byFix});
    };
    const bool otherBoard = before.board != board;
    if (otherBoard) {
        add(Text::tr("the board"), QString::fromStdString(moteus::uuidText(before.board)),
            QString::fromStdString(moteus::uuidText(board)), false);
    }
    const auto wroteItself = [&](std::size_t i) {
        const bool told = std::ranges::find(written, i) != written.end();
        return told && tookEffect(*now.wanted()[i].remedy, now.readings()[i]);
    };
    for (std::size_t i = 0; i < now.wanted().size(); ++i) {
        const Protection& protection = now.wanted()[i];
        const auto was = before.readings.find(protection.key);
        if (was != before.readings.end() && was->second != now.readings()[i]) {
            add(QString::fromStdString(protection.key), foundText(protection, was->second),
                foundText(protection, now.readings()[i]), !otherBoard && wroteItself(i));
        }
    }
}

std::vector<Change> DriveChanges::take()
{
    return std::exchange(m_changes, {});
}

}  // namespace boresight::drive_check
