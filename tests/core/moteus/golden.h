// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/can_frame.h"
#include "core/moteus/registers.h"

#include <QJsonArray>
#include <QJsonObject>
#include <QString>

#include <cstdint>
#include <string>
#include <vector>

// The recorded exchanges of tests/data/moteus_golden.json, or of the file named by MOTEUS_GOLDEN. It has the same
// schema, and its "about" key explains it.
namespace boresight::moteus::golden {

// One list of the file ("commands", "replies", …). If it is unreadable or empty, the running test fails.
[[nodiscard]] QJsonArray vectors(const char* list);

[[nodiscard]] std::string text(const QJsonObject& object, const char* key);
[[nodiscard]] std::vector<std::uint8_t> bytes(const QString& hex);
[[nodiscard]] std::vector<std::uint8_t> bytes(const QJsonObject& object, const char* key);
[[nodiscard]] std::uint32_t hexNumber(const QJsonValue& value);  // "0x8001"
[[nodiscard]] double number(const QJsonValue& value);            // 1.5, "nan", "inf", "-inf"
[[nodiscard]] Resolution resolution(const QString& text);        // "i8"
[[nodiscard]] Register registerNumber(const QString& text);      // "q_current" or "0x120"
[[nodiscard]] std::string toHex(std::span<const std::uint8_t> bytes);

// The payload in a frame, not padded.
[[nodiscard]] CanFrame frame(std::uint32_t id, const std::vector<std::uint8_t>& payload);

// Every payload in the file, both requests and replies.
[[nodiscard]] std::vector<CanFrame> allFrames();

}  // namespace boresight::moteus::golden
