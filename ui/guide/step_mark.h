// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/guide/guide_progress.h"
#include "ui/kit/theme.h"

#include <QColor>
#include <QRectF>

class QPainter;

// The shape of a step's state, drawn: a tick, an arrow past it, a warning triangle, an empty ring. It never stands
// without the word.
namespace boresight::ui {

void drawStepMark(QPainter& painter, StepState state, const QRectF& box, const QColor& colour);
[[nodiscard]] Tone toneOf(StepState state);

}  // namespace boresight::ui
