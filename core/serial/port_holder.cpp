// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/serial/port_holder.h"

#include "core/base/numbers.h"
#include "core/base/process_name.h"

#include <QFileInfo>

#include <unistd.h>

#include <filesystem>
#include <string>
#include <system_error>

namespace boresight {
namespace {

namespace files = std::filesystem;

// Reads only the names of the links. Access to their targets could block on a dead network drive.
bool holds(const files::path& process, const files::path& target)
{
    // Set for a process that has ended or belongs to another user. It counts as not holding the device.
    std::error_code error;
    for (files::directory_iterator entry(process / "fd", error), end; !error && entry != end; entry.increment(error)) {
        std::error_code unreadable;
        if (files::read_symlink(entry->path(), unreadable) == target) {
            return true;
        }
    }
    return false;
}

}  // namespace

std::optional<QString> portHolder(const QString& device)
{
    const files::path target = QFileInfo(device).canonicalFilePath().toStdString();
    std::error_code error;
    for (files::directory_iterator entry("/proc", error), end; !error && entry != end; entry.increment(error)) {
        const auto process = parseInteger(entry->path().filename().string());
        if (process && *process != getpid() && !target.empty() && holds(entry->path(), target)) {
            return nameOfProcess(entry->path().filename().string());
        }
    }
    return std::nullopt;
}

}  // namespace boresight
