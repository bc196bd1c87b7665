// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_board.h"
#include "core/alarms/event_file.h"
#include "core/alarms/event_log.h"
#include "core/base/clock.h"
#include "core/base/kept_clock.h"
#include "core/clients/message_commands.h"
#include "core/clients/station_server.h"
#include "core/clients/station_shell.h"
#include "core/computer_clock/clock_guard.h"
#include "core/control/station_control.h"
#include "core/inputs/station_inputs.h"
#include "core/messages/request.h"
#include "core/messages/station_status.h"
#include "core/mount/mount_connection.h"
#include "core/night/night_desk.h"
#include "core/north/calibration_desk.h"
#include "core/profile/in_force.h"
#include "core/profile/profile.h"
#include "core/sim_bus/running_faults.h"
#include "core/station/error_watch.h"
#include "core/station/profile_desk.h"
#include "core/station/real_time.h"
#include "core/station/screen_feed.h"
#include "core/station/station_brake.h"
#include "core/station/station_hooks.h"
#include "core/station/station_passes.h"
#include "core/station/station_recorder.h"
#include "core/station/station_rehearsal.h"
#include "core/station/station_transmit.h"
#include "core/station/tick_lateness.h"
#include "core/tuning/tuning_desk.h"

#include <QObject>
#include <QTimer>

#include <memory>
#include <vector>

// The running station: StationControl with a mount, a timer, the rotctld server, a log file and a feed of updates. It
// decides nothing about motion itself. The constructor reads files. The station is built on the station thread, or
// moved there before start(). After that everything is called on this thread; other threads use queued signals.
//
// More than 15 members and 600 lines: the parts that it makes and connects.
namespace boresight {

class Station : public QObject
{
    Q_OBJECT

public:
    static constexpr std::chrono::milliseconds kUpdatePeriod{50};

    // `clock` must outlive the station. The state folder has the log and the results of calibrations.
    Station(const profile::Profile& profile, const MountMaker& mount, const QString& stateDir, const Clock& clock);
    ~Station() override;

    // Replaces how the orientation sensor is made. Call before start().
    void setSensorMaker(SensorMaker maker) { m_inputs.sensor().setMaker(std::move(maker)); }

    // Replaces how the output of the brakes is made. Call before start().
    void setBrakeMaker(outputs::NamedOutput::Make make) { m_brake.setMaker(std::move(make)); }

    // Replaces how the mount shows faults on request. Without it the station refuses, like that of a real mount. Call
    // before start().
    void setFaults(ShowFault show) { m_showFault = std::move(show); }

    // Opens a socket in this folder for the commands of boresightctl that rotctld does not know. If that fails, the log
    // has the reason. Call before start().
    void serveShell(const QString& runtimeFolder) { m_shell.setRuntimeFolder(runtimeFolder); }

    // start() then asks for real-time scheduling of its thread. Call before start().
    void wantRealTime() { m_wantsRealTime = true; }

    [[nodiscard]] StationStatus status() const;
    [[nodiscard]] const TickLateness& lateness() const { return m_lateness; }

    // Applies a profile that was read again. Settings that apply at once are in force, the log names the others. A
    // profile that could not be read or is refused changes nothing.
    void reload(const Result<profile::Profile>& read);

public Q_SLOTS:
    // Opens the mount and the server and begins to tick. started() reports the result as soon as there is a position,
    // or when it is clear that there will be none. A mount that does not open is an alarm and is tried again each
    // second.
    void start();
    void request(const boresight::NumberedRequest& request);
    // The screen has taken the last update, so the next one may be sent.
    void updateTaken();
    // Decelerates the mount, leaves the drives as the profile says, then emits finished().
    void shutDown();

    // The timers call these. Tests with a hand-turned clock call them directly, after openAll().
    void tick();
    void publish();
    void openAll();
    void openMount();
    void tellDirections();

Q_SIGNALS:
    // `listening` is the address of the rotctld server. It is empty when the server could not listen. `problem` then
    // has the reason.
    void started(const QString& listening, const QString& problem);
    void updated(const boresight::StationUpdate& update);
    void finished();
    void ticked();  // each tick; shows that the control loop is alive
    // New settings of the operator are in force and have to be saved.
    void profileApplied(const boresight::profile::Profile& profile);
    // Emitted instead of finished(): build the next station, with this profile.
    void reconnectWanted(const boresight::profile::Profile& profile);

private:
    void profileChanged(const profile::Profile& before);
    void leave();
    void answer(const NumberedRequest& asked, const Result<>& outcome);
    [[nodiscard]] Result<> obey(const Request& request, const Source& by);
    [[nodiscard]] Result<> askNow(const Request& request, const Source& by);
    void hurry(const Request& request);
    [[nodiscard]] Result<> carryOut(const Request& request, const Source& by);
    [[nodiscard]] TimeEffect effectOf(Seconds clockSet);
    [[nodiscard]] Result<> rehearse(const request::Rehearse& wanted);
    [[nodiscard]] std::optional<DrivesStatus> drives() const;
    void openServer();
    void refuseToStart();
    void tellStart();
    [[nodiscard]] std::vector<local::KnownAntenna> knownAntennas() const;
    void crossCheck();
    void finish();
    void keepSample();

    profile::InForce m_profile;  // first, because the other members read it
    const Clock& m_clock;
    KeptClock m_kept;  // points the mount; log, alarms and files have the clock of the computer
    EventLog m_log;
    AlarmBoard m_alarms;
    std::unique_ptr<MountConnection> m_mount;
    ShowFault m_showFault = [](std::string_view) { return noFaultOfARealMount(); };
    StationControl m_control;
    ClockGuard m_clockGuard;
    StationServer m_server;
    StationShell m_shell;
    StationInputs m_inputs;
    MessageCommands m_commands;
    CalibrationFile m_calibrationFile;
    CalibrationDesk m_calibration;
    TuningDesk m_tuning;
    StationPasses m_passes{this};
    StationHooks m_hooks;
    StationTransmit m_transmit;
    StationBrake m_brake;
    ReportFile m_reportFile;
    NightDesk m_night;
    StationRecorder m_recorder;
    StationRehearsal m_rehearsal{this};
    ProfileDesk m_profileDesk;
    EventFile m_eventFile;
    QTimer m_tickTimer;
    QTimer m_updateTimer;
    QTimer m_reopenTimer;
    TickLateness m_lateness;
    ErrorWatch m_errorWatch;
    RealTime m_realTime{this};
    bool m_wantsRealTime = false;
    ScreenFeed m_screen;
    SteadyTime m_opened{};
    bool m_startTold = false;
    bool m_finished = false;
};

}  // namespace boresight
