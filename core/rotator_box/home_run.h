// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_board.h"
#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/rotator_box/rotator_talk.h"

#include <optional>

// A home run: the rotator drives its axes to its own switches and counts from there again. No answer reports the end.
// So the run has ended when the rotator has accepted the command and its axes were then seen standing still. Shows the
// run and its failure as alarms. No I/O: time is passed in. Station thread only.
namespace boresight {

class HomeRun
{
public:
    static constexpr std::chrono::seconds kLeast{5};     // from the answer; before, the motors may not run yet
    static constexpr std::chrono::minutes kLongest{10};  // a slow rotator needs some minutes for its travel

    enum class Outcome
    {
        None,  // it runs, or there is none
        Ended,
        TooLong  // the rotator must be stopped
    };

    explicit HomeRun(AlarmBoard& alarms) : m_alarms(alarms) {}

    // Success if the run may begin now, otherwise the reason. `answers`: the rotator does, and its place is known.
    [[nodiscard]] Result<> admits(const RotatorTalk& talk, bool answers) const;
    void begin(RotatorTalk& talk, SteadyTime now);
    // Something else is commanded, or the line is lost.
    void end();
    void forgetFailure();
    [[nodiscard]] bool isRunning() const { return m_run.has_value(); }
    // Once per tick. `moves`: an axis has moved within the last seconds, or its place is not known.
    [[nodiscard]] Outcome step(RotatorTalk& talk, bool moves, SteadyTime now);

private:
    struct Run
    {
        SteadyTime begun{};
        std::optional<SteadyTime> accepted{};
    };

    AlarmBoard& m_alarms;
    std::optional<Run> m_run;
};

}  // namespace boresight
