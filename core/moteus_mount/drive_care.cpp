// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus_mount/drive_care.h"

#include "core/alarms/catalogue.h"
#include "core/base/overloaded.h"
#include "core/base/text.h"

#include <algorithm>
#include <iterator>

namespace boresight {
namespace {

// After this time of silence of all drives the drive check runs, which reports the silence.
constexpr std::chrono::seconds kSilencePatience{1};

drive_check::KnownBoards knownBoards(const journal::MountJournal& journal)
{
    drive_check::KnownBoards known;
    for (std::size_t i = 0; i < known.size(); ++i) {
        known[i] = journal.turns[i] ? journal.turns[i]->drive : QString();
    }
    return known;
}

Severity severityOf(drive_check::FindingWeight weight)
{
    switch (weight) {
        case drive_check::FindingWeight::Advice:
            return Severity::Advisory;
        case drive_check::FindingWeight::Warning:
            return Severity::Warning;
        case drive_check::FindingWeight::Blocking:
            break;
    }
    return Severity::Alarm;
}

// Null for a silence: each drive has its own alarm for that.
const AlarmEntry* entryOf(drive_check::FindingKind kind)
{
    switch (kind) {
        case drive_check::FindingKind::NobodyAnswers:
            return nullptr;
        case drive_check::FindingKind::Missing:
            return &alarmEntry("drives.missing");
        case drive_check::FindingKind::SharedId:
            return &alarmEntry("drives.shared-id");
        case drive_check::FindingKind::UnknownBoard:
            return &alarmEntry("drives.foreign-board");
        case drive_check::FindingKind::Swapped:
            return &alarmEntry("drives.swapped");
        case drive_check::FindingKind::OtherBoard:
            return &alarmEntry("drives.other-board");
        case drive_check::FindingKind::RegisterMap:
            return &alarmEntry("drives.register-map");
        case drive_check::FindingKind::Unread:
            return &alarmEntry("drives.unread");
        case drive_check::FindingKind::NotStored:
            return &alarmEntry("drives.not-stored");
        case drive_check::FindingKind::Dangerous:
            return &alarmEntry("drives.dangerous");
        case drive_check::FindingKind::Advised:
            return &alarmEntry("drives.advised");
    }
    return nullptr;
}

}  // namespace

DriveCare::DriveCare(const profile::InForce& profile, MoteusMount& mount, AlarmBoard& alarms, EventLog& log)
    : m_mount(mount),
      m_alarms(alarms),
      m_log(log),
      m_driveCheck(profile, knownBoards(mount.journal()), mount.axes()),
      m_boards(profile, m_driveCheck, mount.axes(), log),
      m_watched(profile, alarms),
      m_gains{drive_check::AxisGains(Axis::Azimuth, profile->azimuth.id),
              drive_check::AxisGains(Axis::Elevation, profile->elevation.id)}
{}

void DriveCare::take(const CanFrame& frame)
{
    m_driveCheck.take(frame);
    m_boards.take(frame);
    m_watched.take(frame);
    const Result<moteus::Reply> reply = moteus::decodeReply(frame);
    if (!reply || reply->destination != moteus::kDiagnosticHostId) {
        return;
    }
    for (drive_check::AxisGains& gains : m_gains) {
        gains.take(*reply);
    }
}

std::vector<CanFrame> DriveCare::tick(SteadyTime now)
{
    watchConnection(now);
    if (m_mount.busLeft()) {
        m_watched.rest();
        return {};
    }
    auto frames = m_boards.isRunning() ? changeBoard(now) : m_driveCheck.frames(now);
    std::ranges::copy(m_watched.frames(now), std::back_inserter(frames));
    tendGains(now, frames);
    tellMount();
    tellFindings();
    tellChanges();
    return frames;
}

// Gains use the same consoles as the drive check, and the drive check goes first.
void DriveCare::tendGains(SteadyTime now, std::vector<CanFrame>& frames)
{
    bool countsAnew = false;
    for (const Axis axis : m_mount.axes()) {
        drive_check::AxisGains& gains = m_gains[index(axis)];
        const auto& facts = m_driveCheck.facts(axis);
        if (m_boards.isRunning() || m_driveCheck.state() != DriveCheckState::Done || !facts) {
            gains.interrupt(Text::tr("The drive check interrupted the reading. Read the gains again."));
            continue;
        }
        if (!gains.isOf(facts->uuid)) {
            gains.forget();
        }
        if (!m_driveCheck.isAsking(axis)) {
            if (const auto frame = gains.frame(now)) {
                frames.push_back(*frame);
            }
        }
        for (const QString& note : gains.takeNotes()) {
            m_log.add(Severity::Advisory, QStringLiteral("drives"), note);
        }
        if (gains.takeCountsAnew()) {
            m_mount.countsAnew(axis);
            countsAnew = true;
        }
    }
    if (countsAnew) {
        m_driveCheck.begin(now);
    }
}

// The drive check waits while a board is changed, and then starts again, because the boards have changed.
std::vector<CanFrame> DriveCare::changeBoard(SteadyTime now)
{
    bool ended = false;
    auto frames = m_boards.frames(now, ended);
    if (const auto& axis = m_boards.geared()) {
        m_mount.expectAnotherCount(*axis);
    }
    if (const auto axis = m_boards.takeGeared()) {
        m_mount.countsAnew(*axis);
        m_gains[index(*axis)].startOver();
    }
    if (ended) {
        m_driveCheck.begin(now);
    }
    return frames;
}

// A drive that answers again after a silence may have lost its power, or may be another board.
void DriveCare::watchConnection(SteadyTime now)
{
    bool came = false;
    bool went = false;
    for (const Axis axis : m_mount.axes()) {
        const bool answers = !m_mount.busLeft() && m_mount.report(axis).answers;
        came |= answers && !m_answering[index(axis)];
        went |= !answers && m_answering[index(axis)];
        m_answering[index(axis)] = answers;
    }
    if (went) {
        m_driveCheck.forget();
    }
    if (came) {
        m_driveCheck.begin(now);
    }
    watchSilence(now);
}

// When two boards have the same id, their replies collide, except those to the query of the drive check. So the drive
// check also runs when no drive answers.
void DriveCare::watchSilence(SteadyTime now)
{
    if (m_mount.busLeft() || m_answering[0] || m_answering[1]) {
        m_silentSince.reset();
    } else if (!m_silentSince) {
        m_silentSince = now;
    } else if (now - *m_silentSince >= kSilencePatience && !m_driveCheck.isUnderWay()) {
        m_driveCheck.begin(now);
    }
}

void DriveCare::tellMount()
{
    m_driveCheck.setKnownBoards(knownBoards(m_mount.journal()));
    const bool writes = m_boards.isRunning() || std::ranges::any_of(m_gains, &drive_check::AxisGains::isWriting);
    m_mount.setInterlock(writes ? mayTouch() : m_driveCheck.fitToMove());
    for (const Axis axis : m_mount.axes()) {
        if (m_driveCheck.rebootsSeen(axis) !=
            std::exchange(m_rebootsTold[index(axis)], m_driveCheck.rebootsSeen(axis))) {
            m_mount.driveRestarted(axis);
            m_gains[index(axis)].forget();
        }
        m_mount.learn(axis, m_driveCheck.facts(axis));
        if (m_mount.needsOrigin(axis) && !m_gains[index(axis)].isBusy()) {
            m_driveCheck.readOrigin(axis);
        }
    }
}

void DriveCare::tellFindings()
{
    std::vector<AlarmKey> told;
    for (const drive_check::Finding& finding : m_driveCheck.findings()) {
        if (const AlarmEntry* const entry = entryOf(finding.kind); entry != nullptr) {
            told.push_back(entry->of(finding.about));
            m_alarms.raise(told.back(), severityOf(finding.weight), {finding.what, finding.remedy});
        }
    }
    for (const AlarmKey& before : m_findingsTold) {
        const auto lasts = [&before](const AlarmKey& now) { return now.sharesPlace(before); };
        if (std::ranges::none_of(told, lasts)) {
            m_alarms.clear(before);
        }
    }
    m_findingsTold = std::move(told);
}

void DriveCare::tellChanges()
{
    for (const drive_check::Change& change : m_driveCheck.takeChanges()) {
        if (change.written) {
            m_log.add(Severity::Advisory, QStringLiteral("drives"), Text::tr("written: %1").arg(change.text));
        } else {
            m_log.add(Severity::Warning, QStringLiteral("drives"), Text::tr("changed meanwhile: %1").arg(change.text));
        }
    }
}

bool DriveCare::areConsolesFree() const
{
    const bool isAsked = std::ranges::any_of(
        m_mount.axes(), [this](Axis axis) { return m_driveCheck.isAsking(axis) || m_gains[index(axis)].isBusy(); });
    return !m_mount.busLeft() && !m_boards.isRunning() && m_driveCheck.state() == DriveCheckState::Done && !isAsked;
}

Result<> DriveCare::mayTouch() const
{
    if (m_boards.isRunning()) {
        return failure(ErrorCode::Busy, Text::tr("Boresight is changing a board. Wait a moment."));
    }
    if (m_driveCheck.state() == DriveCheckState::Fixing) {
        return failure(ErrorCode::Refused,
                       Text::tr("Boresight is writing the settings of the drives. Wait until this ends."));
    }
    if (std::ranges::any_of(m_gains, &drive_check::AxisGains::isBusy)) {
        return failure(ErrorCode::Busy, Text::tr("Boresight is reading or writing the gains. Wait until this ends."));
    }
    return {};
}

Result<> DriveCare::mayRead() const
{
    return mayTouch().and_then([this]() -> Result<> {
        return m_driveCheck.state() == DriveCheckState::Running
                   ? failure(ErrorCode::Busy, Text::tr("Boresight is reading the drives. Wait a moment."))
                   : Result<>{};
    });
}

Result<> DriveCare::mayFix() const
{
    return mayRead().and_then([this] { return m_driveCheck.mayFix(); }).and_then([this] { return mayStoreAll(); });
}

Result<> DriveCare::mayStoreAll() const
{
    return std::ranges::any_of(m_gains, &drive_check::AxisGains::isOnTrial)
               ? failure(
                     ErrorCode::Refused,
                     Text::tr("New gains are on trial. This would store them, too. Store them or put them back first."))
               : Result<>{};
}

Result<> DriveCare::mayChangeBoard() const
{
    return mayTouch().and_then([this] { return mayStoreAll(); });
}

Result<> DriveCare::mayTune(Axis axis) const
{
    return m_mount.mayBeTuned(axis).and_then([this] { return mayTouch(); }).and_then([&]() -> Result<> {
        return m_driveCheck.state() == DriveCheckState::Done && m_driveCheck.facts(axis)
                   ? Result<>{}
                   : failure(ErrorCode::Refused, Text::tr("The drive check has not read this drive yet."));
    });
}

Result<> DriveCare::mayUse(Axis axis) const
{
    return mayTune(axis).and_then([&]() -> Result<> {
        return m_gains[index(axis)].isRead() ? Result<>{}
                                             : failure(ErrorCode::Refused, Text::tr("Read the gains first."));
    });
}

Result<> DriveCare::mayWrite(Axis axis, Gain gain, double value) const
{
    return mayTune(axis)
        .and_then([&] { return gain == Gain::EncoderFilter ? m_mount.mayBeWritten() : Result<>{}; })
        .and_then([&] { return m_gains[index(axis)].mayWrite(gain, value); });
}

Result<> DriveCare::mayPutBack(Axis axis) const
{
    return mayUse(axis).and_then([&]() -> Result<> {
        const std::vector<Gain> gains = m_gains[index(axis)].toPutBack();
        if (gains.empty()) {
            return failure(ErrorCode::Refused, Text::tr("No gain differs from its first value."));
        }
        return std::ranges::find(gains, Gain::EncoderFilter) == gains.end() ? Result<>{} : m_mount.mayBeWritten();
    });
}

Result<> DriveCare::mayStore(Axis axis) const
{
    return mayUse(axis).and_then([&]() -> Result<> {
        return m_gains[index(axis)].isOnTrial()
                   ? Result<>{}
                   : failure(ErrorCode::Refused, Text::tr("No gains are on trial. The drive has stored what it uses."));
    });
}

Result<> DriveCare::admits(const Request& request) const
{
    return std::visit(
        Overloaded{[this](const request::ReadDrives&) { return mayRead(); },
                   [this](const request::FixDrives&) { return mayFix(); },
                   [this](const request::ReleaseBus&) { return mayTouch(); },
                   [this](const request::ReadGains& wanted) { return mayTune(wanted.axis); },
                   [this](const request::SetGain& wanted) { return mayWrite(wanted.axis, wanted.gain, wanted.value); },
                   [this](const request::PutGainsBack& wanted) { return mayPutBack(wanted.axis); },
                   [this](const request::StoreGains& wanted) { return mayStore(wanted.axis); },
                   [&](const request::AssignBoard& wanted) {
                       return mayChangeBoard().and_then([&] { return m_boards.admits(wanted); });
                   },
                   [&](const request::SetGear& wanted) {
                       return mayChangeBoard().and_then([&] { return m_boards.admits(wanted); });
                   },
                   [](const auto&) -> Result<> { return {}; }},
        request);
}

Result<> DriveCare::carryOut(const Request& request, SteadyTime now)
{
    Result<> done = std::visit(Overloaded{[&](const request::ReadDrives&) -> Result<> {
                                              m_boards.forgetOutcome();
                                              m_driveCheck.begin(now);
                                              return {};
                                          },
                                          [&](const request::FixDrives&) {
                                              m_boards.forgetOutcome();
                                              return m_driveCheck.fix(now);
                                          },
                                          [this](const request::ReadGains& wanted) -> Result<> {
                                              m_gains[index(wanted.axis)].read(m_driveCheck.facts(wanted.axis)->uuid);
                                              return {};
                                          },
                                          [this](const request::SetGain& wanted) -> Result<> {
                                              m_gains[index(wanted.axis)].write(wanted.gain, wanted.value);
                                              return {};
                                          },
                                          [this](const request::PutGainsBack& wanted) -> Result<> {
                                              m_gains[index(wanted.axis)].putBack();
                                              return {};
                                          },
                                          [this](const request::StoreGains& wanted) -> Result<> {
                                              m_gains[index(wanted.axis)].store();
                                              return {};
                                          },
                                          [&](const request::AssignBoard& wanted) -> Result<> {
                                              m_boards.begin(wanted, now);
                                              return {};
                                          },
                                          [&](const request::SetGear& wanted) -> Result<> {
                                              m_boards.begin(wanted, now);
                                              return {};
                                          },
                                          [](const auto&) -> Result<> { return {}; }},
                               request);
    tellMount();  // now, because a command of a client may come before the next tick
    return done;
}

void DriveCare::judge(Permissions& may) const
{
    const auto add = [&may](Action action, const Result<>& answer) {
        may.refuse(action, answer ? QString() : answer.error().text);
    };
    add(Action::ReadDrives, mayRead());
    add(Action::FixDrives, mayFix());
    add(Action::ReleaseBus, mayTouch());
    m_boards.judge(may);
    for (const Axis axis : m_mount.axes()) {
        add(assignBoardAction(axis), mayChangeBoard());
        add(setGearAction(axis), mayChangeBoard());
    }
    judgeGains(may);
}

void DriveCare::judgeGains(Permissions& may) const
{
    for (const Axis axis : m_mount.axes()) {
        const auto add = [&](Action action, const Result<>& answer) {
            may.refuse(actionOf(action, axis), answer ? QString() : answer.error().text);
        };
        const Result<> read = mayUse(axis);
        add(Action::ReadAzimuthGains, mayTune(axis));
        add(Action::SetAzimuthGains, read);
        add(Action::SetAzimuthFilter, read);
        add(Action::PutAzimuthGainsBack, mayPutBack(axis));
        add(Action::StoreAzimuthGains, mayStore(axis));
    }
}

void DriveCare::fill(DrivesStatus& drives) const
{
    drives.driveCheck = m_driveCheck.state();
    drives.driveCheckText = m_driveCheck.progress();
    drives.fixable = m_driveCheck.isFixable();
    drives.unknownBoards = m_driveCheck.unknownBoards();
    m_boards.fill(drives);
    drives.watched = m_watched.status();
    for (const Axis axis : m_mount.axes()) {
        fill(axis, axis == Axis::Azimuth ? drives.azimuth : drives.elevation);
    }
}

void DriveCare::fill(Axis axis, DriveStatus& drive) const
{
    if (const auto& facts = m_driveCheck.facts(axis)) {
        drive.identity = facts->identity;
    }
    drive.protections = m_driveCheck.protections(axis);
    drive.gains = m_gains[index(axis)].status();
}

}  // namespace boresight
