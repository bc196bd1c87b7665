// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/outputs/output_maker.h"

#include "core/mqtt/profile_broker.h"
#include "core/outputs/broker_output.h"
#include "core/outputs/command_output.h"
#include "core/outputs/modem_line.h"
#include "core/outputs/serial_modem_port.h"
#include "core/outputs/state_file.h"
#include "core/outputs/threaded_output.h"

#include <QUuid>

namespace boresight::outputs {
namespace {

using contacts::OutputKind;

mqtt::Broker ownBroker(profile::BrokerSettings settings, const QString& use)
{
    if (!settings.clientId.empty()) {
        settings.clientId += "-" + use.toStdString();
    }
    return mqtt::brokerOf(settings, QStringLiteral("boresight-") + QUuid::createUuid().toString(QUuid::Id128).left(8));
}

std::unique_ptr<Output> lineOutput(const QString& port, Line line)
{
    const auto modem = std::make_shared<ModemLine>(std::make_unique<SerialModemPort>(port), line);
    return std::make_unique<ThreadedOutput>([modem](bool on) { return modem->set(on); });
}

}  // namespace

std::unique_ptr<Output> makeOutput(const contacts::OutputName& name, const QString& use,
                                   const profile::BrokerSettings& broker, const Clock& clock)
{
    switch (name.kind) {
        case OutputKind::File:
            return std::make_unique<ThreadedOutput>([path = name.place](bool on) { return writeState(path, on); });
        case OutputKind::Mqtt:
            return std::make_unique<BrokerOutput>(ownBroker(broker, use), name.place, clock);
        case OutputKind::Command:
            return std::make_unique<CommandOutput>(name.place, name.arguments);
        case OutputKind::Dtr:
            return lineOutput(name.place, Line::Dtr);
        case OutputKind::Rts:
            return lineOutput(name.place, Line::Rts);
        case OutputKind::Pin:  // the mount makes it
        case OutputKind::None:
            break;
    }
    return nullptr;
}

}  // namespace boresight::outputs
