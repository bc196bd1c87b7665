// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus_mount/watched_boards.h"

#include "core/alarms/catalogue.h"
#include "core/moteus_mount/drive_readings.h"

#include <algorithm>

namespace boresight {
namespace {

// Seldom compared with the frames of the motion, and often enough to look live on the screen.
constexpr std::chrono::milliseconds kBetweenQuestions{200};
constexpr std::chrono::seconds kReportPatience{2};

AlarmKey faultOf(const profile::WatchedBoard& board)
{
    return alarmEntry("board.fault").of(QString::number(board.id));
}

}  // namespace

void WatchedBoards::take(const CanFrame& frame)
{
    (void)std::ranges::any_of(m_boards, [&](Board& board) { return board.drive.take(frame); });
}

void WatchedBoards::rest()
{
    for (const Board& board : m_boards) {
        m_alarms.clear(faultOf(board.named));
    }
    m_named.clear();
    m_boards.clear();
}

void WatchedBoards::followProfile(SteadyTime now)
{
    if (m_named == m_profile->watchedBoards) {
        return;
    }
    rest();
    m_named = m_profile->watchedBoards;
    m_since = now;
    for (const std::string& text : m_named) {
        if (const auto named = profile::parseWatchedBoard(text)) {
            m_boards.push_back({.named = *named, .drive = Drive(DriveSettings{.id = named->id}, named->name)});
        }
    }
}

std::vector<CanFrame> WatchedBoards::frames(SteadyTime now)
{
    m_now = now;
    followProfile(now);
    std::vector<CanFrame> questions;
    if (now < m_nextQuestion) {
        return questions;
    }
    m_nextQuestion = now + kBetweenQuestions;
    for (Board& board : m_boards) {
        board.drive.judge(now);
        questions.push_back(board.drive.frame());
        board.drive.frameSent();
        judge(board, now);
    }
    return questions;
}

void WatchedBoards::judge(const Board& board, SteadyTime now)
{
    const auto& report = board.drive.report();
    const QStringList which{toQString(board.named.name), QString::number(board.named.id)};
    if (now - (report ? report->received : m_since) >= kReportPatience) {
        m_alarms.raise(alarmEntry("board.silent").of(which.back()), which);
    } else if (report && report->mode == moteus::Mode::Fault) {
        m_alarms.raise(faultOf(board.named), which + QStringList{readingsOf(board.drive, now).fault});
    } else if (report) {
        m_alarms.clear(faultOf(board.named));
    }
}

std::vector<WatchedDrive> WatchedBoards::status() const
{
    std::vector<WatchedDrive> all;
    all.reserve(m_boards.size());
    for (const Board& board : m_boards) {
        all.push_back(
            {.id = board.named.id, .name = toQString(board.named.name), .readings = readingsOf(board.drive, m_now)});
    }
    return all;
}

}  // namespace boresight
