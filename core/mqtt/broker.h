// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

#include <cstdint>

// Which broker, and as whom. Plain values.
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
    QString user;  // empty: without
    QString password;
    Encryption encryption = Encryption::None;
    QString caFile;    // PEM; empty: the authorities that this computer knows
    QString clientId;  // empty: the broker makes one up

    bool operator==(const Broker&) const = default;
};

enum class Retain
{
    No,
    Yes  // the broker keeps it for those who come later
};

// Bytes. No writer to the topics that we read has a reason for a larger message.
inline constexpr qint64 kLargestMessage = 64 * 1024;

struct Message
{
    QString topic;
    QByteArray payload;
    Retain retain = Retain::No;

    bool operator==(const Message&) const = default;
};

}  // namespace boresight::mqtt
