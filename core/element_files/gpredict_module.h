// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

// The satellites of a Gpredict module: NAME.mod in its folder modules lists their numbers, and their elements are in
// the folder satdata beside it. Blocking.
namespace boresight::orbit {

struct GpredictModule
{
    QStringList files;     // of elements
    QStringList problems;  // "FILE: reason"
};

[[nodiscard]] GpredictModule readGpredictModule(const QString& path);

}  // namespace boresight::orbit
