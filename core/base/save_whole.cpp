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
    // Some file systems find out only now that there is no room. One that cannot sync has nothing to tell.
    if (::fsync(file.handle()) != 0 && errno != EINVAL) {
        return canceled(qt_error_string());
    }
    if (!file.commit()) {
        return file.errorString();
    }
    return std::nullopt;
}

}  // namespace boresight
