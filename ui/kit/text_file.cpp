// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/text_file.h"

#include "core/base/save_whole.h"

#include <QSaveFile>

namespace boresight::ui {

Result<> saveText(const QString& path, const QString& text)
{
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(text.toUtf8()) < 0) {
        return failure(ErrorCode::Io, file.errorString());
    }
    if (const auto why = saveWhole(file)) {
        return failure(ErrorCode::Io, *why);
    }
    return {};
}

}  // namespace boresight::ui
