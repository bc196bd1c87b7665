// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/station_hooks.h"

#include "core/base/text.h"
#include "core/night/schedule_json.h"

#include <QJsonDocument>

#include <utility>

namespace boresight {
namespace {

using schedule::Moment;

const profile::Command& commandOf(const profile::PassHooks& hooks, Moment moment)
{
    switch (moment) {
        case Moment::BeforeAos:
            return hooks.beforeAos;
        case Moment::Aos:
            return hooks.aos;
        case Moment::Los:
            return hooks.los;
        case Moment::Fault:
            break;
    }
    return hooks.fault;
}

programs::Environment environmentOf(const QJsonObject& facts)
{
    programs::Environment environment;
    for (auto fact = facts.begin(); fact != facts.end(); ++fact) {
        environment.emplace_back(QStringLiteral("BORESIGHT_") + fact.key().toUpper(),
                                 fact.value().toVariant().toString());
    }
    return environment;
}

}  // namespace

StationHooks::StationHooks(const profile::InForce& profile, bool simulated, EventLog& log, StationBroker& broker,
                           QObject* parent)
    : QObject(parent),
      m_profile(profile),
      m_simulated(simulated),
      m_log(log),
      m_broker(broker),
      m_runner(programs::Limits{}, this)
{
    connect(&m_runner, &programs::ProgramRunner::ended, this, [this](const programs::Ending& ending) {
        m_log.add(ending.good ? Severity::Advisory : Severity::Warning, QStringLiteral("schedule"), ending.text);
    });
}

void StationHooks::tell(const schedule::PassMoment& moment)
{
    const QJsonObject facts = momentObject(moment, toQString(m_profile->mount.name), m_simulated);
    m_broker.tell(QJsonDocument(facts).toJson(QJsonDocument::Compact));
    const profile::Command& command = commandOf(m_profile->schedule.hooks, moment.moment);
    if (command.empty()) {
        return;
    }
    QStringList arguments;
    for (const std::string& one : command) {
        arguments << toQString(one);
    }
    const QString path = arguments.takeFirst();
    m_runner.run({.path = path, .arguments = arguments, .environment = environmentOf(facts)});
}

}  // namespace boresight

#include "moc_station_hooks.cpp"
