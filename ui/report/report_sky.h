// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pass_report/pass_trace.h"

#include <QPainter>
#include <QRectF>

#include <span>

// The sky of a report: north up, east right, the zenith in the centre. The path of the target, the path of the beam,
// and the plan. Any thread with a QGuiApplication.
namespace boresight::ui {

void drawReportSky(QPainter& painter, const QRectF& room, std::span<const pass_report::PassTrace> passes);

}  // namespace boresight::ui
