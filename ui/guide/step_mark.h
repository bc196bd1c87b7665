// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/guide/guide_progress.h"
#include "ui/kit/theme.h"

#include <QColor>
#include <QRectF>

class QPainter;

// Draws the state of a step as a shape: a tick, an arrow past it, a warning triangle, or an empty ring. The word of the
// state is always shown, too.
namespace boresight::ui {

void drawStepMark(QPainter& painter, StepState state, const QRectF& box, const QColor& colour);
[[nodiscard]] Tone toneOf(StepState state);

}  // namespace boresight::ui
