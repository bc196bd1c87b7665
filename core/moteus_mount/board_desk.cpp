// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus_mount/board_desk.h"

#include "core/base/text.h"
#include "core/drive_check/identity_findings.h"
#include "core/drive_check/protections.h"
#include "core/moteus/describe.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace boresight {
namespace {

const QString kBoardSource = QStringLiteral("drives");
constexpr const char* kRatioKey = "motor_position.rotor_to_output_ratio";

QString uuidOf(const drive_check::FoundController& board)
{
    return drive_check::identityOf(board).uuid;
}

bool sharesItsId(const std::vector<drive_check::FoundController>& boards, const drive_check::FoundController& one)
{
    return one.isUnreadable() || std::ranges::count(boards, one.id, &drive_check::FoundController::id) > 1;
}

double wantedRatio(const profile::AxisSettings& axis)
{
    return axis.geometry.gearIn == pointing::GearIn::Drive ? 1.0 / axis.geometry.gearRatio : 1.0;
}

// The gains refer to output turns and output torque. To keep the stiffness at the motor, the gains change with the
// square of the change of the gear, and the limit of the integral changes with the change itself. Source:
// motor_position and bldc_servo of the firmware.
std::vector<drive_check::BoardSetting> gainsForGear(double change)
{
    const double square = change * change;
    return {{"servo.pid_position.kp", square},
            {"servo.pid_position.ki", square},
            {"servo.pid_position.kd", square},
            {"servo.pid_position.ilimit", std::abs(change)},
            {"servo.inertia_feedforward", square, true}};
}

QString numberText(double value)
{
    return QString::number(value, 'g', 6);
}

}  // namespace

bool BoardDesk::hasDrive(Axis axis) const
{
    return std::ranges::find(m_axes, axis) != m_axes.end();
}

Result<> BoardDesk::mayAssign(Axis axis) const
{
    const auto refuse = [](const QString& why) -> Result<> { return failure(ErrorCode::Refused, why); };
    if (isRunning()) {
        return failure(ErrorCode::Busy, m_change.progress());
    }
    if (!hasDrive(axis)) {
        return failure(ErrorCode::NotAvailable, Text::tr("This axis has no moteus drive."));
    }
    const auto& boards = m_driveCheck.boards();
    if (boards.empty()) {
        return refuse(Text::tr("No board answers. Connect the board of the %1.").arg(drive_check::axisText(axis)));
    }
    if (const auto shared = std::ranges::find_if(boards, [&](const auto& one) { return sharesItsId(boards, one); });
        shared != boards.end()) {
        return refuse(
            Text::tr(
                "Two boards have the id %1. Switch the power off. Disconnect one board. Switch the power on again.")
                .arg(shared->id));
    }
    if (boards.size() > 1) {
        return refuse(Text::tr("More than one board is connected. Leave only the board of the %1 connected.")
                          .arg(drive_check::axisText(axis)));
    }
    if (boards.front().id == m_profile->axis(axis).id) {
        return refuse(Text::tr("This board has the id %1 of the %2 already.")
                          .arg(boards.front().id)
                          .arg(drive_check::axisText(axis)));
    }
    return {};
}

Result<> BoardDesk::maySetGear(Axis axis) const
{
    if (isRunning()) {
        return failure(ErrorCode::Busy, m_change.progress());
    }
    if (m_driveCheck.state() == DriveCheckState::Running || m_driveCheck.state() == DriveCheckState::Fixing) {
        return failure(ErrorCode::Busy, Text::tr("Boresight is reading the drives. Wait a moment."));
    }
    return gear(axis) && drive_check::onlyBoard(m_driveCheck.boards(), m_profile->axis(axis).id) != nullptr
               ? Result<>{}
               : failure(ErrorCode::NotAvailable,
                         Text::tr("The gear ratio in the drive is right, or it was not read."));
}

Result<> BoardDesk::admits(const request::AssignBoard& wanted) const
{
    return mayAssign(wanted.axis).and_then([&]() -> Result<> {
        return uuidOf(m_driveCheck.boards().front()) == wanted.board
                   ? Result<>{}
                   : failure(ErrorCode::Refused,
                             Text::tr("The connected board is not the board that you confirmed. Check it again."));
    });
}

Result<> BoardDesk::admits(const request::SetGear& wanted) const
{
    return maySetGear(wanted.axis);
}

void BoardDesk::begin(const request::AssignBoard& wanted, SteadyTime now)
{
    const drive_check::FoundController& board = m_driveCheck.boards().front();
    const int id = m_profile->axis(wanted.axis).id;
    m_isGear = false;
    m_done = Text::tr(
                 "The board %1 has the id %2 now. Boresight read it back and stored it. Switch the power off. Connect "
                 "the other board. Switch the power on.")
                 .arg(uuidOf(board))
                 .arg(id);
    m_log.add(Severity::Warning, kBoardSource,
              Text::tr("setting the id of board %1 to %2. The old id is %3").arg(uuidOf(board)).arg(id).arg(board.id));
    m_change.begin({.board = board.known.uuid(),
                    .id = board.id,
                    .newId = id,
                    .key = "id.id",
                    .value = static_cast<double>(id),
                    .alone = true,
                    .what = Text::tr("the id %1").arg(id)},
                   now);
}

