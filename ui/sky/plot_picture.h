// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <QSize>
#include <QString>

#include <functional>

class QPainter;

// Saves a drawing to a file: .svg as shapes, otherwise a PNG with two pixels for each pixel of the screen.
namespace boresight::ui {

[[nodiscard]] Result<> savePicture(const QString& path, QSize size, const std::function<void(QPainter&)>& paint);

}  // namespace boresight::ui
