// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recording/recording.h"

#include <QByteArray>
#include <QByteArrayView>

#include <span>

// A recording as bytes. A file is the start, then any blocks, and the end. Each block is readable without the others.
// The format: README.md. Pure.
namespace boresight::recording {

inline constexpr QByteArrayView kFileMark =
    "\x89"
    "BPASS\r\n";
inline constexpr char kFormatVersion = 1;

[[nodiscard]] QByteArray fileStart(const Header& header);
[[nodiscard]] QByteArray tickBlock(std::span<const Tick> ticks);  // at least one, of at most some seconds
[[nodiscard]] QByteArray eventBlock(std::span<const Event> events);
[[nodiscard]] QByteArray planBlock(const plan::PlanVariant& plan);
[[nodiscard]] QByteArray gapBlock(const Gap& gap);
[[nodiscard]] QByteArray fileEnd();

}  // namespace boresight::recording
