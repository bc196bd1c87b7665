// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/station.h"

#include "core/alarms/catalogue.h"
#include "core/base/text.h"
#include "core/computer_clock/time_effect.h"
#include "core/north/calibration_gates.h"
#include "core/sources/motion_sources.h"

#include <QLoggingCategory>

#include <algorithm>
#include <cmath>

Q_LOGGING_CATEGORY(lcTick, "boresight.tick", QtInfoMsg)

namespace boresight {
namespace {

constexpr std::chrono::seconds kReopenPeriod{1};
// How long started() waits for a position, so that a client can ask for it at once. If no drive answers, there will be
// no position. Drives that answer are checked first, which takes longer.
constexpr std::chrono::milliseconds kStartPatience{500};
constexpr std::chrono::seconds kDriveCheckPatience{6};

Source operatorSource()
{
    return {.kind = SourceKind::Operator, .name = QStringLiteral("operator")};
}

}  // namespace

Station::Station(const profile::Profile& profile, const MountMaker& mount, const QString& stateDir, const Clock& clock)
    : m_profile(profile),
      m_clock(clock),
      m_kept(clock),
      m_log(clock),
      m_alarms(m_log, clock),
      m_mount(mount(m_profile, clock, m_log, m_alarms)),
      m_control(m_profile, m_kept, m_log, m_alarms, m_mount->driver(), motionSources),
      m_clockGuard(m_kept, m_log, m_alarms, [this](Seconds by) { return effectOf(by); }),
      m_server(m_control, m_profile, m_log, clock, this),
      m_shell({.ask = [this](const Request& request, const Source& by) { return askNow(request, by); },
               .mayShellCommand = [this] { return m_control.mayShellCommand(); },
               .readTable = [this](const QString& path,
                                   StationTables::Then then) { m_inputs.readTable(path, std::move(then)); },
               .findRotator = [this](const QString& name,
                                     StationFollow::Then then) { m_inputs.findRotator(name, std::move(then)); },
               .satellites = [this] { return m_inputs.elements().satellites(); },
               .antennas = [this] { return knownAntennas(); },
               .schedule = [this] { return m_night.status(); },
               .rehearsal = [this] { return m_rehearsal.status(); },
               .status = [this] { return status(); },
               .transmit = [this] { return m_transmit.status(); },
               .protocolLines = [this](auto after, auto most) { return m_server.protocolLog().oldest(after, most); },
               .simulate = [this](const QByteArray& text) { return m_showFault(text.toStdString()); }},
              m_log, clock, this),
      m_inputs(m_control,
               {.read = [this](const contacts::BoardPin& pin) { return m_mount->pin(pin); },
                .simulated = m_mount->simulated()},
               m_profile, clock, m_log, this),
      m_commands(
          m_control.alarms(), m_profile, m_log, clock, m_inputs.broker(), m_server.rotator(), m_server.newestClient(),
          [this](const rotctld::Client& client) { return askNow(request::Stop{}, clientSource(client)); }, this),
      m_calibrationFile(calibrationPath(stateDir, toQString(profile.mount.name), m_mount->simulated()), this),
      m_calibration(m_control, m_profile, m_calibrationFile, m_kept, m_log),
      m_tuning(m_control, clock, m_log),
      m_hooks(m_profile, m_mount->simulated(), m_log, m_inputs.broker(), this),
      m_transmit(m_profile, m_mount->simulated(), clock, m_log, m_alarms, this),
      m_brake(m_profile, m_control, *m_mount, clock, this),
      m_reportFile(reportPath(stateDir, toQString(profile.mount.name), m_mount->simulated()), this),
      m_night(
          m_control, m_profile, m_reportFile, m_kept, m_log,
          [this](std::vector<passes::SatelliteSearch> searches, NightDesk::Found found) {
              m_passes.search(std::move(searches), std::move(found));
          },
          [this](const schedule::PassMoment& moment) { m_hooks.tell(moment); }),
      m_recorder(recordingsPath(stateDir, toQString(profile.mount.name), m_mount->simulated()), m_profile,
                 m_mount->simulated(), m_control, m_inputs.sensor(), m_kept, m_log, this),
      m_profileDesk(m_profile, m_mount->simulated(), m_log,
                    [this](const profile::Profile& before, const profile::Profile& wanted) {
                        profileChanged(before);
                        Q_EMIT profileApplied(wanted);
                    }),
      m_eventFile(stateDir, m_log, clock, this),
      m_tickTimer(this),
      m_updateTimer(this),
      m_reopenTimer(this),
      m_lateness(std::chrono::round<std::chrono::milliseconds>(profile.control.tickPeriod()))
{
    m_mount->setParent(this);  // so that it moves to the station thread with the station
    m_tickTimer.setTimerType(Qt::PreciseTimer);
    m_tickTimer.setInterval(std::chrono::round<std::chrono::milliseconds>(profile.control.tickPeriod()));
    m_updateTimer.setInterval(kUpdatePeriod);
    m_reopenTimer.setInterval(kReopenPeriod);
    connect(&m_tickTimer, &QTimer::timeout, this, [this] {
        m_lateness.tick(m_clock.now());
        tick();
    });
    connect(&m_updateTimer, &QTimer::timeout, this, &Station::publish);
    connect(&m_reopenTimer, &QTimer::timeout, this, &Station::openMount);
    connect(&m_inputs.elements(), &StationElements::changed, this, [this] {
        m_night.setSatellites(m_inputs.elements().satellites());
        (void)m_control.receive(m_inputs.elements().satellites());
    });
    connect(&m_inputs.power(), &StationPower::received, this,
            [this](const power::Value& value) { m_calibration.take(value); });
    connect(&m_eventFile, &EventFile::failed, this,
            [this](const QString& reason) { m_control.alarms().raise(alarmEntry("log.not-stored"), {reason}); });
    connect(&m_eventFile, &EventFile::written, this,
            [this] { m_control.alarms().clear(alarmEntry("log.not-stored")); });
}

Station::~Station()
{
    m_server.close();  // while the rotator still exists
    m_mount->setParent(nullptr);
}

void Station::start()
{
    if (m_wantsRealTime) {
        m_realTime.ask();
    }
    openAll();
    m_tickTimer.start();
    m_updateTimer.start();
    m_reopenTimer.start();
}

void Station::openAll()
{
    m_opened = m_clock.now();
    if (!m_mount->mine()) {
        refuseToStart();
        return;
    }
    tellDirections();
    openMount();
    openServer();
    m_inputs.open();
    m_commands.open();
    m_transmit.open();
    m_brake.open();
    m_eventFile.tick();
}

// Reports this in the log, because a service has no window with a guide.
void Station::tellDirections()
{
    if (m_profile->mount.directions == profile::Directions::Unconfirmed) {
        m_log.add(Severity::Warning, QStringLiteral("station"),
                  Text::tr("Nobody has confirmed the directions of the axes. Boresight moves the mount at most 2° at "
                           "5°/s, and only by a jog or by the command M of a client. Check that each axis turns in the "
                           "direction of the "
                           "profile. Then confirm the directions in the guide of the window, or run boresightctl "
                           "confirm-directions PROFILE and start again."));
    }
}

// Another program commands these drives and writes their position journal. This station opens neither bus nor server.
void Station::refuseToStart()
{
    const QString problem = m_mount->mine().error().text;
    m_control.alarms().raise(alarmEntry("journal.in-use"), {problem});
    m_startTold = true;
    Q_EMIT started({}, problem + QStringLiteral(". ") +
                           Text::tr("End the other program, or give this mount another name in its profile"));
}

void Station::openMount()
{
    m_mount->open();
}

void Station::openServer()
{
    if (const Result<> listening = m_server.open()) {
        m_shell.open(m_server.port());
    } else {
        m_startTold = true;
        Q_EMIT started({}, listening.error().text);
    }
}

std::vector<local::KnownAntenna> Station::knownAntennas() const
{
    std::vector<local::KnownAntenna> known;
    for (const pointing::Antenna& one : m_profile->allAntennas()) {
        known.push_back({.antenna = one, .isInUse = one.name == m_control.antenna().name});
    }
    return known;
}

void Station::tellStart()
{
    const MountDriver& mount = m_mount->driver();
    const auto answers = [&mount](Axis axis) { return mount.capabilities().has(axis) && mount.report(axis).answers; };
    const bool drives = std::ranges::any_of(kAxes, answers);
    const auto patience = drives ? std::chrono::milliseconds(kDriveCheckPatience) : kStartPatience;
    if (!m_startTold && (m_control.measured() || m_clock.now() - m_opened > patience)) {
        m_startTold = true;
        Q_EMIT started(m_server.address(), {});
    }
}

// Called before a tick: the drives have answered the last tick, and its set-points are still the current ones.
void Station::keepSample()
{
    if (const auto sample = m_control.sample()) {
        m_screen.keep(*sample);
        m_errorWatch.keep(*sample, m_control.mount().capabilities(), m_control.pointing());
    }
}

void Station::tick()
{
    keepSample();
    m_recorder.tick();
    if (m_clockGuard.tick()) {
        m_calibration.clockWasSet();
    }
    m_server.tick();
    m_commands.tick();
    m_calibration.show(m_inputs.power().tick());
    m_calibration.tick();
    m_tuning.tick();
    m_night.tick();
    m_brake.tellAnswer();
    m_inputs.tellSwitches();
    m_control.tick();
    m_brake.obey();
    m_inputs.tick();
    if (m_transmit.isWanted()) {
        m_transmit.tick(m_control.briefStatus());
    }
    crossCheck();
    m_mount->send();
    m_eventFile.tick();
    tellStart();
    Q_EMIT ticked();
    if (m_control.shutDownDone() && !m_finished) {
        finish();
    }
}

// Cross-checks the mount with the sensor on the antenna and passes the result on. The sensor moves and stops nothing.
void Station::crossCheck()
{
    double amperes = 0.0;
    if (const auto sample = m_control.sample()) {
        for (const auto& axis : sample->axes) {
            amperes += std::abs(axis.current.value_or(0.0));
        }
    }
    const auto proposed = m_calibration.proposedOfSensor();
    StationSensor& sensor = m_inputs.sensor();
    sensor.watch().setProposed(proposed ? proposed->sensor : std::nullopt);
    sensor.watch().tick(m_control.directionBy(m_profile->pointing), amperes,
                        proposed ? m_control.directionBy(proposed->terms) : std::nullopt);
    m_calibration.take(sensor.status());
    const SensorEvidence evidence = sensor.evidence();
    m_control.setSensor(evidence.azimuth, evidence.elevation);
    m_mount->setCourse(evidence.course);
}

void Station::finish()
{
    m_finished = true;
    m_tickTimer.stop();
    m_updateTimer.stop();
    m_reopenTimer.stop();
    m_shell.close();
    m_server.close();
    m_commands.close();
    m_inputs.close();
    m_mount->close();
    m_brake.close();
    m_screen.want();  // the last update, also to a slow screen: it has the answer to the request to end
    publish();
    qCInfo(lcTick, "ticks %llu, late p50 %.1f ms, p99 %.1f ms, max %.1f ms",
           static_cast<unsigned long long>(m_lateness.count()), m_lateness.percentile(0.5).count() * 1e3,
           m_lateness.percentile(0.99).count() * 1e3, m_lateness.percentile(1.0).count() * 1e3);
    if (const auto& next = m_profileDesk.next()) {
        Q_EMIT reconnectWanted(*next);
    } else {
        Q_EMIT finished();
    }
}

void Station::request(const NumberedRequest& numbered)
{
    if (const auto* const file = std::get_if<request::TrackFile>(&numbered.request)) {
        m_inputs.readTable(file->path, [this, numbered](const Result<targets::Target>& table) {
            const auto track = [this](const auto& target) { return obey(request::Track{target}, operatorSource()); };
            answer(numbered, table.and_then(track));
        });
        return;
    }
    if (const auto* const other = std::get_if<request::FollowRotator>(&numbered.request)) {
        m_inputs.findRotator(other->name, [this, numbered](const Result<QString>& found) {
            const Result<> followed = found.and_then(
                [this](const QString& name) { return obey(request::FollowRotator{name}, operatorSource()); });
            answer(numbered, followed);
            return followed;
        });
        return;
    }
    answer(numbered, obey(numbered.request, operatorSource()));
    hurry(numbered.request);
}

void Station::answer(const NumberedRequest& asked, const Result<>& outcome)
{
    if (!outcome) {
        m_log.add(Severity::Warning, operatorSource().name, Text::tr("refused: %1").arg(outcome.error().text));
    }
    const auto* const judged = std::get_if<request::JudgeDirection>(&asked.request);
    m_screen.answer({.requestId = asked.id,
                     .error = outcome ? std::optional<Error>() : std::optional(outcome.error()),
                     .verdict = outcome && judged ? std::optional(m_control.judge(judged->direction)) : std::nullopt});
}

// A program may repeat STOP as often as it likes. Only a STOP that latches runs a tick at once.
Result<> Station::askNow(const Request& request, const Source& by)
{
    const bool wasStopped = m_control.stopLatched();
    const Result<> answer = obey(request, by);
    if (!wasStopped) {
        hurry(request);
    }
    return answer;
}

// STOP does not wait for the next tick.
void Station::hurry(const Request& request)
{
    if (std::holds_alternative<request::Stop>(request)) {
        tick();
    }
}

Result<> Station::obey(const Request& request, const Source& by)
{
    return m_mount->admits(request)
        .and_then([&] { return m_control.request(request, by); })
        .and_then([&] { return carryOut(request, by); })
        .map([&] {
            m_night.noticed(request, by);
            m_inputs.noticed(request);
        });
}

void Station::reload(const Result<profile::Profile>& read)
{
    m_profileDesk.reportReading(read.and_then(
        [this](const profile::Profile& profile) { return obey(request::ApplyProfile{profile}, operatorSource()); }));
}

// Carries out the requests that StationControl has accepted but leaves to the station.
Result<> Station::carryOut(const Request& request, const Source& by)
{
    if (const auto* const wanted = std::get_if<request::Disconnect>(&request)) {
        const QString reason = Text::tr("disconnected by the operator");
        return m_commands.disconnect(wanted->clientId, reason) ? Result<>{}
                                                               : m_server.disconnect(wanted->clientId, reason);
    }
    if (const auto* const applying = std::get_if<request::ApplyProfile>(&request)) {
        return m_profileDesk.carryOut(*applying);
    }
    if (const auto* const wanted = std::get_if<CalibrationRequest>(&request)) {
        return m_calibration.carryOut(*wanted).map([this] {
            if (const auto change = m_calibration.takeChange()) {
                m_profileDesk.apply(*change);
            }
        });
    }
    if (const auto* const wanted = std::get_if<TuningRequest>(&request)) {
        return m_tuning.carryOut(*wanted, drives(), m_calibration.moves());
    }
    if (const auto* const wanted = std::get_if<ScheduleRequest>(&request)) {
        return m_night.carryOut(*wanted, by);
    }
    if (const auto* const wanted = std::get_if<request::Rehearse>(&request)) {
        return rehearse(*wanted);
    }
    if (const auto* const wanted = std::get_if<request::LogProtocol>(&request)) {
        m_server.protocolLog().setOn(wanted->on);
        const QString what = wanted->on ? Text::tr("the protocol log begins") : Text::tr("the protocol log ends");
        m_log.add(Severity::Advisory, by.name, what);
        return {};
    }
    if (std::holds_alternative<request::UseNewTime>(request)) {
        return m_clockGuard.useNewTime(by);
    }
    if (const auto* const wanted = std::get_if<request::Reconnect>(&request)) {
        return m_profileDesk.carryOut(*wanted).map([this] { leave(); });
    }
    return m_mount->carryOut(request);
}

TimeEffect Station::effectOf(Seconds clockSet)
{
    return timeEffect(
        status(), [this](UtcTime utc) { return m_control.targetAt(utc); }, clockSet);
}

// The rehearsal begins at the measured position of the mount, or at the park position while the measured one is
// unknown.
Result<> Station::rehearse(const request::Rehearse& wanted)
{
    if (!wanted.on) {
        m_rehearsal.stop();
        return {};
    }
    return m_rehearsal.begin({.profile = *m_profile,
                              .satellites = m_inputs.elements().satellites(),
                              .antenna = m_control.chosenAntenna().name,
                              .standing = m_control.measured().value_or(m_profile->park),
                              .from = m_kept.utc()});
}

std::optional<DrivesStatus> Station::drives() const
{
    StationStatus status = m_control.briefStatus();
    m_mount->describe(status);
    return status.drives;
}

// The order matters: first the control with its limits, then the mount, then the parts that send commands and the other
// inputs. The calibrations come last, because they ask the control, which must have its new limits by then.
void Station::profileChanged(const profile::Profile& before)
{
    const profile::Profile& after = *m_profile;
    m_control.profileChanged(before, after);
    m_mount->profileChanged(before, after);
    m_server.profileChanged();
    m_inputs.profileChanged(before, after);
    m_commands.profileChanged(before, after);
    m_night.profileChanged(before, after);
    m_transmit.profileChanged(before, after);
    m_brake.profileChanged(before, after);
    m_calibration.profileChanged(before, after);
}

void Station::updateTaken()
{
    m_screen.want();
}

void Station::publish()
{
    if (m_inputs.broker().isPublishing()) {
        m_inputs.broker().show(status());
    }
    if (m_screen.isWanted()) {
        Q_EMIT updated(m_screen.take(status(), m_log, m_server.protocolLog()));
    }
}

void Station::shutDown()
{
    m_log.add(Severity::Advisory, QStringLiteral("station"), Text::tr("Boresight is closing. It stops the mount"));
    leave();
}

void Station::leave()
{
    m_inputs.forget();
    m_transmit.close();
    m_control.shutDown();
}

StationStatus Station::status() const
{
    StationStatus status = m_control.status();
    status.waitingKeys = m_profile.waitingKeys();
    status.simulated = m_mount->simulated();
    m_mount->describe(status);
    status.listening = m_server.address();
    status.clients = m_server.clients(m_commands.clients());
    status.isProtocolLogged = m_server.protocolLog().isOn();
    status.timing = {.lateP50 = m_lateness.percentile(0.5),
                     .lateP99 = m_lateness.percentile(0.99),
                     .lateWorst = m_lateness.percentile(1.0),
                     .scheduling = m_realTime.text()};
    m_inputs.fill(status);
    m_calibration.fill(status);
    judgeCalibration(status);
    m_tuning.fill(status, m_calibration.moves());
    m_night.fill(status);
    status.rehearsal = m_rehearsal.status();
    status.clock = m_clockGuard.status();
    status.transmit = m_transmit.status();
    m_errorWatch.fill(status, m_control.streamError(), m_clock.now());
    return status;
}

}  // namespace boresight

#include "moc_station.cpp"
