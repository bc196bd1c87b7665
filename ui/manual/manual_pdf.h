// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <QString>

// The user manual as PDF, A4, with its pictures no wider than the page. Any thread with a QGuiApplication.
namespace boresight::ui {

Result<> writeManualPdf(const QString& path);

}  // namespace boresight::ui
