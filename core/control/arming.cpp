// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/control/arming.h"

#include "core/base/text.h"

#include <algorithm>

namespace boresight {
namespace {

// Right after a connection comes back, somebody may still stand at the mast with the cable in the hand.
constexpr std::chrono::seconds kQuietAfterReturn{1};

}  // namespace

Result<> operatorOnly(const Source& source)
{
    if (source.kind != SourceKind::Operator) {
        return failure(ErrorCode::Refused, Text::tr("only the operator may do this"));
    }
    return {};
}

Arming::Arming(const profile::InForce& profile, MountDriver& mount, EventLog& log)
    : m_profile(profile), m_mount(mount), m_log(log), m_retry(profile)
{}

Result<> Arming::isReady() const
{
    if (Result<> available = m_mount.available(); !available) {
        return available;
    }
    if (!m_connected) {
        const Axis silent = m_mount.report(Axis::Azimuth).answers ? Axis::Elevation : Axis::Azimuth;
        return failure(ErrorCode::NoAnswer, Text::tr("no reply from the %1").arg(m_mount.label(silent)));
    }
    if (m_closing) {
        return failure(ErrorCode::Refused, Text::tr("Boresight is closing"));
    }
    if (m_now < m_quietUntil) {
        return failure(ErrorCode::Refused, Text::tr("The drives have just come back. Wait a second."));
    }
    if (m_stopLatched) {
        return failure(ErrorCode::Refused, Text::tr("STOP is latched. Reset STOP first."));
    }
    if (const auto reason = fault()) {
        return failure(ErrorCode::Refused, Text::tr("%1. Re-arm first.").arg(*reason));
    }
    return {};
}

Result<> Arming::admits(const Source& source) const
{
    return isReady().and_then([&] { return mayCommand(source); }).and_then([this] { return m_mount.interlock(); });
}

Result<> Arming::mayCommand(const Source& source) const
{
    if (source.kind == SourceKind::Client && m_authority == Authority::Operator) {
        return failure(ErrorCode::Refused, Text::tr("The operator has control. Press Hand over first."));
    }
    return {};
}

void Arming::latchStop()
{
    m_stopLatched = true;
    m_authority = Authority::Operator;
}

// An act takes the authority only from the clients. If the operator has it already, an act changes nothing.
void Arming::takeAuthority(Taking how)
{
    if (m_authority == Authority::Clients || how == Taking::Explicitly) {
        m_taken = how;
    }
    m_authority = Authority::Operator;
}

void Arming::giveAuthority()
{
    m_authority = Authority::Clients;
    m_taken.reset();
}

Result<> Arming::mayResetStop() const
{
    return m_stopLatched ? Result<>{} : failure(ErrorCode::Refused, Text::tr("STOP is not latched"));
}

Result<> Arming::resetStop()
{
    return mayResetStop().map([this] { m_stopLatched = false; });
}

bool Arming::losesConnection(SteadyTime now)
{
    m_now = now;
    for (const Axis axis : kAxes) {
        noteConditions(axis);
    }
    const bool connected = m_mount.answers() && m_mount.available();
    if (connected == m_connected) {
        return false;
    }
    m_connected = connected;
    if (connected) {
        m_log.add(Severity::Advisory, QStringLiteral("station"), Text::tr("every drive answers, and nothing moves"));
        m_quietUntil = m_wasConnected ? now + kQuietAfterReturn : now;
        m_wasConnected = true;
        return false;
    }
    m_log.add(Severity::Warning, QStringLiteral("station"),
              !m_mount.available() ? Text::tr("the bus is released to other tools")
                                   : Text::tr("a drive has stopped answering"));
    return true;
}

void Arming::lost(Axis axis, supervision::LossClass kind, const QString& reason)
{
    const auto same = [&](const Loss& loss) { return loss.axis == axis && loss.kind == kind; };
    if (std::ranges::none_of(m_losses, same)) {
        m_losses.push_back({.axis = axis, .kind = kind, .reason = reason, .conditions = m_told[index(axis)]});
    }
    m_retry.lost(kind, m_now);
    m_rearming = false;
}

std::optional<QString> Arming::fault() const
{
    return m_losses.empty() ? std::nullopt : std::optional(m_losses.front().reason);
}

supervision::DriveConditions Arming::conditions(Axis axis) const
{
    const AxisReport report = m_mount.report(axis);
    return {.voltage = report.voltage,
            .boardTemperature = report.boardTemperature,
            .motorTemperature = report.motorTemperature};
}

// The last reply of a drive before its loss may lack some of the values, so older values are kept.
void Arming::noteConditions(Axis axis)
{
    const supervision::DriveConditions now = conditions(axis);
    supervision::DriveConditions& told = m_told[index(axis)];
    if (!m_mount.report(axis).answers) {
        told = {};  // another drive may come back
        return;
    }
    told = {.voltage = now.voltage ? now.voltage : told.voltage,
            .boardTemperature = now.boardTemperature ? now.boardTemperature : told.boardTemperature,
            .motorTemperature = now.motorTemperature ? now.motorTemperature : told.motorTemperature};
}

// The temperature or the supply voltage that led to a fault still exists, or would lead to the next fault.
QString Arming::rearmObstacle() const
{
    const auto of = [this](Axis axis, const QString& why) {
        return why.isEmpty() ? QString() : QStringLiteral("%1: %2").arg(m_mount.label(axis), why);
    };
    QString obstacle;
    for (const Loss& loss : m_losses) {
        obstacle = of(loss.axis, supervision::clearRefusal(m_profile->supervision, loss.kind, loss.conditions,
                                                           conditions(loss.axis)));
        if (!obstacle.isEmpty()) {
            return obstacle;
        }
    }
    for (const Axis axis : kAxes) {
        obstacle = obstacle.isEmpty() ? of(axis, supervision::standingRefusal(m_profile->supervision, conditions(axis)))
                                      : obstacle;
    }
    return obstacle;
}

Result<> Arming::mayRearm(const Source& source) const
{
    if (source.kind == SourceKind::Client && m_authority == Authority::Operator) {
        return failure(ErrorCode::Refused, Text::tr("The operator has control. Only the operator can re-arm."));
    }
    if (m_losses.empty()) {
        return failure(ErrorCode::Refused, Text::tr("there is no fault to re-arm from"));
    }
    if (m_closing) {
        return failure(ErrorCode::Refused, Text::tr("Boresight is closing"));
    }
    if (!m_connected) {
        return failure(ErrorCode::NoAnswer, Text::tr("every drive must answer before re-arming"));
    }
    if (const QString why = rearmObstacle(); !why.isEmpty()) {
        return failure(ErrorCode::Refused, why);
    }
    return {};
}

Result<> Arming::rearm(const Source& source)
{
    if (Result<> may = mayRearm(source); !may) {
        return may;
    }
    m_log.add(Severity::Advisory, source.name, Text::tr("re-arms. Drives in fault or time-out are stopped first"));
    if (source.kind == SourceKind::Operator) {
        takeAuthority(Taking::ByAct);  // a client that still sends must not move the mount at once
    }
    m_retry.rearmed();
    beginRearm();
    return {};
}

void Arming::beginRearm()
{
    m_mount.recover();
    m_rearming = true;
}

// The recovery policy of the profile, for a station without an operator. It re-arms and never moves the mount.
void Arming::retry()
{
    const auto due = m_retry.nextTry();
    if (!due || m_now < *due || m_rearming || m_losses.empty() || m_stopLatched || !m_connected || m_closing ||
        m_now < m_quietUntil || !rearmObstacle().isEmpty()) {
        return;
    }
    m_retry.tried(m_now);
    m_log.add(Severity::Warning, QStringLiteral("station"),
              Text::tr("re-arms by the recovery policy of the profile, and nothing moves by itself"));
    beginRearm();
}

bool Arming::completesRearm()
{
    if (m_losses.empty()) {
        m_retry.healthy(m_now);
    }
    retry();
    if (!m_rearming || m_mount.changesHands()) {
        return false;
    }
    m_rearming = false;
    m_losses.clear();
    return true;
}

}  // namespace boresight
