// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/profile/setting_makers.h"

#include "core/base/numbers.h"

#include <cmath>
#include <utility>

namespace boresight::profile::makers {

namespace {

std::string plain(double value)
{
    std::string text = formatFixed(value, 6);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.ends_with('.')) {
        text.pop_back();
    }
    return text;
}

}  // namespace

Result<> checkRange(double value, Range range)
{
    if (!std::isfinite(value)) {
        return failure(ErrorCode::InvalidInput, "a finite number is expected");
    }
    if (value < range.min || value > range.max) {
        return failure(ErrorCode::OutOfRange,
                       plain(value) + " is outside " + plain(range.min) + "…" + plain(range.max));
    }
    return {};
}

double rounded(double value)
{
    constexpr double kSteps = 1e9;  // 10 to the power of kDecimals
    return std::round(value * kSteps) / kSteps;
}

std::string listed(const std::vector<std::string>& names)
{
    std::string text;
    for (const std::string& name : names) {
        text += (text.empty() ? "\"" : ", \"") + name + "\"";
    }
    return text;
}

Setting textual(std::string key, Applies applies, std::string text, std::function<std::string(const Profile&)> read,
                std::function<Result<>(Profile&, const std::string&)> write)
{
    auto set = [write = std::move(write)](Profile& profile, const SettingValue& value) -> Result<> {
        const auto* wanted = std::get_if<std::string>(&value);
        return wanted != nullptr ? write(profile, *wanted)
                                 : failure(ErrorCode::InvalidInput, "a text in quotes is expected");
    };
    return {.key = std::move(key),
            .type = SettingType::Text,
            .unit = {},
            .choices = {},
            .text = std::move(text),
            .applies = applies,
            .get = std::move(read),
            .set = std::move(set)};
}

}  // namespace boresight::profile::makers
