// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drive_check/console_run.h"
#include "core/drive_check/drive_changes.h"
#include "core/drive_check/heartbeat.h"
#include "core/drive_check/read_protections.h"
#include "core/moteus/count_origin.h"

#include <optional>
#include <string_view>
#include <vector>

// The drive of one axis: reads its safety settings, writes those that differ, and watches its heartbeat. Pure. At most
// one frame per call.
namespace boresight::drive_check {

// The origin of the drive's position count at one moment.
struct OriginReading
{
    std::optional<moteus::CountOrigin> origin;  // empty: the drive does not report it
    SteadyTime asked{SteadyTime::min()};
};

class AxisCheck
{
public:
    AxisCheck(const profile::Profile& profile, Axis axis);
    // Changes the wanted settings. A running reading or writing ends first.
    void profileChanged(const profile::Profile& before, const profile::Profile& after);

    void read(const moteus::Uuid& board);
    // Writes the settings that differ and reads them back. Stores them only if the drive accepted every value. Then
    // reads everything again.
    void fix();
    // Reads only the uptime and the origin of the position count. All other values stay. Without an answer these two
    // values stay, too.
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
    [[nodiscard]] const QList<ProtectionLine>& lines() const { return m_protections.lines(); }
    // Every setting that the profile needs was read. A change of the profile may need another one.
    [[nodiscard]] bool isAllRead() const { return m_protections.isAllRead(); }
    [[nodiscard]] std::optional<double> value(std::string_view key) const { return m_protections.value(key); }
    [[nodiscard]] const OriginReading& origin() const { return m_origin; }
    [[nodiscard]] const Heartbeat& heartbeat() const { return m_heartbeat; }
    [[nodiscard]] std::vector<Change> takeChanges() { return m_changes.take(); }

private:
    enum class Step
    {
        Idle,
        Uptime,  // comes first, and shows whether the drive is still there
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
    std::optional<std::vector<Protection>> m_next;  // replaces the wanted settings as soon as nothing is being written
    moteus::Uuid m_board{};
    Heartbeat m_heartbeat;
    Step m_step = Step::Idle;
    std::optional<ConsoleRun> m_run;
    std::vector<std::size_t> m_written;  // indices of the settings that fix() wrote since the last complete reading
    bool m_complete = false;
    OriginReading m_origin;
    SteadyTime m_notYetAsked{SteadyTime::min()};  // time stamp for the origin of this run
    QString m_trouble;
    QString m_fixTrouble;
    DriveChanges m_changes;
};

}  // namespace boresight::drive_check
