// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/moteus/count_origin.h"
#include "core/survey/console_run.h"
#include "core/survey/drive_changes.h"
#include "core/survey/heartbeat.h"
#include "core/survey/read_protections.h"

#include <optional>
#include <span>
#include <string_view>
#include <vector>

// The drive of one axis: reads its protections, writes those that differ, and listens to its heartbeat. Pure; at most
// one frame a call.
namespace boresight::survey {

// What the drive's position counted from at that moment.
struct OriginReading
{
    std::optional<moteus::CountOrigin> origin;  // nothing: the drive does not tell
    SteadyTime asked{SteadyTime::min()};
};

class AxisSurvey
{
public:
    AxisSurvey(const profile::Profile& profile, Axis axis);
    // The settings should be others from now on; what is being written is written and read first.
    void profileChanged(const profile::Profile& before, const profile::Profile& after);

    void read(const moteus::Uuid& board);
    // Sets what differs, reads back, and stores only if all of it was taken; then reads everything again.
    void fix();
    // Only uptime and what the position counts from; the rest stays as read, and without an answer this too.
    void readOrigin();
    void forget();

    [[nodiscard]] std::optional<CanFrame> frame(SteadyTime now);
    void take(const moteus::Reply& reply);

    [[nodiscard]] bool isBusy() const { return m_step != Step::Idle; }
    [[nodiscard]] bool isComplete() const { return m_step == Step::Idle && m_complete; }
    [[nodiscard]] bool isFixable() const;
    [[nodiscard]] QString progress() const;                                   // "reading servo.timeout_mode of azimuth"
    [[nodiscard]] const QString& trouble() const { return m_trouble; }        // why there is no complete reading
    [[nodiscard]] const QString& fixTrouble() const { return m_fixTrouble; }  // why the settings are not stored
    [[nodiscard]] std::span<const ProtectionLine> lines() const { return m_protections.lines(); }
    [[nodiscard]] std::optional<double> value(std::string_view key) const { return m_protections.value(key); }
    [[nodiscard]] const OriginReading& origin() const { return m_origin; }
    [[nodiscard]] const Heartbeat& heartbeat() const { return m_heartbeat; }
    [[nodiscard]] std::vector<Change> takeChanges() { return m_changes.take(); }

private:
    enum class Step
    {
        Idle,
        Uptime,  // first, and by the way: is it still there?
        OriginUptime,
        Reading,
        Setting,
        Storing,
        Origin,
    };

    void takeNext();
    void startReading();
    void startOrigin();
    void finishRun();
    void finishReading();
    void finishSetting();
    void finishStoring();
    void finishOrigin();
    void keepOrigin(const ConsoleRun::Answer& telemetry);
    void fail(const QString& why);

    Axis m_axis;
    int m_id;
    ReadProtections m_protections;
    std::optional<std::vector<Protection>> m_next;  // instead, as soon as nothing is being written
    moteus::Uuid m_board{};
    Heartbeat m_heartbeat;
    Step m_step = Step::Idle;
    std::optional<ConsoleRun> m_run;
    std::vector<std::size_t> m_written;  // which protections fix() set since the last complete reading
    bool m_complete = false;
    OriginReading m_origin;
    SteadyTime m_notYetAsked{SteadyTime::min()};  // for the origin, in this run
    QString m_trouble;
    QString m_fixTrouble;
    DriveChanges m_changes;
};

}  // namespace boresight::survey
