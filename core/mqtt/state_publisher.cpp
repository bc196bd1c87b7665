// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mqtt/state_publisher.h"

#include "core/mqtt/connection.h"

#include <QDateTime>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <cmath>

namespace boresight::mqtt {
namespace {

// Rounds to a ten thousandth of a degree: finer than any encoder here, and short to write.
double shownDegrees(Angle angle)
{
    constexpr double kSteps = 1e4;
    return std::round(angle.degrees() * kSteps) / kSteps;
}

QJsonValue toValue(const std::optional<Angle>& angle)
{
    return angle ? QJsonValue(shownDegrees(*angle)) : QJsonValue();
}

std::optional<Angle> azimuthOf(const std::optional<SkyPointing>& direction)
{
    return direction ? std::optional(direction->azimuth) : std::nullopt;
}

std::optional<Angle> elevationOf(const std::optional<SkyPointing>& direction)
{
    return direction ? std::optional(direction->elevation) : std::nullopt;
}

QJsonValue toValue(const std::optional<SkyPointing>& direction)
{
    return direction ? QJsonValue(QJsonObject{{QStringLiteral("azimuth"), shownDegrees(direction->azimuth)},
                                              {QStringLiteral("elevation"), shownDegrees(direction->elevation)}})
                     : QJsonValue();
}

QJsonArray toValue(const std::vector<PublishedAlarm>& alarms)
{
    QJsonArray all;
    for (const PublishedAlarm& alarm : alarms) {
        all.append(QJsonObject{{QStringLiteral("id"), alarm.id},
                               {QStringLiteral("about"), alarm.about},
                               {QStringLiteral("severity"), alarm.severity},
                               {QStringLiteral("text"), alarm.text}});
    }
    return all;
}

QJsonValue toValue(const std::optional<PublishedBrake>& brake)
{
    return brake ? QJsonValue(QJsonObject{{QStringLiteral("state"), brake->state},
                                          {QStringLiteral("problem"), brake->problem}})
                 : QJsonValue();
}

QJsonArray toValue(const std::vector<PublishedSwitch>& switches)
{
    QJsonArray all;
    for (const PublishedSwitch& one : switches) {
        all.append(QJsonObject{{QStringLiteral("end"), one.end},
                               {QStringLiteral("state"), one.state},
                               {QStringLiteral("problem"), one.problem}});
    }
    return all;
}

// Two alarms are equal even if their texts differ, because a text may count seconds.
bool areSame(const std::vector<PublishedAlarm>& one, const std::vector<PublishedAlarm>& other)
{
    return std::ranges::equal(one, other, [](const PublishedAlarm& first, const PublishedAlarm& second) {
        return first.id == second.id && first.about == second.about;
    });
}

QString slashed(const QString& prefix)
{
    return prefix.endsWith(QLatin1Char('/')) ? prefix : prefix + QLatin1Char('/');
}

}  // namespace

QByteArray toJson(const PublishedState& state)
{
    const auto time = std::chrono::duration_cast<std::chrono::milliseconds>(state.utc.time_since_epoch()).count();
    const QJsonObject axes{{QStringLiteral("azimuth"), toValue(state.azimuthAxis)},
                           {QStringLiteral("elevation"), toValue(state.elevationAxis)}};
    const QJsonObject units{{QStringLiteral("ts"), QStringLiteral("milliseconds")},
                            {QStringLiteral("orientation"), QStringLiteral("decimal degrees")}};
    const QJsonObject link{{QStringLiteral("up"), state.isLinked}, {QStringLiteral("problem"), state.linkProblem}};
    const QJsonObject all{
        {QStringLiteral("dateTime"), QDateTime::fromMSecsSinceEpoch(time, Qt::UTC).toString(Qt::ISODate)},
        {QStringLiteral("ts"), QString::number(time)},
        {QStringLiteral("state"), state.state},
        {QStringLiteral("fault"), state.fault},
        {QStringLiteral("stopLatched"), state.stopLatched},
        {QStringLiteral("limited"), state.limited},
        {QStringLiteral("simulated"), state.simulated},
        {QStringLiteral("azimuth"), toValue(azimuthOf(state.actual))},
        {QStringLiteral("elevation"), toValue(elevationOf(state.actual))},
        {QStringLiteral("commanded"), toValue(state.commanded)},
        {QStringLiteral("target"), toValue(state.target)},
        {QStringLiteral("targetText"), state.targetText},
        {QStringLiteral("commander"), state.commander},
        {QStringLiteral("axes"), axes},
        {QStringLiteral("link"), link},
        {QStringLiteral("brake"), toValue(state.brake)},
        {QStringLiteral("endSwitches"), toValue(state.endSwitches)},
        {QStringLiteral("alarms"), toValue(state.alarms)},
        {QStringLiteral("units"), units}};
    return QJsonDocument(all).toJson(QJsonDocument::Compact);
}

StatePublisher::StatePublisher(Connection& client, const Clock& clock, const QString& prefix, QObject* parent)
    : QObject(parent), m_client(client), m_clock(clock), m_prefix(slashed(prefix))
{
    connect(&client, &Connection::connected, this, &StatePublisher::sayOnline);
    if (client.isConnected()) {
        sayOnline();
    }
}

Message StatePublisher::will(const QString& prefix)
{
    return {.topic = slashed(prefix) + QStringLiteral("availability"), .payload = "offline", .retain = Retain::Yes};
}

void StatePublisher::sayOnline()
{
    Message message = will(m_prefix);
    message.payload = "online";
    m_client.publish(message);
    m_lastTime.reset();
}

void StatePublisher::tell(const QByteArray& moment)
{
    m_client.publish({.topic = m_prefix + QStringLiteral("schedule"), .payload = moment});
}

void StatePublisher::sayOffline()
{
    m_client.publish(will(m_prefix));
}

bool StatePublisher::isNews(const PublishedState& state) const
{
    return !m_lastTime || m_clock.now() - *m_lastTime >= kPeriod || state.state != m_last.state ||
           state.fault != m_last.fault || state.stopLatched != m_last.stopLatched || state.limited != m_last.limited ||
           state.isLinked != m_last.isLinked || state.brake != m_last.brake ||
           state.endSwitches != m_last.endSwitches || !areSame(state.alarms, m_last.alarms);
}

void StatePublisher::show(const PublishedState& state)
{
    if (!m_client.isConnected() || !isNews(state)) {
        return;
    }
    m_client.publish({.topic = m_prefix + QStringLiteral("state"), .payload = toJson(state)});
    m_lastTime = m_clock.now();
    m_last = state;
}

}  // namespace boresight::mqtt

#include "moc_state_publisher.cpp"
