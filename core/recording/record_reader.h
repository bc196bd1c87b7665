// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/recording/recording.h"

#include <QByteArrayView>
#include <QString>

// Reads recordings. Any bytes are safe. Any thread.
namespace boresight::recording {

// More than in any file that Boresight writes. What a file has beyond this is left out, with a problem.
inline constexpr std::size_t kMostTicks = 400'000;
inline constexpr std::size_t kMostEvents = 200'000;
inline constexpr std::size_t kMostGaps = 10'000;
inline constexpr int kMostPlans = 20;

// Of one file. A last one, that the recording has no end, may follow.
inline constexpr qsizetype kMostProblems = 100;

// The whole recording. Damaged blocks are left out: `problems` names them. An error names what is in the way: this is
// no recording, its version is unknown, or its header is damaged.
[[nodiscard]] Result<Recording> readRecording(QByteArrayView bytes);

// The header alone. `bytes` may be the beginning of a file.
[[nodiscard]] Result<Header> readHeader(QByteArrayView bytes);

// The same from a file. The error names the file, too.
[[nodiscard]] Result<Recording> loadRecording(const QString& path);
[[nodiscard]] Result<Header> loadHeader(const QString& path);

}  // namespace boresight::recording
