// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <QSize>
#include <QString>

#include <functional>

class QPainter;

// A drawing as a file: .svg as shapes, else a PNG with two pixels for one of the screen.
namespace boresight::ui {

[[nodiscard]] Result<> savePicture(const QString& path, QSize size, const std::function<void(QPainter&)>& paint);

}  // namespace boresight::ui
