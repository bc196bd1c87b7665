// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sky/plot_picture.h"

#include "core/base/save_whole.h"

#include <QCoreApplication>
#include <QFile>
#include <QImage>
#include <QPainter>
#include <QSaveFile>
#include <QSvgGenerator>

namespace boresight::ui {

namespace {

constexpr int kScale = 2;

void drawSvg(QIODevice& file, QSize size, const std::function<void(QPainter&)>& paint)
{
    QSvgGenerator svg;
    svg.setOutputDevice(&file);
    svg.setResolution(96);  // the resolution of a pixel in SVG
    svg.setSize(size);
    svg.setViewBox(QRect(QPoint(), size));
    svg.setTitle(QCoreApplication::translate("PlotPicture", "Sky plot"));
    QPainter painter(&svg);
    paint(painter);
}

bool drawPng(QIODevice& file, QSize size, const std::function<void(QPainter&)>& paint)
{
    QImage image(size * kScale, QImage::Format_RGB32);
    image.setDevicePixelRatio(kScale);
    image.fill(Qt::white);
    QPainter painter(&image);
    paint(painter);
    painter.end();
    return image.save(&file, "PNG");
}

}  // namespace

Result<> savePicture(const QString& path, QSize size, const std::function<void(QPainter&)>& paint)
{
    QSaveFile file(path);
    bool drawn = file.open(QIODevice::WriteOnly);
    if (drawn && path.endsWith(QLatin1String(".svg"), Qt::CaseInsensitive)) {
        drawSvg(file, size, paint);
    } else if (drawn) {
        drawn = drawPng(file, size, paint);
    }
    if (!drawn) {
        return failure(ErrorCode::Io, file.errorString());
    }
    if (const auto why = saveWhole(file)) {
        return failure(ErrorCode::Io, *why);
    }
    return {};
}

}  // namespace boresight::ui
