// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/control/client_desk.h"

#include "core/base/text.h"
#include "core/control/calibration_source.h"
#include "core/control/status_report.h"

namespace boresight {
namespace {

// Longer than the pause of a tracking client between two targets. Short enough that the screen only asks about clients
// that want control now.
constexpr std::chrono::seconds kStillWanting{5};

}  // namespace

Result<> ClientDesk::ask(const request::TakeAuthority&, const Source& by)
{
    m_helm.takeOver(by, Taking::Explicitly);
    if (m_helm.current().commander().kind == SourceKind::Client && !m_helm.current().is(Activity::None)) {
        m_helm.hold(Activity::Holding);
    }
    return {};
}

Result<> ClientDesk::ask(const request::GiveAuthority&, const Source& by)
{
    return Gates(m_helm.view()).mayGiveControl().map([&] {
        letClientsMove();
        m_clientControl.resume(m_helm.now());
        m_log.add(Severity::Advisory, by.name, Text::tr("gives control back to the clients"));
    });
}

Result<> ClientDesk::ask(const request::GiveControl& wanted, const Source& by)
{
    const ControlParts view = m_helm.view();
    return operatorOnly(by)
        .and_then([&] { return Gates(view).mayGiveControlTo(wanted.clientId); })
        .and_then([&] { return m_clientControl.give(view.profile.rotctld, wanted.clientId, view.now); })
        .map([&] {
            if (m_helm.current().commander().clientId != wanted.clientId) {
                endClientMotion();
            }
            letClientsMove();
            m_log.add(Severity::Advisory, by.name,
                      Text::tr("gives control to %1").arg(m_clientControl.name(wanted.clientId)));
        });
}

Result<> ClientDesk::ask(const request::SetReadOnly& wanted, const Source& by)
{
    return operatorOnly(by)
        .and_then([&] { return m_clientControl.setReadOnly(wanted.clientId, wanted.readOnly); })
        .map([&] {
            if (wanted.readOnly && m_helm.current().commander().clientId == wanted.clientId) {
                endClientMotion();
            }
            m_log.add(
                Severity::Advisory, by.name,
                (wanted.readOnly ? Text::tr("lets %1 only read and stop") : Text::tr("lets %1 move the mount again"))
                    .arg(m_clientControl.name(wanted.clientId)));
        });
}

Result<> ClientDesk::ask(const request::Disconnect&, const Source& by)
{
    return operatorOnly(by);
}

void ClientDesk::letClientsMove()
{
    endCalibrationMotion();
    m_arming.giveAuthority();
}

void ClientDesk::endClientMotion()
{
    if (m_helm.current().commander().kind == SourceKind::Client && m_helm.current().moves()) {
        m_helm.end(Severity::Advisory, Text::tr("may no longer move the mount, so the mount holds"));
    }
}

// The source of a running calibration asks for its next motion soon, and would take the control back with it.
void ClientDesk::endCalibrationMotion()
{
    m_helm.nextMotionId();
    if (m_helm.current().isFor(calibrationSource()) && m_helm.current().moves()) {
        m_helm.end(Severity::Advisory, Text::tr("ends the motion, and the mount holds"));
    }
}

bool ClientDesk::isWanting(const ClientStatus& client, const std::optional<SteadyTime>& lastMotion) const
{
    const ControlParts view = m_helm.view();
    const profile::RotctldSettings& rules = view.profile.rotctld;
    const Source source{.kind = SourceKind::Client, .clientId = client.id};
    const bool kept =
        rules.control == profile::ControlRule::Locked && !client.locked;  // the operator locked the mount on purpose
    return lastMotion && view.now - *lastMotion < kStillWanting && m_arming.authority() == Authority::Clients &&
           !client.readOnly && !kept && !m_clientControl.admits(rules, source, view.now);
}

// The reason why giving control to this client is refused, or would change nothing.
QString ClientDesk::controlObstacle(const ClientStatus& client) const
{
    const ControlParts view = m_helm.view();
    if (const Result<> may = Gates(view).mayGiveControlTo(client.id); !may) {
        return may.error().text;
    }
    if (m_arming.authority() == Authority::Operator || client.readOnly) {
        return {};
    }
    if (view.profile.rotctld.control == profile::ControlRule::Last) {
        return Text::tr("the client that sent last has control");
    }
    return client.inControl ? Text::tr("this client has control") : QString();
}

void ClientDesk::describe(ClientStatus& client, const std::optional<SteadyTime>& lastMotion) const
{
    const ControlParts view = m_helm.view();
    const profile::RotctldSettings& rules = view.profile.rotctld;
    client.driving = view.current.isForClient(client.id) && !view.current.text().isEmpty();
    client.inControl = m_clientControl.hasControl(rules, client.id, view.now);
    client.readOnly = m_clientControl.readOnly(client.id);
    client.locked = m_clientControl.locked(rules, client.id);
    client.wanting = isWanting(client, lastMotion);
    client.controlObstacle = controlObstacle(client);
    if (const QString reason = StatusReport(view).limitedReason(); client.driving && !reason.isEmpty()) {
        client.advice =
            Text::tr("asks for a position outside the limits (%1). The mount goes to the nearest permitted position")
                .arg(reason);
    }
}

}  // namespace boresight
