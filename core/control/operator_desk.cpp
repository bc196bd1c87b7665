// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/control/operator_desk.h"

#include "core/base/text.h"
#include "core/base/time_of_day.h"
#include "core/control/drive_gates.h"
#include "core/profile/setting.h"

namespace boresight {
namespace {

Result<> makesSense(const profile::Profile& profile)
{
    const auto problems = profile::problemsOf(profile);
    if (!problems.empty()) {
        return failure(ErrorCode::InvalidInput, profile::toText(problems.front()));
    }
    return {};
}

}  // namespace

Result<> OperatorDesk::ask(const request::ClearTrim&, const Source& by)
{
    return operatorOnly(by).map([&] {
        if (gates().mayClearTrim()) {
            m_of.helm.setTrim({}, by);
        }
    });
}

Result<> OperatorDesk::ask(const request::HoldAtEnd&, const Source& by)
{
    return operatorOnly(by).and_then([&] { return gates().mayHoldAtEnd(); }).map([&] { m_of.helm.keepWrap(by); });
}

Result<> OperatorDesk::ask(const request::UseAntenna& wanted, const Source& by)
{
    return operatorOnly(by).and_then([&] { return gates().mayUseAntenna(); }).and_then([&] {
        return m_of.antenna.choose(wanted.name);
    });
}

Result<> OperatorDesk::ask(const request::OverrideWind&, const Source& by)
{
    return operatorOnly(by).and_then([this] { return m_of.wind.mayOverride(); }).map([&] {
        m_of.wind.override();
        m_of.log.add(Severity::Warning, by.name,
                     Text::tr("lets the mount move in the wind until %1")
                         .arg(timeOfDayText(m_of.wind.status().overriddenUntil.value_or(m_of.clock.utc()))));
    });
}

Result<> OperatorDesk::ask(const request::AcknowledgeAlarms&, const Source&)
{
    m_of.alarms.acknowledgeAll();
    return {};
}

Result<> OperatorDesk::ask(const request::AcknowledgeAlarm& wanted, const Source&)
{
    m_of.alarms.acknowledge(wanted.alarmId);
    return {};
}

Result<> OperatorDesk::ask(const request::ApplyProfile& wanted, const Source& by)
{
    return operatorOnly(by).and_then([&] { return makesSense(wanted.profile); }).and_then([&] {
        return gates().mayTurnBeam(wanted.profile).and_then([&] { return m_of.brake.mayChange(wanted.profile); });
    });
}

Result<> OperatorDesk::ask(const request::Reconnect& wanted, const Source& by)
{
    return operatorOnly(by).and_then([this] { return DriveGates(m_of.helm.view()).drivesRest(); }).and_then([&] {
        return makesSense(wanted.profile);
    });
}

}  // namespace boresight
