// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

#include <optional>

// Key files of GLib in the form that Gpredict writes: [GROUP] followed by KEY=VALUE. Pure.
namespace boresight::profile {

// The value of the key. If the key occurs several times, the last one counts, as in GLib.
[[nodiscard]] std::optional<QString> keyFileValue(const QByteArray& text, const QString& group, const QString& key);

}  // namespace boresight::profile
