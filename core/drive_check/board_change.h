// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/drive_check/bus_scan.h"
#include "core/drive_check/console_run.h"

#include <QString>

#include <optional>
#include <string>
#include <vector>

// Changes a setting of one board that only a person may decide: its id or its gear ratio, with the settings that depend
// on it. Looks for the boards, reads and sets, looks again and reads back. Stores only if the same board answers and
// each value is the one that was set. Pure: frames out, frames in, time passed in. Its owner ensures that the drives
// are off.
//
// A new id is in force at once. The board no longer answers with the old id, and does not even send the "OK" for the
// command. So silence is the expected answer, and the following commands go to the new id.
namespace boresight::drive_check {

struct BoardSetting
{
    std::string key;
    double value = 0.0;
    bool optional = false;  // older firmware does not have it
};

struct BoardOrder
{
    std::optional<moteus::Uuid> board;  // as confirmed by the operator; empty: its firmware reports no UUID
    int id = 0;                         // its id before the change
    int newId = 0;                      // its id after the change
    std::string key;
    double value = 0.0;
    std::vector<BoardSetting> scaled{};  // each value is a factor for the current value of its key
    bool alone = false;                  // no other board may be connected
    QString what;                        // for texts: "the id of board …"
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
    // The result of the last change that ended. Empty: no change was begun, or forgetOutcome() was called.
    [[nodiscard]] const std::optional<Result<>>& outcome() const { return m_outcome; }
    void forgetOutcome() { m_outcome.reset(); }

private:
    enum class Step
    {
        Idle,
        Looking,       // which boards answer
        Reading,       // the values to be scaled
        Setting,       // with the old id
        LookingAgain,  // the same board must answer with the new id, and no other
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
    std::vector<BoardSetting> m_settings;  // the settings to write, that of the order first
    BusScan m_scan;
    std::optional<ConsoleRun> m_run;
    Step m_step = Step::Idle;
    std::optional<Result<>> m_outcome;
};

}  // namespace boresight::drive_check
