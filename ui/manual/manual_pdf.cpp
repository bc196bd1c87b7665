// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/manual/manual_pdf.h"

#include "ui/manual/manual_window.h"

#include <QFile>
#include <QImage>
#include <QPdfWriter>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextDocument>

namespace boresight::ui {

namespace {

constexpr int kDotsPerInch = 96;  // pictures have their size on the screen
constexpr qreal kMargin = 18.0;   // mm

void narrowPictures(QTextDocument& book, qreal width)
{
    for (QTextBlock block = book.begin(); block.isValid(); block = block.next()) {
        for (auto piece = block.begin(); !piece.atEnd(); ++piece) {
            const QTextFragment part = piece.fragment();
            QTextImageFormat picture = part.charFormat().toImageFormat();
            if (!picture.isValid()) {
                continue;
            }
            picture.setWidth(width);
            QTextCursor cursor(&book);
            cursor.setPosition(part.position());
            cursor.setPosition(part.position() + part.length(), QTextCursor::KeepAnchor);
            cursor.setCharFormat(picture);
            break;  // the fragments of this block have changed
        }
    }
}

Result<QString> readBook()
{
    const QString path = QStringLiteral(":") + manualAddress().path();
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return failure(ErrorCode::Io, QStringLiteral("The manual is not in this program: %1").arg(file.errorString()));
    }
    return QString::fromUtf8(file.readAll());
}

}  // namespace

Result<> writeManualPdf(const QString& path)
{
    const Result<QString> text = readBook();
    if (!text) {
        return tl::unexpected(text.error());
    }
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly)) {
        return failure(ErrorCode::Io, QStringLiteral("%1 cannot be written: %2").arg(path, file.errorString()));
    }
    QPdfWriter writer(&file);
    writer.setTitle(QStringLiteral("Boresight manual"));
    writer.setResolution(kDotsPerInch);
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setPageMargins({kMargin, kMargin, kMargin, kMargin}, QPageLayout::Millimeter);
    const QSizeF page = writer.pageLayout().paintRectPixels(kDotsPerInch).size();
    QTextDocument book;
    book.setBaseUrl(manualAddress());
    book.setDefaultFont(QFont(QStringLiteral("sans-serif"), 10));
    book.setMarkdown(*text);
    narrowPictures(book, page.width());
    book.setPageSize(page);
    book.print(&writer);
    return {};
}

}  // namespace boresight::ui
