// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/report_output.h"

#include "core/base/save_whole.h"
#include "core/base/text.h"
#include "core/base/version.h"

#include <QBuffer>
#include <QImage>
#include <QPageLayout>
#include <QPageSize>
#include <QPdfWriter>
#include <QSaveFile>

#include <cmath>

namespace boresight::ui {

namespace {

constexpr int kPaperDotsPerInch = 254;  // dots of 0.1 mm
constexpr qreal kPictureScale = qreal{kPictureDotsPerInch} / kPaperDotsPerInch;

}  // namespace

QByteArray pdfOf(const ReportPage& page)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setTitle(pass_report::targetText(page.passes.front().header));
    writer.setCreator(QStringLiteral("Boresight %1").arg(toQString(kVersion)));
    writer.setResolution(kPaperDotsPerInch);
    writer.setPageLayout(QPageLayout(QPageSize(QPageSize::A4), QPageLayout::Portrait, QMarginsF()));
    QPainter painter(&writer);
    drawReportPage(painter, page);
    painter.end();
    return bytes;
}

QByteArray pngOf(const ReportPage& page)
{
    QImage picture((kPaperSize * kPictureScale).toSize(), QImage::Format_RGB32);
    picture.setDotsPerMeterX(static_cast<int>(std::lround(kPictureDotsPerInch / 0.0254)));
    picture.setDotsPerMeterY(picture.dotsPerMeterX());
    picture.fill(Qt::white);
    QPainter painter(&picture);
    painter.scale(kPictureScale, kPictureScale);
    drawReportPage(painter, page);
    painter.end();
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    picture.save(&buffer, "PNG");
    return bytes;
}

Result<> writeReport(std::span<const recording::Recording> recordings, const QString& path)
{
    const bool isPdf = path.endsWith(QStringLiteral(".pdf"), Qt::CaseInsensitive);
    if (!isPdf && !path.endsWith(QStringLiteral(".png"), Qt::CaseInsensitive)) {
        return failure(ErrorCode::InvalidInput, Text::tr("%1: the name of a report ends with .pdf or .png").arg(path));
    }
    return reportPageOf(recordings).and_then([&](const ReportPage& page) -> Result<> {
        QSaveFile file(path);
        if (!file.open(QIODevice::WriteOnly)) {
            return failure(ErrorCode::Io, Text::tr("%1 cannot be written: %2").arg(path, file.errorString()));
        }
        file.write(isPdf ? pdfOf(page) : pngOf(page));
        if (const std::optional<QString> reason = saveWhole(file)) {
            return failure(ErrorCode::Io, Text::tr("%1 cannot be written: %2").arg(path, *reason));
        }
        return {};
    });
}

}  // namespace boresight::ui
