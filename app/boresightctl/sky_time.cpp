// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/boresightctl/sky_time.h"

#include "core/elements/element_check.h"
#include "core/elements/written_time.h"

#include <QDateTime>

#include <chrono>

namespace boresight::ctl {
namespace {

constexpr int kMicrosecondDigits = 6;

}  // namespace

Result<UtcTime> parseSkyTime(std::string_view text)
{
    const auto date = orbit::parseWrittenTime(text);
    if (!date) {
        return failure(ErrorCode::InvalidInput,
                       QStringLiteral("\"%1\" is not a time: expected UTC like 2024-05-10T04:50:02Z, or Unix seconds")
                           .arg(orbit::quoted(text)));
    }
    return orbit::utcTime(*date);
}

std::string skyTimeText(UtcTime utc, int digits)
{
    const auto rounded = std::chrono::round<std::chrono::microseconds>(utc.time_since_epoch());
    const auto second = std::chrono::floor<std::chrono::seconds>(rounded);
    const std::string whole = QDateTime::fromSecsSinceEpoch(second.count(), Qt::UTC)
                                  .toString(QStringLiteral("yyyy-MM-ddTHH:mm:ss"))
                                  .toStdString();
    std::string fraction = std::to_string((rounded - second).count());
    fraction.insert(0, static_cast<std::size_t>(kMicrosecondDigits) - fraction.size(), '0');
    const std::size_t needed = fraction.find_last_not_of('0') + 1;  // 0 for a whole second
    fraction.resize(std::max(needed, static_cast<std::size_t>(digits)));
    return whole + (fraction.empty() ? "" : ".") + fraction + "Z";
}

std::string skyTimeCell(UtcTime utc)
{
    return skyTimeText(std::chrono::round<std::chrono::milliseconds>(utc), 3);
}

}  // namespace boresight::ctl
