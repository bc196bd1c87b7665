// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

#include <cstdint>

// The broker to use, and the login for it. Plain values.
namespace boresight::mqtt {

enum class Encryption
{
    None,
    Tls
};

struct Broker
{
    QString host;
    std::uint16_t port = 1883;
    QString user;  // empty: no login
    QString password;
    Encryption encryption = Encryption::None;
    QString caFile;    // PEM file; empty: the authorities that this computer trusts
    QString clientId;  // empty: the broker chooses one

    bool operator==(const Broker&) const = default;
};

enum class Retain
{
    No,
    Yes  // the broker keeps the message for later subscribers
};

// In bytes. No sender on the topics that we read needs a larger message.
inline constexpr qint64 kLargestMessage = 64 * 1024;

struct Message
{
    QString topic;
    QByteArray payload;
    Retain retain = Retain::No;

    bool operator==(const Message&) const = default;
};

}  // namespace boresight::mqtt
