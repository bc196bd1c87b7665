// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/survey/bus_scan.h"
#include "core/survey/console_run.h"

#include <QString>

#include <optional>
#include <string>
#include <vector>

// A setting of one board that only a person may decide, its id or its gear ratio, with those that follow from it. Looks
// who is there, reads and sets, looks again, reads back, and stores only if the same board answers and each value is
// the one that was set. Pure: frames out, frames in, time passed in. The drives are off: its owner sees to that.
//
// A new id is in force at once. The board no longer answers under the old one, not even "OK" to the order itself. So
// silence is the expected answer, and what follows goes to the new id.
namespace boresight::survey {

struct BoardSetting
{
    std::string key;
    double value = 0.0;
    bool optional = false;  // an older firmware does not have it
};

struct BoardOrder
{
    std::optional<moteus::Uuid> board;  // the one that the operator has confirmed; empty: its firmware tells none
    int id = 0;                         // under which it answers
    int newId = 0;                      // under which it answers afterwards
    std::string key;
    double value = 0.0;
    std::vector<BoardSetting> scaled{};  // each becomes its present value times this one
    bool alone = false;                  // no other board may be connected
    QString what;                        // "the id of board …": for texts
};

class BoardChange
{
public:
    BoardChange();

    void begin(const BoardOrder& order, SteadyTime now);
    [[nodiscard]] std::vector<CanFrame> frames(SteadyTime now);
    void take(const moteus::Reply& reply);

    [[nodiscard]] bool isRunning() const { return m_step != Step::Idle; }
    [[nodiscard]] QString progress() const;  // empty while it does not run
    // Of the last one that ended; empty: none was begun since the start.
    [[nodiscard]] const std::optional<Result<>>& outcome() const { return m_outcome; }
    void forgetOutcome() { m_outcome.reset(); }

private:
    enum class Step
    {
        Idle,
        Looking,       // who is there
        Reading,       // what will be scaled
        Setting,       // under the old id
        LookingAgain,  // the same board, under the new id, and nobody else
        ReadingBack,
        Storing,
    };

    void look(Step step, SteadyTime now);
    void run(Step step, int id, std::vector<std::string> commands);
    void finishLook();
    void finishRun(SteadyTime now);
    void finishReading();
    void finishSetting(SteadyTime now);
    void finishReadingBack();
    void set();
    void read(Step step, int id, const std::vector<BoardSetting>& settings);
    [[nodiscard]] QString troubleOfRun() const;
    [[nodiscard]] Result<> mayChange() const;
    [[nodiscard]] Result<> isChanged() const;
    [[nodiscard]] const FoundController* boardAt(int id) const;
    void end(Result<> outcome);

    BoardOrder m_order;
    std::vector<BoardSetting> m_settings;  // to be set, the one of the order first
    BusScan m_scan;
    std::optional<ConsoleRun> m_run;
    Step m_step = Step::Idle;
    std::optional<Result<>> m_outcome;
};

}  // namespace boresight::survey
