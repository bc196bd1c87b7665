// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recordings/recording_options.h"

#include "app/boresightctl/option_reader.h"
#include "core/base/numbers.h"
#include "core/base/text.h"

#include <algorithm>
#include <array>
#include <functional>

namespace boresight::ctl {
namespace {

constexpr double kMostSpeed = 60.0;
constexpr std::array<std::string_view, 4> kParts{"ticks", "events", "plan", "info"};  // in the order of RecordedPart

// Takes the value of an option. The error says what is expected.
using TakeOption = std::function<Result<>(const std::string& name, const std::string& value)>;

tl::unexpected<Error> unexpectedValue(const std::string& name, const std::string& value, const QString& what)
{
    return failure(
        ErrorCode::InvalidInput,
        QStringLiteral("--%1 \"%2\": expected %3").arg(toQString(name), toQString(value.substr(0, 60)), what));
}

tl::unexpected<Error> unknownOption(const std::string& name)
{
    return failure(ErrorCode::InvalidInput, QStringLiteral("there is no option --%1").arg(toQString(name)));
}

// The file comes first, then the options. Returns the file.
Result<QString> takeFile(Arguments arguments, const TakeOption& take)
{
    if (arguments.empty() || arguments.front().starts_with("--")) {
        return failure(ErrorCode::InvalidInput, QStringLiteral("name the file of a recording first"));
    }
    OptionReader options(arguments.subspan(1));
    while (!options.atEnd()) {
        const Result<std::string> name = options.takeName();
        if (!name) {
            return tl::unexpected(name.error());
        }
        if (const Result<> taken = take(*name, options.takeValue().value_or(std::string())); !taken) {
            return tl::unexpected(taken.error());
        }
    }
    return toQString(arguments.front());
}

}  // namespace

Result<ExportOptions> parseExportOptions(Arguments arguments)
{
    ExportOptions options;
    const auto take = [&options](const std::string& name, const std::string& value) -> Result<> {
        if (name == "format") {
            const auto format = parseTableFormat(value);
            options.format = format.value_or(options.format);
            return format ? Result<>{} : unexpectedValue(name, value, QStringLiteral("csv, table or json"));
        }
        if (name == "what") {
            const auto* const found = std::ranges::find(kParts, value);
            if (found == kParts.end()) {
                return unexpectedValue(name, value, QStringLiteral("ticks, events, plan or info"));
            }
            options.part = static_cast<RecordedPart>(found - kParts.begin());
            return {};
        }
        return unknownOption(name);
    };
    return takeFile(arguments, take).map([&options](const QString& file) {
        options.file = file;
        return options;
    });
}

Result<ReplayOptions> parseReplayOptions(Arguments arguments)
{
    ReplayOptions options;
    const auto take = [&options](const std::string& name, const std::string& value) -> Result<> {
        if (name != "speed") {
            return unknownOption(name);
        }
        const auto speed = parseFinite(value);
        if (!speed || *speed < 1.0 || *speed > kMostSpeed) {
            return unexpectedValue(name, value, QStringLiteral("a number from 1 to 60"));
        }
        options.speed = *speed;
        return {};
    };
    return takeFile(arguments, take).map([&options](const QString& file) {
        options.file = file;
        return options;
    });
}

}  // namespace boresight::ctl
