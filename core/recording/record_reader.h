// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/recording/recording.h"

#include <QByteArrayView>
#include <QString>

// Reads recordings. Any bytes are safe. Any thread.
namespace boresight::recording {

// More ticks than in any file that Boresight writes. The rest of a longer file is left out, with a problem.
inline constexpr std::size_t kMostTicks = 400'000;

// The whole recording. Damaged blocks are left out: `problems` names them. An error names what is in the way: this is
// no recording, its version is unknown, or its header is damaged.
[[nodiscard]] Result<Recording> readRecording(QByteArrayView bytes);

// The header alone. `bytes` may be the beginning of a file.
[[nodiscard]] Result<Header> readHeader(QByteArrayView bytes);

// The same from a file. The error names the file, too.
[[nodiscard]] Result<Recording> loadRecording(const QString& path);
[[nodiscard]] Result<Header> loadHeader(const QString& path);

}  // namespace boresight::recording
