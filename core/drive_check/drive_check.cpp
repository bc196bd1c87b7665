// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drive_check/drive_check.h"

#include "core/base/text.h"
#include "core/moteus/describe.h"
#include "core/profile/further_boards.h"

#include <QStringList>

#include <algorithm>
#include <utility>

namespace boresight::drive_check {
namespace {

using namespace std::chrono_literals;
using moteus::Register;

constexpr auto kRetryTime = 2s;

QString lineText(const ProtectionLine& line)
{
    return Text::tr("%1 is %2, needed %3").arg(line.name, line.foundBrief, line.wantedBrief);
}

QString protectionText(bool dangerous, int count, Axis axis, const QString& first)
{
    if (count == 1) {
        return (dangerous ? Text::tr("a setting of the %1 drive is unsafe: %2")
                          : Text::tr("a setting of the %1 drive is worth fixing: %2"))
            .arg(axisText(axis), first);
    }
    return (dangerous ? Text::tr("%1 settings of the %2 drive are unsafe. The first: %3")
                      : Text::tr("%1 settings of the %2 drive are worth fixing. The first: %3"))
        .arg(QString::number(count), axisText(axis), first);
}

bool hasKnownMap(const FoundController& board)
{
    return board.known.value(Register::RegisterMapVersion) == moteus::kRegisterMapVersion;
}

}  // namespace

DriveCheck::DriveCheck(const profile::InForce& profile, const KnownBoards& known, AxisSet axes)
    : m_profile(profile), m_known(known), m_axes(axes), m_scan(moteus::kDiagnosticHostId, {moteus::versionQuery()})
{
    for (const Axis axis : axes) {
        m_sides.push_back({axis, profile->axis(axis).id, AxisCheck(*profile, axis)});
    }
}

void DriveCheck::profileChanged(const profile::Profile& before, const profile::Profile& after)
{
    for (Side& side : m_sides) {
        side.drive.profileChanged(before, after);
    }
    if (m_state != DriveCheckState::Done) {
        return;
    }
    if (std::ranges::all_of(m_sides, [](const Side& side) { return side.drive.isAllRead(); })) {
        collectFindings();
    } else {
        m_state = DriveCheckState::NotDone;
        m_retryAt = SteadyTime::min();
    }
}

void DriveCheck::begin(SteadyTime now)
{
    m_retrying = false;
    m_fixed = false;
    start(now);
}

void DriveCheck::start(SteadyTime now)
{
    m_retryAt.reset();
    m_state = DriveCheckState::Running;
    m_scan.begin(now);
}

void DriveCheck::forget()
{
    m_state = DriveCheckState::NotDone;
    m_retryAt.reset();
    m_retrying = false;
    m_fixed = false;
    m_unknownBoards.clear();
    m_findings.clear();
    for (Side& side : m_sides) {
        side.drive.forget();
        side.facts.reset();
    }
}

Result<> DriveCheck::mayFix() const
{
    if (m_state != DriveCheckState::Done) {
        return failure(ErrorCode::Busy, Text::tr("the drives are not read yet"));
    }
    if (isFixable()) {
        return {};
    }
    const bool right = std::ranges::none_of(
        m_sides, [](const Side& side) { return std::ranges::any_of(side.drive.lines(), differs); });
    return failure(
        ErrorCode::NotAvailable,
        right ? Text::tr("every setting is right")
              : Text::tr("Fix has nothing to write. Change the marked settings by hand. Each line explains how"));
}

Result<> DriveCheck::fix(SteadyTime)
{
    if (Result<> may = mayFix(); !may) {
        return may;
    }
    for (Side& side : m_sides) {
        if (side.drive.isFixable()) {
            side.drive.fix();
        }
    }
    m_state = DriveCheckState::Fixing;
    m_fixed = false;
    return {};
}

void DriveCheck::readOrigin(Axis axis)
{
    AxisCheck& drive = side(axis).drive;
    if (m_state == DriveCheckState::Done && !drive.isBusy()) {
        drive.readOrigin();
    }
}

bool DriveCheck::isFixable() const
{
    return std::ranges::any_of(m_sides, [](const Side& side) { return side.drive.isFixable(); });
}

void DriveCheck::setKnownBoards(const KnownBoards& known)
{
    if (std::exchange(m_known, known) != known && m_state == DriveCheckState::Done) {
        collectFindings();
    }
}

std::vector<CanFrame> DriveCheck::frames(SteadyTime now)
{
    if (m_retryAt && now >= *m_retryAt) {
        start(now);
    }
    if (m_state == DriveCheckState::Running && m_scan.isRunning()) {
        std::vector<CanFrame> frames = m_scan.frames(now);
        if (!m_scan.isRunning()) {
            endScan(now);
        }
        return frames;
    }
    std::vector<CanFrame> frames;
    for (Side& side : m_sides) {
        if (const std::optional<CanFrame> frame = side.drive.frame(now)) {
            frames.push_back(*frame);
        }
        if (side.facts) {
            side.facts->origin = side.drive.origin();
        }
    }
    const bool working = m_state == DriveCheckState::Running || m_state == DriveCheckState::Fixing;
    if (working && !anyBusy()) {
        endReading(now);
    }
    return frames;
}

void DriveCheck::take(const CanFrame& frame)
{
    const Result<moteus::Reply> reply = moteus::decodeReply(frame);
    if (!reply || reply->destination != moteus::kDiagnosticHostId || reply->prefix != 0) {
        return;
    }
    m_scan.take(*reply);
    bool rebooted = false;
    for (Side& side : m_sides) {
        const int reboots = side.drive.heartbeat().reboots();
        side.drive.take(*reply);
        rebooted = rebooted || side.drive.heartbeat().reboots() != reboots;
        if (side.facts) {
            side.facts->bootedAt = side.drive.heartbeat().bootedAt();
        }
    }
    if (rebooted && m_state == DriveCheckState::Done) {
        m_state = DriveCheckState::NotDone;
        m_retryAt = SteadyTime::min();  // with the next tick, because settings that were not stored are lost
    }
}

void DriveCheck::endScan(SteadyTime now)
{
    m_boards = m_scan.controllers();
    for (Side& side : m_sides) {
        const FoundController* board = onlyBoard(m_scan.controllers(), side.id);
        if (board == nullptr || !hasKnownMap(*board)) {
            side.drive.forget();
            side.facts.reset();
        } else {
            side.drive.read(board->known.uuid().value_or(moteus::Uuid{}));
        }
    }
    if (!anyBusy()) {
        endReading(now);
    }
}

bool DriveCheck::anyBusy() const
{
    return std::ranges::any_of(m_sides, [](const Side& side) { return side.drive.isBusy(); });
}

void DriveCheck::endReading(SteadyTime now)
{
    const bool complete = std::ranges::all_of(
        m_sides, [](const Side& side) { return side.drive.isComplete() && side.drive.isAllRead(); });
    const bool stored =
        std::ranges::all_of(m_sides, [](const Side& side) { return side.drive.fixTrouble().isEmpty(); });
    m_fixed = m_state == DriveCheckState::Fixing && complete && stored;
    m_retrying = !complete;
    m_state = complete ? DriveCheckState::Done : DriveCheckState::NotDone;
    m_retryAt = complete ? std::nullopt : std::optional(now + kRetryTime);
    for (Side& side : m_sides) {
        collectFacts(side);
    }
    collectUnknownBoards();
    collectFindings();
}

void DriveCheck::collectUnknownBoards()
{
    m_unknownBoards.clear();
    for (const FoundController& board : m_scan.controllers()) {
        if (std::ranges::find(m_sides, board.id, &Side::id) == m_sides.end() &&
            !profile::isFurtherBoard(*m_profile, board.id)) {
            m_unknownBoards.push_back({.id = board.id, .identity = identityOf(board)});
        }
    }
}

void DriveCheck::collectFacts(Side& side)
{
    const FoundController* board = onlyBoard(m_scan.controllers(), side.id);
    if (board == nullptr || !side.drive.isComplete()) {
        side.facts.reset();
        return;
    }
    const DriveIdentity identity = identityOf(*board);
    side.facts =
        DriveFacts{.uuid = identity.uuid,
                   .identity = identity,
                   .bootedAt = side.drive.heartbeat().bootedAt(),
                   .outputEncoder = side.drive.value("motor_position.output.reference_source").value_or(-1.0) >= 0.0,
                   .rotorToOutputRatio = side.drive.value("motor_position.rotor_to_output_ratio").value_or(0.0),
                   .holdsWhenNotFed = side.drive.value("servo.timeout_mode") == kTimeoutHold,
                   .origin = side.drive.origin()};
}

void DriveCheck::collectFindings()
{
    m_findings = identityFindings(*m_profile, m_known, m_scan.controllers(), m_axes);
    for (const Side& side : m_sides) {
        if (!side.drive.trouble().isEmpty()) {
            m_findings.push_back(
                {.kind = FindingKind::Unread,
                 .about = axisName(side.axis),
                 .weight = FindingWeight::Blocking,
                 .what = side.drive.trouble(),
                 .remedy = Text::tr("Check the power and the plugs of the board, and the bus cable.")});
        }
        if (!side.drive.fixTrouble().isEmpty()) {
            m_findings.push_back({.kind = FindingKind::NotStored,
                                  .about = axisName(side.axis),
                                  .weight = FindingWeight::Warning,
                                  .what = side.drive.fixTrouble(),
                                  .remedy = Text::tr("Press Fix again.")});
        }
        addProtectionFinding(side, Verdict::Dangerous);
        addProtectionFinding(side, Verdict::Advised);
    }
    std::ranges::stable_sort(m_findings, std::greater(), &Finding::weight);
}

// One finding for all lines of a kind. It names the first line, because the lines are sorted by importance.
void DriveCheck::addProtectionFinding(const Side& side, Verdict verdict)
{
    const auto& lines = side.drive.lines();
    const auto count = std::ranges::count(lines, verdict, &ProtectionLine::verdict);
    if (count == 0) {
        return;
    }
    const bool dangerous = verdict == Verdict::Dangerous;
    const auto worst = std::ranges::find(lines, verdict, &ProtectionLine::verdict);
    m_findings.push_back(
        {.kind = dangerous ? FindingKind::Dangerous : FindingKind::Advised,
         .about = axisName(side.axis),
         .weight = dangerous ? FindingWeight::Blocking : FindingWeight::Advice,
         .what = protectionText(dangerous, static_cast<int>(count), side.axis, lineText(*worst)),
         .remedy = Text::tr("Open the page Protection and press Fix. For a wrong gear ratio press Set gear.")});
}

Result<> DriveCheck::fitToMove() const
{
    if (!m_findings.empty() && m_findings.front().weight == FindingWeight::Blocking) {
        const Finding& worst = m_findings.front();
        return failure(ErrorCode::Refused, QString(worst.what + QStringLiteral(". ") + worst.remedy));
    }
    switch (m_state) {
        case DriveCheckState::NotDone:
            return failure(ErrorCode::Refused, Text::tr("The drive check has not run yet."));
        case DriveCheckState::Running:
            return failure(ErrorCode::Busy, Text::tr("The drive check is running. Wait some seconds."));
        case DriveCheckState::Fixing:
            return failure(ErrorCode::Busy,
                           Text::tr("Boresight is writing the settings of the drives. Wait until this ends."));
        case DriveCheckState::Done:
            break;
    }
    return {};
}

QString DriveCheck::progress() const
{
    if (m_retrying) {  // one text for the check that begins again every 2 seconds
        return Text::tr("Boresight cannot read all drives. It tries again every 2 s.");
    }
    if (m_state == DriveCheckState::Running && m_scan.isRunning()) {
        return Text::tr("looking for the drives");
    }
    if (m_fixed) {
        return Text::tr("the settings were written, read back and stored");
    }
    QStringList texts;
    for (const Side& side : m_sides) {
        if (const QString text = side.drive.progress(); !text.isEmpty()) {
            texts.push_back(text);
        } else if (m_state == DriveCheckState::NotDone && !side.drive.trouble().isEmpty()) {
            texts.push_back(side.drive.trouble());
        }
    }
    return texts.join(QStringLiteral(", "));
}

std::vector<Change> DriveCheck::takeChanges()
{
    std::vector<Change> changes;
    for (Side& side : m_sides) {
        std::ranges::move(side.drive.takeChanges(), std::back_inserter(changes));
    }
    return changes;
}

}  // namespace boresight::drive_check
