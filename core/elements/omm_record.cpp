// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/elements/omm_record.h"

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/base/trimmed.h"
#include "core/elements/element_check.h"
#include "core/elements/iso_epoch.h"

#include <algorithm>
#include <utility>

namespace boresight::orbit {

namespace {

// All fields, for every format.
constexpr std::array<std::string_view, 21> kOmmKeys{
    "OBJECT_NAME",  "OBJECT_ID",       "CENTER_NAME",         "REF_FRAME",    "TIME_SYSTEM",    "MEAN_ELEMENT_THEORY",
    "EPOCH",        "MEAN_MOTION",     "ECCENTRICITY",        "INCLINATION",  "RA_OF_ASC_NODE", "ARG_OF_PERICENTER",
    "MEAN_ANOMALY", "EPHEMERIS_TYPE",  "CLASSIFICATION_TYPE", "NORAD_CAT_ID", "ELEMENT_SET_NO", "REV_AT_EPOCH",
    "BSTAR",        "MEAN_MOTION_DOT", "MEAN_MOTION_DDOT"};

std::size_t indexOf(std::string_view key)
{
    return static_cast<std::size_t>(std::ranges::find(kOmmKeys, key) - kOmmKeys.begin());
}

enum class Presence
{
    Required,
    Optional
};

}  // namespace

// Reads a record field by field and keeps the first problem.
class OmmFields
{
public:
    explicit OmmFields(const OmmRecord& record) : m_record(record) {}

    [[nodiscard]] bool isGood() const { return m_problem.reason.isEmpty(); }
    [[nodiscard]] const ElementProblem& problem() const { return m_problem; }

    [[nodiscard]] std::string_view text(std::string_view key) const
    {
        const auto& field = m_record.m_fields[indexOf(key)];
        return field ? std::string_view(field->value) : std::string_view();
    }

    double number(std::string_view key, Presence presence = Presence::Required)
    {
        return read(key, presence, parseFinite(text(key)));
    }

    std::int64_t count(std::string_view key, Presence presence = Presence::Optional)
    {
        return read(key, presence, parseInteger(text(key)));
    }

    JulianDate epoch(std::string_view key) { return read(key, Presence::Required, parseIsoEpoch(text(key))); }

    // The field must be absent or have one of the values that SGP4 can use.
    void require(std::string_view key, std::initializer_list<std::string_view> permitted)
    {
        const std::string_view found = text(key);
        if (!found.empty() && std::ranges::find(permitted, found) == permitted.end()) {
            complain(
                key,
                Text::tr("%1 is %2. SGP4 needs %3.").arg(toQString(key), quoted(found), toQString(*permitted.begin())));
        }
    }

    void complain(std::string_view key, const QString& reason)
    {
        if (m_problem.reason.isEmpty()) {
            const auto& field = m_record.m_fields[indexOf(key)];
            m_problem = {field ? field->line : m_record.m_line, reason};
        }
    }

private:
    template <class Value>
    Value read(std::string_view key, Presence presence, const std::optional<Value>& value)
    {
        if (text(key).empty()) {
            if (presence == Presence::Required) {
                complain(key, Text::tr("%1 is missing.").arg(toQString(key)));
            }
        } else if (!value) {
            complain(key, Text::tr("%1 is \"%2\". This cannot be read.").arg(toQString(key), quoted(text(key))));
        }
        return value.value_or(Value{});
    }

    const OmmRecord& m_record;
    ElementProblem m_problem;
};

void OmmRecord::set(std::string_view key, std::string_view value, int line)
{
    if (m_line == 0) {
        m_line = line;
    }
    if (const std::size_t index = indexOf(key); index < kFields) {
        m_fields[index] = Field{std::string(trimmed(value)), line};
    }
}

bool OmmRecord::has(std::string_view key) const
{
    const std::size_t index = indexOf(key);
    return index < kFields && m_fields[index].has_value();
}

tl::expected<ElementSet, ElementProblem> OmmRecord::elements() const
{
    static_assert(kOmmKeys.size() == kFields);
    OmmFields fields(*this);
    fields.require("CENTER_NAME", {"EARTH", "Earth"});
    fields.require("REF_FRAME", {"TEME"});
    fields.require("TIME_SYSTEM", {"UTC"});
    fields.require("MEAN_ELEMENT_THEORY", {"SGP4", "SGP/SGP4", "SDP4"});
    fields.require("EPHEMERIS_TYPE", {"0", "1", "2", "3"});
    ElementSet set{.name = nameOf(fields.text("OBJECT_NAME")),
                   .number = fields.count("NORAD_CAT_ID", Presence::Required),
                   .designator = nameOf(fields.text("OBJECT_ID")),
                   .classification = classificationOf(fields.text("CLASSIFICATION_TYPE")),
                   .epoch = fields.epoch("EPOCH"),
                   .revolutionsPerDay = fields.number("MEAN_MOTION"),
                   .eccentricity = fields.number("ECCENTRICITY"),
                   .inclination = Angle::fromDegrees(fields.number("INCLINATION")),
                   .ascendingNode = Angle::fromDegrees(fields.number("RA_OF_ASC_NODE")),
                   .perigee = Angle::fromDegrees(fields.number("ARG_OF_PERICENTER")),
                   .meanAnomaly = Angle::fromDegrees(fields.number("MEAN_ANOMALY")),
                   .bstar = fields.number("BSTAR"),
                   .meanMotionDot = fields.number("MEAN_MOTION_DOT", Presence::Optional),
                   .meanMotionDoubleDot = fields.number("MEAN_MOTION_DDOT", Presence::Optional),
                   .setNumber = fields.count("ELEMENT_SET_NO"),
                   .revolution = fields.count("REV_AT_EPOCH")};
    if (const QString problem = elementProblem(set); !problem.isEmpty()) {
        fields.complain("OBJECT_NAME", problem);
    }
    if (!fields.isGood()) {
        return tl::unexpected(fields.problem());
    }
    return set;
}

void OmmRecord::addTo(ElementList& list) const
{
    auto read = elements();
    if (read) {
        list.sets.push_back(std::move(*read));
    } else {
        list.addProblem(read.error().line, read.error().reason);
    }
}

}  // namespace boresight::orbit
