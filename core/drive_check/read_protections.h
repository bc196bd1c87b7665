// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drive_check/protections.h"

#include <QList>

#include <optional>
#include <string_view>
#include <vector>

// The safety settings of one drive: the wanted values, the values that were read, and the verdicts. Pure.
namespace boresight::drive_check {

class ReadProtections
{
public:
    explicit ReadProtections(std::vector<Protection> wanted);

    // A reading stays with its key. A new key is unread.
    void want(std::vector<Protection> wanted);
    // One reading for each key, in the same order.
    void take(std::vector<Reading> readings);
    void forget();

    [[nodiscard]] const std::vector<Protection>& wanted() const { return m_wanted; }
    [[nodiscard]] const std::vector<Reading>& readings() const { return m_readings; }
    [[nodiscard]] const QList<ProtectionLine>& lines() const { return m_lines; }
    [[nodiscard]] bool isAllRead() const;
    [[nodiscard]] bool isAnyFixable() const;
    [[nodiscard]] std::optional<double> value(std::string_view key) const;

private:
    void judge();

    std::vector<Protection> m_wanted;
    std::vector<Reading> m_readings;
    QList<ProtectionLine> m_lines;
};

}  // namespace boresight::drive_check
