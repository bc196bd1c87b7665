// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mqtt/broker.h"

#include <QString>

#include <vector>

// The messages from which Home Assistant learns how to show the mount, without any configuration by a person. This is
// its MQTT discovery (home-assistant.io/integrations/mqtt), with one message for each entity. Pure.
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
    QString prefix;           // prefix of the topics of the mount: "boresight/"
    QString name;             // of the mount
    QString version;          // of Boresight
    Offered buttons = Offered::Nothing;
};

// One retained message for each entity. For an entity that is not offered the message is empty, which makes Home
// Assistant remove the entity.
[[nodiscard]] std::vector<Message> discovery(const Described& mount);

// The messages that remove the entities that were described before and are not described any more.
[[nodiscard]] std::vector<Message> withdrawal(const std::vector<Message>& before, const std::vector<Message>& after);

}  // namespace boresight::mqtt
