// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/save_whole.h"

#include <QSaveFile>

#include <unistd.h>

#include <cerrno>

namespace boresight {

std::optional<QString> saveWhole(QSaveFile& file)
{
    const auto canceled = [&file](const QString& reason) {
        file.cancelWriting();
        return reason;
    };
    if (!file.flush()) {
        return canceled(file.errorString());
    }
    // Some file systems report a full disk only here. EINVAL means that the file system cannot sync, which is not an
    // error.
    if (::fsync(file.handle()) != 0 && errno != EINVAL) {
        return canceled(qt_error_string());
    }
    if (!file.commit()) {
        return file.errorString();
    }
    return std::nullopt;
}

}  // namespace boresight
