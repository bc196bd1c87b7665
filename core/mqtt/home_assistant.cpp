// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mqtt/home_assistant.h"

#include <QCryptographicHash>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>

#include <algorithm>
#include <utility>

namespace boresight::mqtt {
namespace {

// s. The state is published each second. After this time without a state Home Assistant shows no value.
constexpr int kExpiry = 10;

// The names are always English, because Home Assistant makes the ids of its entities from them.
struct Entity
{
    QString component;
    QString key;
    QString name;
    QJsonObject more;
    bool isOffered = true;
};

QString ascii(const char* text)
{
    return QLatin1String(text);
}

QString unslashed(const QString& prefix)
{
    return prefix.endsWith(QLatin1Char('/')) ? prefix.chopped(1) : prefix;
}

QString topicOf(const Described& mount, const char* name)
{
    return unslashed(mount.prefix) + ascii("/") + ascii(name);
}

// An id for the mount, from the characters that a discovery topic may have. A prefix that needs a change gets a hash:
// otherwise "a/b" and "a_b" would be one mount, and so would "roof" and "boresight_roof".
QString idOf(const Described& mount)
{
    static const QRegularExpression kOthers(QStringLiteral("[^a-zA-Z0-9_-]"));
    constexpr qsizetype kDigits = 8;
    const QString prefix = unslashed(mount.prefix);
    const QString plain = QString(prefix).replace(kOthers, ascii("_"));
    const QString id = plain.startsWith(ascii("boresight")) ? plain : ascii("boresight_") + plain;
    const QByteArray hash = QCryptographicHash::hash(prefix.toUtf8(), QCryptographicHash::Sha256).toHex();
    return id == prefix ? id : id + ascii("_") + QString::fromLatin1(hash.left(kDigits));
}

// An entity that shows a value of the state.
Entity shown(const char* component, const char* key, const char* name, const char* value, QJsonObject more)
{
    more[ascii("value_template")] = ascii(value);
    more[ascii("expire_after")] = kExpiry;
    return {.component = ascii(component), .key = ascii(key), .name = ascii(name), .more = std::move(more)};
}

Entity angle(const char* key, const char* name, const char* value)
{
    return shown("sensor", key, name, value,
                 {{ascii("unit_of_measurement"), QStringLiteral("°")},
                  {ascii("state_class"), ascii("measurement")},
                  {ascii("suggested_display_precision"), 1}});
}

Entity stateWord()
{
    QJsonArray words;
    for (const char* const word :
         {"DISCONNECTED", "STANDBY", "HOLD", "SLEW", "TRACK", "JOG", "PARKED", "CALIBRATE", "STOPPED", "FAULT"}) {
        words.append(ascii(word));
    }
    return shown("sensor", "state", "State", "{{ value_json.state }}",
                 {{ascii("device_class"), ascii("enum")}, {ascii("options"), words}});
}

Entity alarmCount(const Described& mount)
{
    return shown("sensor", "alarms", "Alarms", "{{ value_json.alarms | count }}",
                 {{ascii("icon"), ascii("mdi:alert")},
                  {ascii("json_attributes_topic"), topicOf(mount, "state")},
                  {ascii("json_attributes_template"), ascii("{{ {'alarms': value_json.alarms} | tojson }}")}});
}

// This value does not expire, because it is published only once.
Entity answerText(const Described& mount)
{
    return {.component = ascii("sensor"),
            .key = ascii("answer"),
            .name = ascii("Last answer"),
            .more = {{ascii("state_topic"), topicOf(mount, "answer")},
                     {ascii("value_template"), ascii("{{ value_json.answer[:250] }}")},
                     {ascii("entity_category"), ascii("diagnostic")}},
            .isOffered = mount.buttons != Offered::Nothing};
}

Entity button(const Described& mount, const char* key, const char* name, const char* topic, const char* icon)
{
    return {.component = ascii("button"),
            .key = ascii(key),
            .name = ascii(name),
            .more = {{ascii("command_topic"), topicOf(mount, topic)},
                     {ascii("payload_press"), ascii(key)},
                     {ascii("icon"), ascii(icon)}}};
}

std::vector<Entity> valuesOf(const Described& mount)
{
    return {
        angle("azimuth", "Azimuth", "{{ value_json.azimuth }}"),
        angle("elevation", "Elevation", "{{ value_json.elevation }}"),
        stateWord(),
        shown("sensor", "target", "Target", "{{ (value_json.targetText or 'none')[:250] }}",
              {{ascii("icon"), ascii("mdi:target")}}),
        alarmCount(mount),
        shown("binary_sensor", "moving", "Moving",
              "{{ 'ON' if value_json.state in ['SLEW', 'TRACK', 'JOG', 'CALIBRATE'] else 'OFF' }}",
              {{ascii("device_class"), ascii("moving")}}),
        shown("binary_sensor", "fault", "Fault", "{{ 'ON' if value_json.state == 'FAULT' else 'OFF' }}",
              {{ascii("device_class"), ascii("problem")}}),
        shown("binary_sensor", "stop_latched", "STOP latched", "{{ 'ON' if value_json.stopLatched else 'OFF' }}",
              {{ascii("icon"), ascii("mdi:alert-octagon")}}),
        shown("binary_sensor", "link", "Link", "{{ 'ON' if value_json.link.up else 'OFF' }}",
              {{ascii("device_class"), ascii("connectivity")}}),
    };
}

std::vector<Entity> entitiesOf(const Described& mount)
{
    std::vector<Entity> all = valuesOf(mount);
    all.push_back(answerText(mount));
    all.push_back(button(mount, "stop", "STOP", "stop", "mdi:alert-octagon"));
    all.back().isOffered = mount.buttons != Offered::Nothing;
    all.push_back(button(mount, "park", "Park", "command", "mdi:parking"));
    all.back().isOffered = mount.buttons == Offered::StopAndPark;
    return all;
}

QByteArray payloadOf(const Entity& entity, const Described& mount)
{
    QJsonObject all = entity.more;
    const QString id = idOf(mount);
    all[ascii("name")] = entity.name;
    all[ascii("unique_id")] = id + ascii("_") + entity.key;
    all[ascii("availability_topic")] = topicOf(mount, "availability");
    if (all.contains(ascii("expire_after"))) {
        all[ascii("state_topic")] = topicOf(mount, "state");
    }
    all[ascii("device")] = QJsonObject{{ascii("identifiers"), QJsonArray{id}},
                                       {ascii("name"), mount.name},
                                       {ascii("model"), ascii("Antenna mount")},
                                       {ascii("manufacturer"), ascii("Boresight")},
                                       {ascii("sw_version"), mount.version}};
    all[ascii("origin")] = QJsonObject{{ascii("name"), ascii("Boresight")}, {ascii("sw_version"), mount.version}};
    return QJsonDocument(all).toJson(QJsonDocument::Compact);
}

}  // namespace

std::vector<Message> discovery(const Described& mount)
{
    std::vector<Message> all;
    for (const Entity& entity : entitiesOf(mount)) {
        all.push_back({.topic = QStringLiteral("%1/%2/%3_%4/config")
                                    .arg(unslashed(mount.discoveryPrefix), entity.component, idOf(mount), entity.key),
                       .payload = entity.isOffered ? payloadOf(entity, mount) : QByteArray(),
                       .retain = Retain::Yes});
    }
    return all;
}

std::vector<Message> withdrawal(const std::vector<Message>& before, const std::vector<Message>& after)
{
    std::vector<Message> all;
    for (const Message& old : before) {
        if (!old.payload.isEmpty() && std::ranges::find(after, old.topic, &Message::topic) == after.end()) {
            all.push_back({.topic = old.topic, .payload = {}, .retain = Retain::Yes});
        }
    }
    return all;
}

}  // namespace boresight::mqtt
