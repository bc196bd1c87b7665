// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/record_text.h"

#include "core/calibration/record_fields.h"
#include "core/records/toml_reader.h"
#include "core/records/toml_writer.h"

#include <utility>

namespace boresight::calibration {

Result<std::string> toText(const CalibrationHistory& history)
{
    record::HistoryFile file{.inForce = static_cast<std::int64_t>(history.inForce()),
                             .entries = history.entries(),
                             .superseded = history.superseded()};
    records::TomlWriter writer;
    record::historyFields(writer, file);
    std::string text =
        "# Boresight: calibrations of one mount, the oldest first. Angles are in degrees.\n" + writer.written();
    return parseHistory(text, QStringLiteral("history")).map([&](const CalibrationHistory&) { return text; });
}

Result<CalibrationHistory> parseHistory(std::string_view text, const QString& fileName)
{
    record::HistoryFile file;
    return records::TomlReader::read(text, fileName,
                                     [&](records::TomlReader& reader) { record::historyFields(reader, file); })
        .map([&] {
            return CalibrationHistory(std::move(file.entries), static_cast<std::size_t>(file.inForce),
                                      std::move(file.superseded));
        });
}

}  // namespace boresight::calibration
