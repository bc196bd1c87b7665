// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/ephemeris/body_table.h"

#include "core/base/numbers.h"

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace boresight::ephemeris {

namespace {

int part(const std::string& text, std::size_t from, std::size_t length)
{
    return static_cast<int>(parseInteger(text.substr(from, length)).value());
}

std::vector<std::string> fieldsOf(const std::string& line)
{
    std::vector<std::string> fields;
    std::istringstream stream(line);
    for (std::string field; std::getline(stream, field, ',');) {
        fields.push_back(field);
    }
    return fields;
}

}  // namespace

UtcTime utcOf(const std::string& text)
{
    const std::chrono::year_month_day date{std::chrono::year(part(text, 0, 4)),
                                           std::chrono::month(static_cast<unsigned>(part(text, 5, 2))),
                                           std::chrono::day(static_cast<unsigned>(part(text, 8, 2)))};
    return std::chrono::sys_days(date) + std::chrono::hours(part(text, 11, 2)) +
           std::chrono::minutes(part(text, 14, 2)) + std::chrono::seconds(part(text, 17, 2));
}

Site siteOf(const std::string& name)
{
    if (name == "Lisbon") {
        return {.latitude = 38.757_deg, .longitude = -9.117_deg, .heightMetres = 80.0};
    }
    if (name == "Sydney") {
        return {.latitude = -33.87_deg, .longitude = 151.21_deg, .heightMetres = 10.0};
    }
    if (name == "Svalbard") {
        return {.latitude = 78.23_deg, .longitude = 15.39_deg, .heightMetres = 450.0};
    }
    throw std::runtime_error("no site " + name);
}

std::vector<BodyRow> bodyTable()
{
    std::ifstream file(BORESIGHT_TEST_DATA "/moonsun_azel.csv");
    std::vector<BodyRow> rows;
    for (std::string line; std::getline(file, line);) {
        if (!line.starts_with("sun,") && !line.starts_with("moon,")) {
            continue;
        }
        const auto fields = fieldsOf(line);
        rows.push_back({.body = fields.at(0) == "sun" ? Body::Sun : Body::Moon,
                        .site = fields.at(1),
                        .utc = utcOf(fields.at(2)),
                        .direction = {.azimuth = Angle::fromDegrees(parseFinite(fields.at(3)).value()),
                                      .elevation = Angle::fromDegrees(parseFinite(fields.at(4)).value())},
                        .kilometres = parseFinite(fields.at(5)).value()});
    }
    return rows;
}

}  // namespace boresight::ephemeris
