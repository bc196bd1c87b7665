// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus_mount/third_drive.h"

#include "core/alarms/catalogue.h"
#include "core/base/text.h"
#include "core/moteus_mount/drive_pair.h"
#include "core/moteus_mount/drive_readings.h"
#include "core/units/degrees_text.h"

#include <cassert>
#include <utility>

namespace boresight {
namespace {

// Our source id for the question about the register map. Its reply is no reply to the commands of kHostId.
constexpr std::uint8_t kVersionHostId = 0x12;
constexpr std::chrono::seconds kThirdPatience{2};
// A slower axis stands still. The velocity that a drive measures is noisy.
constexpr AngularRate kThirdAxisStanding = AngularRate::fromDegrees(0.1);

QString lossText(DriveLoss loss)
{
    switch (loss) {
        case DriveLoss::Silent:
            return Text::tr("its drive stopped replying");
        case DriveLoss::Fault:
            return Text::tr("its drive has a fault");
        case DriveLoss::TimedOut:
            return Text::tr("the watchdog of its drive expired");
        case DriveLoss::Released:
            return Text::tr("its drive was switched off by its power or by another program");
        case DriveLoss::Disobeys:
            return Text::tr("its drive does not obey");
        case DriveLoss::Blind:
            return Text::tr("its drive reports no position");
    }
    return {};
}

}  // namespace

ThirdDrive::ThirdDrive(const profile::InForce& profile, AlarmBoard& alarms)
    : m_profile(profile), m_alarms(alarms), m_id(profile->thirdAxis.axis.id)
{
    if (profile->thirdAxis.isUsed()) {
        m_drive.emplace(driveSettings(profile->thirdAxis.axis, *profile), "third axis");
    }
}

void ThirdDrive::take(const CanFrame& frame)
{
    if (!m_drive || m_drive->take(frame)) {
        return;
    }
    const auto reply = moteus::decodeReply(frame);
    if (reply && reply->prefix == 0 && reply->source == m_id && reply->destination == kVersionHostId) {
        const auto map = reply->value(moteus::Register::RegisterMapVersion);
        m_registerMap = map ? std::optional(static_cast<int>(*map)) : std::nullopt;
    }
}

void ThirdDrive::observe(SteadyTime now)
{
    m_now = now;
    if (!m_drive || m_released) {
        return;
    }
    m_started = m_started.value_or(now);
    profile::AxisSettings axis = m_profile->thirdAxis.axis;
    axis.id = m_id;  // a new id is in force after Reconnect
    m_drive->setSettings(driveSettings(axis, *m_profile));
    m_drive->judge(now);
    watch();
    tell();
}

void ThirdDrive::watch()
{
    if (!answers()) {
        m_registerMap.reset();  // another board may come back
    }
    if (const auto loss = m_drive->takeLoss()) {
        m_loss = lossText(*loss);
        m_setpoint.reset();
    }
    static_cast<void>(m_drive->takeFalsePlace());  // it is not believed
    if (m_drive->takeJump() && underOrders()) {
        m_drive->hold();
        m_loss = Text::tr("its position jumped");
        m_setpoint.reset();
    }
    watchFollowing();
}

// The set-point of a blocked axis must not run on, because the axis would jump after it once it is free.
void ThirdDrive::watchFollowing()
{
    const auto at = place();
    const bool isBehind =
        follows() && m_setpoint && at && abs(*m_setpoint - *at) > m_profile->supervision.followingStop;
    m_behind = isBehind ? std::optional(m_behind.value_or(m_now)) : std::nullopt;
    if (m_behind && m_now - *m_behind >= m_profile->supervision.followingTime) {
        m_drive->yield();
        m_loss = Text::tr("it does not follow, so something blocks it");
        m_setpoint.reset();
        m_behind.reset();
    }
}

bool ThirdDrive::isSilent() const
{
    const auto& report = m_drive->report();
    return m_now - (report ? report->received : m_started.value_or(m_now)) >= kThirdPatience;
}

void ThirdDrive::tell()
{
    const QString name = toQString(m_profile->thirdAxis.name);
    if (isSilent()) {
        m_alarms.raise(alarmEntry("third.silent"), {name, QString::number(m_id)});
    } else if (isFaulted()) {
        m_alarms.raise(alarmEntry("third.fault"), {name, readingsOf(*m_drive, m_now).fault});
    } else if (answers()) {
        m_alarms.clear(alarmEntry("third.fault"));
    }
}

std::vector<CanFrame> ThirdDrive::frames() const
{
    std::vector<CanFrame> frames;
    if (!m_drive || m_released) {
        return frames;
    }
    frames.push_back(m_drive->frame());
    if (answers() && !m_registerMap) {
        const auto question = moteus::encode({.destination = static_cast<std::uint8_t>(m_id),
                                              .source = kVersionHostId,
                                              .query = moteus::versionQuery()});
        assert(question);  // a fixed query
        frames.push_back(*question);
    }
    return frames;
}

void ThirdDrive::framesTaken()
{
    if (m_drive && !m_released) {
        m_drive->frameSent();
    }
}

void ThirdDrive::setReleased(bool released)
{
    m_released = released;
    if (m_drive) {
        m_drive->listen();
        m_drive->forgetPlace();
        m_registerMap.reset();
        m_setpoint.reset();
        m_started.reset();
        m_alarms.clear(alarmEntry("third.fault"));
    }
}

Result<> ThirdDrive::isKnownBoard() const
{
    if (!m_registerMap) {
        return failure(ErrorCode::Busy, Text::tr("Boresight is reading the board of the third axis. Wait a moment."));
    }
    if (*m_registerMap != moteus::kRegisterMapVersion) {
        return failure(ErrorCode::Refused, Text::tr("The board of the third axis has the register map %1. Boresight "
                                                    "knows the register map %2. Update the firmware of the board.")
                                               .arg(*m_registerMap)
                                               .arg(moteus::kRegisterMapVersion));
    }
    return {};
}

Result<> ThirdDrive::fit() const
{
    if (m_released) {
        return failure(ErrorCode::NoAnswer, Text::tr("The bus is released to other tools. Take the bus back first."));
    }
    if (!answers()) {
        return failure(ErrorCode::NoAnswer,
                       Text::tr("The drive of the third axis does not reply. Check its power and its plugs."));
    }
    if (isFaulted()) {
        return failure(ErrorCode::Refused, Text::tr("The drive of the third axis has a fault: %1. Remove the cause and "
                                                    "press Re-arm.")
                                               .arg(readingsOf(*m_drive, m_now).fault));
    }
    if (Result<> known = isKnownBoard(); !known) {
        return known;
    }
    if (!place()) {
        return failure(ErrorCode::NoAnswer, Text::tr("The third axis reports no position. Check its encoder."));
    }
    const bool isReferenced = m_drive->report()->homeState == moteus::HomeState::Output;
    if (!isReferenced && m_profile->thirdAxis.axis.powerUpPosition == profile::PowerUpPosition::Ambiguous) {
        return failure(ErrorCode::Refused,
                       Text::tr("The board of the third axis does not know its position after power-up. Set the "
                                "position with moteus tview (d exact). If the axis has an encoder of its own, set "
                                "third_axis.power_up_position to \"trusted\"."));
    }
    return {};
}

bool ThirdDrive::isFaulted() const
{
    return m_drive && m_drive->report() && m_drive->report()->mode == moteus::Mode::Fault;
}

std::optional<Angle> ThirdDrive::place() const
{
    return m_drive && m_drive->place() ? std::optional(geometry().toAxis(m_drive->place()->position)) : std::nullopt;
}

bool ThirdDrive::underOrders() const
{
    return m_drive && m_drive->phase() != Drive::Phase::Listening;
}

bool ThirdDrive::follows() const
{
    return m_drive && m_drive->phase() == Drive::Phase::Engaged;
}

void ThirdDrive::describe(ThirdAxisStatus& status) const
{
    using State = ThirdAxisStatus::State;
    const auto& report = m_drive ? m_drive->report() : std::optional<DriveReport>();
    if (!report) {
        return;
    }
    const DriveReadings readings = readingsOf(*m_drive, m_now);
    status.place = place();
    status.rate = report->rate ? std::optional(geometry().toAxis(*report->rate)) : std::nullopt;
    status.age = readings.age;
    status.mode = readings.mode;
    status.fault = report->fault != 0 ? readings.fault : QString();
    status.boardTemperature = report->boardTemperature;
    if (!answers()) {
        status.state = State::NoData;
    } else if (isFaulted()) {
        status.state = State::Fault;
    } else if (status.rate && abs(*status.rate) > kThirdAxisStanding) {
        status.state = State::Moving;
    } else {
        const bool isOff = report->mode == moteus::Mode::Stopped;
        status.state = isOff ? State::Off : State::Holding;
    }
}

void ThirdDrive::engage()
{
    if (m_drive && !m_released) {
        m_drive->engage();
    }
}

std::optional<Angle> ThirdDrive::takeFollowing()
{
    return m_drive && m_drive->takeEngaged() ? place() : std::nullopt;
}

void ThirdDrive::command(const tracking::Setpoint& setpoint)
{
    if (m_drive) {
        m_setpoint = setpoint.position;
        m_drive->setSetpoint({.position = geometry().toMotor(setpoint.position),
                              .rate = geometry().toMotor(setpoint.rate),
                              .acceleration = geometry().toMotor(setpoint.acceleration)});
    }
}

void ThirdDrive::brakeHard(bool hard)
{
    if (m_drive) {
        m_drive->setHardBraking(hard);
    }
}

std::optional<QString> ThirdDrive::takeLoss()
{
    return std::exchange(m_loss, std::nullopt);
}

void ThirdDrive::seize()
{
    if (answers() && m_registerMap == moteus::kRegisterMapVersion) {
        m_drive->seize();
    }
}

void ThirdDrive::recover()
{
    if (isFaulted() && isKnownBoard()) {
        m_drive->recover();
    }
}

void ThirdDrive::leave(profile::OnExit how)
{
    if (!underOrders()) {
        return;
    }
    switch (how) {
        case profile::OnExit::Hold:
            m_drive->listen();  // its time-out mode decides whether the drive holds the axis
            break;
        case profile::OnExit::Brake:
            m_drive->brake();
            break;
        case profile::OnExit::Off:
            m_drive->release();
            break;
    }
}

}  // namespace boresight
