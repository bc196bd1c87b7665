// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/clients/clients_permission.h"

#include <QCoreApplication>

namespace boresight::ui {

namespace {

class ClientsPermission
{
    Q_DECLARE_TR_FUNCTIONS(ClientsPermission)
};

}  // namespace

QString whyNoClient(const ClientStatus* client)
{
    return client == nullptr ? ClientsPermission::tr("select a client first") : QString();
}

QString whyNoGiving(const StationStatus& status, const ClientStatus* client)
{
    if (client == nullptr) {
        return whyNoClient(client);
    }
    if (status.stopLatched) {
        return ClientsPermission::tr("STOP is latched, press \"Reset stop\" first");
    }
    const profile::RotctldSettings& rules = status.profile->rotctld;
    if (rules.lead == profile::Lead::Locked && !client->locked) {
        return ClientsPermission::tr("the mount is locked to %1").arg(QString::fromStdString(rules.lockedTo));
    }
    if (status.authority == Authority::Operator || client->readOnly) {
        return {};
    }
    if (rules.lead == profile::Lead::Last) {
        return ClientsPermission::tr("whoever sends last moves the mount");
    }
    return client->leading ? ClientsPermission::tr("it has the control") : QString();
}

}  // namespace boresight::ui
