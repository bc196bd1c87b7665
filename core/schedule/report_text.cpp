// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/schedule/report_text.h"

#include "core/records/toml_reader.h"
#include "core/records/toml_writer.h"

namespace boresight::schedule {
namespace {

using records::Range;

constexpr std::int64_t kVersion = 1;
constexpr Range kOfCount{0.0, 1e9};
constexpr Range kOfNumber{0.0, 999'999'999.0};  // the catalogue has nine digits
constexpr Range kOfTime{0.0, 1e9};              // s
constexpr Range kOfError{0.0, 180.0};           // deg
constexpr Range kOfEnd{0.0, static_cast<double>(PassEnd::Interrupted)};
constexpr Range kOfAnyEnd{0.0, static_cast<double>(PassEnd::Running)};

struct StoredReport
{
    std::int64_t version = kVersion;
    NightReport report;
};

struct StoredPass
{
    std::int64_t version = kVersion;
    NewestPass newest;
};

template <class Visitor>
void passFields(Visitor& visitor, PassRecord& pass, Range ofEnd)
{
    visitor.whole("norad", pass.number, kOfNumber);
    visitor.text("name", pass.name);
    visitor.time("aos", pass.aos);
    visitor.time("los", pass.los);
    inSeconds(visitor, "tracked_s", pass.tracked, kOfTime);
    inSeconds(visitor, "within_1db_s", pass.within1dB, kOfTime);
    inSeconds(visitor, "within_3db_s", pass.within3dB, kOfTime);
    optionalInDegrees(visitor, "rms_deg", pass.rmsError, kOfError);
    optionalInDegrees(visitor, "peak_deg", pass.peakError, kOfError);
    asWhole(visitor, "end", pass.end, ofEnd);
    visitor.text("why", pass.why);
}

template <class Visitor>
void reportFields(Visitor& visitor, StoredReport& file)
{
    visitor.whole("version", file.version, {kVersion, kVersion});
    asWhole(visitor, "interventions", file.report.interventions, kOfCount);
    asWhole(visitor, "faults", file.report.faults, kOfCount);
    visitor.list("pass", file.report.passes, [](Visitor& inner, PassRecord& pass) { passFields(inner, pass, kOfEnd); });
}

template <class Visitor>
void newestFields(Visitor& visitor, StoredPass& file)
{
    visitor.whole("version", file.version, {kVersion, kVersion});
    asWhole(visitor, "earlier_parts", file.newest.earlier, kOfCount);
    passFields(visitor, file.newest.pass, kOfAnyEnd);
}

}  // namespace

Result<std::string> toText(const NightReport& report)
{
    StoredReport file{.report = report};
    records::TomlWriter writer;
    reportFields(writer, file);
    const std::string text =
        "# Boresight: the passes that the schedule tracked, the oldest first. Angles are in degrees.\n"
        "# end: 0 tracked to the end, 1 a manual act, 2 a fault, 3 refused, 4 interrupted.\n" +
        writer.written();
    return parseReport(text, QStringLiteral("report")).map([&](const NightReport&) { return text; });
}

Result<NightReport> parseReport(std::string_view text, const QString& fileName)
{
    StoredReport file;
    return records::TomlReader::read(text, fileName, [&](records::TomlReader& reader) { reportFields(reader, file); })
        .map([&] { return std::move(file.report); });
}

Result<std::string> toText(const NewestPass& newest)
{
    StoredPass file{.newest = newest};
    records::TomlWriter writer;
    newestFields(writer, file);
    const std::string text =
        "# Boresight: the pass that the schedule tracks, or has tracked last. Angles are in degrees.\n"
        "# end: 0 tracked to the end, 1 a manual act, 2 a fault, 3 refused, 4 interrupted, 5 not ended yet.\n" +
        writer.written();
    return parsePass(text, QStringLiteral("pass")).map([&](const NewestPass&) { return text; });
}

Result<NewestPass> parsePass(std::string_view text, const QString& fileName)
{
    StoredPass file;
    return records::TomlReader::read(text, fileName, [&](records::TomlReader& reader) { newestFields(reader, file); })
        .map([&] { return std::move(file.newest); });
}

}  // namespace boresight::schedule
