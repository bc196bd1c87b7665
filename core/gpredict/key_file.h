// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

#include <optional>

// GLib's key files, as Gpredict writes them: [GROUP] and below it KEY=VALUE. Pure.
namespace boresight::profile {

// The last one counts, as there.
[[nodiscard]] std::optional<QString> keyFileValue(const QByteArray& text, const QString& group, const QString& key);

}  // namespace boresight::profile
