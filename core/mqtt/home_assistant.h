// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mqtt/broker.h"

#include <QString>

#include <vector>

// What Home Assistant has to know to show the mount without a line of configuration: its MQTT discovery
// (home-assistant.io/integrations/mqtt, one message for each entity). Pure.
namespace boresight::mqtt {

enum class Offered
{
    Nothing,  // no buttons
    Stop,
    StopAndPark
};

struct Described
{
    QString discoveryPrefix;  // "homeassistant"
    QString prefix;           // "boresight/": of the topics of the mount
    QString name;             // of the mount
    QString version;          // of Boresight
    Offered buttons = Offered::Nothing;
};

// One retained message for each entity. The message of an entity that is not offered is empty: Home Assistant then
// removes the entity.
[[nodiscard]] std::vector<Message> discovery(const Described& mount);

// The messages that remove what was described before and is not described any more.
[[nodiscard]] std::vector<Message> withdrawal(const std::vector<Message>& before, const std::vector<Message>& after);

}  // namespace boresight::mqtt