void BoardDesk::begin(const request::SetGear& wanted, SteadyTime now)
{
    const profile::AxisSettings& axis = m_profile->axis(wanted.axis);
    const drive_check::FoundController* const board = drive_check::onlyBoard(m_driveCheck.boards(), axis.id);
    if (board == nullptr) {
        return;  // admits() has refused this case
    }
    const double ratio = wantedRatio(axis);
    m_done = Text::tr(
                 "The gear ratio of the %1 drive is %2 now. Boresight read it back and stored it, with the gains that "
                 "depend on it. Press Fix next to write limits and speeds. Then check the tuning.")
                 .arg(drive_check::axisText(wanted.axis), numberText(ratio));
    m_geared = wanted.axis;
    m_isGear = true;
    m_log.add(Severity::Warning, kBoardSource,
              Text::tr("writing the gear ratio %1 into the %2 drive")
                  .arg(numberText(ratio), drive_check::axisText(wanted.axis)));
    m_change.begin({.board = board->known.uuid(),
                    .id = axis.id,
                    .newId = axis.id,
                    .key = kRatioKey,
                    .value = ratio,
                    .scaled = gainsForGear(m_driveCheck.facts(wanted.axis)->rotorToOutputRatio / ratio),
                    .what = Text::tr("the gear ratio")},
                   now);
}

std::vector<CanFrame> BoardDesk::frames(SteadyTime now, bool& ended)
{
    std::vector<CanFrame> frames = m_change.frames(now);
    ended = !m_change.isRunning();
    if (ended) {
        finish();
    }
    return frames;
}

void BoardDesk::finish()
{
    const Result<>& outcome = *m_change.outcome();
    m_ended = std::exchange(m_geared, std::nullopt);
    m_log.add(outcome ? Severity::Advisory : Severity::Warning, kBoardSource, outcome ? m_done : outcome.error().text);
}

void BoardDesk::take(const CanFrame& frame)
{
    const Result<moteus::Reply> reply = moteus::decodeReply(frame);
    if (reply && reply->destination == moteus::kDiagnosticHostId && reply->prefix == 0) {
        m_change.take(*reply);
    }
}

std::optional<GearCorrection> BoardDesk::gear(Axis axis) const
{
    if (!hasDrive(axis)) {
        return std::nullopt;
    }
    const auto& lines = m_driveCheck.protections(axis);
    const auto line = std::ranges::find(lines, QLatin1String(kRatioKey), &ProtectionLine::key);
    const auto& facts = m_driveCheck.facts(axis);
    if (line == lines.end() || line->verdict != Verdict::Dangerous || !facts) {
        return std::nullopt;
    }
    const double wanted = wantedRatio(m_profile->axis(axis));
    const double found = facts->rotorToOutputRatio;
    return GearCorrection{
        .found = numberText(found),
        .wanted = numberText(wanted),
        .effect = Text::tr("The limits, speeds and gains of the drive count turns of the axis. Boresight multiplies "
                           "kp, ki and kd by %1. The motor stays as stiff as before. Press Fix afterwards to write "
                           "limits and speeds. Boresight asks for the cable wrap again.")
                      .arg(numberText(std::pow(found / wanted, 2)))};
}

void BoardDesk::fill(DrivesStatus& drives) const
{
    drives.boards.clear();
    for (const drive_check::FoundController& board : m_driveCheck.boards()) {
        const bool shared = sharesItsId(m_driveCheck.boards(), board);
        drives.boards.push_back({.id = board.id, .uuid = uuidOf(board), .shared = shared});
    }
    const auto& outcome = m_change.outcome();
    // When all boards have been read, the advice which board to connect next is out of date.
    const bool over = !m_isGear && m_driveCheck.state() == DriveCheckState::Done;
    const QString ended = !outcome || over ? QString() : *outcome ? m_done : outcome->error().text;
    BoardWork& work = m_isGear ? drives.gearWork : drives.boardWork;
    work.running = isRunning();
    work.failed = !isRunning() && !ended.isEmpty() && !*outcome;
    work.text = isRunning() ? m_change.progress() : ended;
    drives.azimuth.gear = gear(Axis::Azimuth);
    drives.elevation.gear = gear(Axis::Elevation);
}

void BoardDesk::judge(Permissions& may) const
{
    const auto add = [&may](Action action, const Result<>& answer) {
        may.refuse(action, answer ? QString() : answer.error().text);
    };
    for (const Axis axis : kAxes) {
        add(assignBoardAction(axis), mayAssign(axis));
        add(setGearAction(axis), maySetGear(axis));
    }
}

}  // namespace boresight
