// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/recording/recording.h"
#include "ui/report/report_page.h"

#include <QByteArray>
#include <QString>

#include <span>

// The report of a pass as a file. Any thread with a QGuiApplication. Takes some tenths of a second for a long pass.
namespace boresight::ui {

inline constexpr int kPictureDotsPerInch = 200;

[[nodiscard]] QByteArray pdfOf(const ReportPage& page);  // one page, A4
[[nodiscard]] QByteArray pngOf(const ReportPage& page);  // the same with kPictureDotsPerInch

// Writes the report of one recording or of two. The path ends with ".pdf" or ".png". The file gets this name only if it
// is whole.
[[nodiscard]] Result<> writeReport(std::span<const recording::Recording> recordings, const QString& path);

}  // namespace boresight::ui
