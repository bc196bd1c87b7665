// SPDX-License-Identifier: GPL-3.0-or-later
// The part of StationControl about its clients: who of them and of the operator moves the mount.
#include "core/base/text.h"
#include "core/control/calibration_source.h"
#include "core/control/station_control.h"

namespace boresight {
namespace {

// Longer than a tracking client pauses between two targets, short enough that the screen asks about what happens now.
constexpr std::chrono::seconds kStillWanting{5};
const QString kOutside = QStringLiteral("target");

}  // namespace

Result<> StationControl::handle(const request::TakeAuthority&, const Source& source)
{
    takeOver(source);
    if (m_current.commander().kind == SourceKind::Client && !m_current.is(Activity::None)) {
        holdHere(Activity::Holding);
    }
    return {};
}

Result<> StationControl::handle(const request::GiveAuthority&, const Source& source)
{
    return gates().mayGiveControl().map([&] {
        endCalibrationMotion();
        m_arming.setAuthority(Authority::Clients);
        m_lead.resume(m_now);
        m_log.add(Severity::Advisory, source.name, Text::tr("gives control back to the clients"));
    });
}

Result<> StationControl::handle(const request::GiveLead& wanted, const Source& source)
{
    return operatorOnly(source)
        .and_then([&] { return gates().mayGiveLead(wanted.clientId); })
        .and_then([&] { return m_lead.give(m_profile.rotctld, wanted.clientId, m_now); })
        .map([&] {
            if (m_current.commander().clientId != wanted.clientId) {
                endClientMotion();
            }
            endCalibrationMotion();
            m_arming.setAuthority(Authority::Clients);
            m_log.add(Severity::Advisory, source.name,
                      Text::tr("gives control to %1").arg(m_lead.name(wanted.clientId)));
        });
}

Result<> StationControl::handle(const request::SetReadOnly& wanted, const Source& source)
{
    return operatorOnly(source).and_then([&] { return m_lead.setReadOnly(wanted.clientId, wanted.readOnly); }).map([&] {
        if (wanted.readOnly && m_current.commander().clientId == wanted.clientId) {
            endClientMotion();
        }
        m_log.add(Severity::Advisory, source.name,
                  (wanted.readOnly ? Text::tr("lets %1 only read and stop") : Text::tr("lets %1 move the mount again"))
                      .arg(m_lead.name(wanted.clientId)));
    });
}

// The Station does it, which has the server.
Result<> StationControl::handle(const request::Disconnect&, const Source& source)
{
    return operatorOnly(source);
}

void StationControl::endClientMotion()
{
    if (followsClient()) {
        m_log.add(Severity::Advisory, m_current.commander().name, Text::tr("may not move the mount any more: hold"));
        holdHere(Activity::Holding);
    }
}

// Who follows a body or swings the compass asks for the next motion soon, and would take the control back with it.
void StationControl::endCalibrationMotion()
{
    m_current.setErrand(m_current.errand() + 1);
    if (obeys(calibrationSource())) {
        m_log.add(Severity::Advisory, m_current.commander().name, Text::tr("ends the motion: hold"));
        holdHere(Activity::Holding);
    }
}

void StationControl::sourceGone(const Source& source)
{
    m_lead.gone(source);
    if (!m_current.isFor(source)) {
        return;
    }
    if (m_current.is(Activity::Running)) {
        m_log.add(Severity::Advisory, source.name, Text::tr("is gone: its motion ends"));
        holdHere(Activity::Holding);
    } else if (m_current.is(Activity::Streaming)) {
        m_motion.settleStream();
        m_current.settleStream();
    }
}

void StationControl::positionRead(std::uint64_t clientId)
{
    if (m_current.is(Activity::Streaming) && followsClient() && m_current.isForClient(clientId)) {
        m_motion.confirmStream(m_now);
        m_lead.followed(clientId, m_now);
    }
}

void StationControl::describe(ClientStatus& client, const std::optional<SteadyTime>& lastMotion) const
{
    const profile::RotctldSettings& rules = m_profile.rotctld;
    const Source source{.kind = SourceKind::Client, .clientId = client.id};
    client.driving = m_current.isForClient(client.id) && !m_current.text().isEmpty();
    client.leading = m_lead.leads(rules, client.id, m_now);
    client.readOnly = m_lead.readOnly(client.id);
    client.locked = m_lead.locked(rules, client.id);
    const bool kept = rules.lead == profile::Lead::Locked && !client.locked;  // as the operator wants it
    client.wanting = lastMotion && m_now - *lastMotion < kStillWanting && m_arming.authority() == Authority::Clients &&
                     !client.readOnly && !kept && !m_lead.admits(rules, source, m_now);
    client.leadObstacle = leadObstacle(client);
    if (const QString reason = limitedReason(); client.driving && !reason.isEmpty()) {
        client.advice =
            Text::tr("asks for a place outside the limits: %1; the nearest permitted one is driven").arg(reason);
    }
}

// What would be refused, and what would change nothing.
QString StationControl::leadObstacle(const ClientStatus& client) const
{
    if (const Result<> may = gates().mayGiveLead(client.id); !may) {
        return toQString(may.error().text);
    }
    if (m_arming.authority() == Authority::Operator || client.readOnly) {
        return {};
    }
    if (m_profile.rotctld.lead == profile::Lead::Last) {
        return Text::tr("whoever sends last moves the mount");
    }
    return client.leading ? Text::tr("it has the control") : QString();
}

// The protocol has no word for it: a client is answered "done". So the screen must say it, for as long as it lasts.
void StationControl::watchLimited()
{
    const QString reason = limitedReason();
    if (reason.isEmpty()) {
        m_alarms.clear(kOutside);
        return;
    }
    m_alarms.raise(kOutside, Severity::Advisory,
                   {.what = Text::tr("the target is outside the limits"),
                    .action = Text::tr("LIMITED, the nearest permitted point is driven: %1").arg(reason),
                    .remedy = Text::tr("None needed: the mount follows on when the target comes inside")});
}

}  // namespace boresight
