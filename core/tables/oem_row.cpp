// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tables/oem_row.h"

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/elements/element_check.h"
#include "core/elements/iso_epoch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace boresight::tables {
namespace {

constexpr double kLeastRadius = 6000.0;      // km from the centre of the Earth, below any ground
constexpr double kMostRadius = 2'000'000.0;  // km, beyond the Lagrange points
constexpr double kMostSpeed = 100.0;         // km/s
constexpr double kWidest = 60.0;             // degrees around the Earth between two rows

// A time and up to nine numbers. One more field is kept to detect a line that is too long.
struct Fields
{
    std::array<std::string_view, 11> texts{};
    std::size_t count = 0;
};

Fields fieldsOf(std::string_view line)
{
    constexpr std::string_view kBlanks = " \t";
    Fields fields;
    while (!line.empty() && fields.count < fields.texts.size()) {
        const std::size_t end = std::min(line.find_first_of(kBlanks), line.size());
        fields.texts[fields.count++] = line.substr(0, end);
        line.remove_prefix(std::min(line.find_first_not_of(kBlanks, end), line.size()));
    }
    return fields;
}

tl::unexpected<Error> badRow(const QString& reason)
{
    return failure(ErrorCode::InvalidInput, reason);
}

Result<> isPlausible(const OrbitRow& row)
{
    const double radius = orbit::length(row.position);
    if (!(radius >= kLeastRadius && radius <= kMostRadius)) {
        return badRow(
            Text::tr("The position is %1 km from the centre of the Earth. The range is %2 to %3 km. Check the "
                     "unit: positions are in km.")
                .arg(radius, 0, 'g', 6)
                .arg(kLeastRadius, 0, 'f', 0)
                .arg(kMostRadius, 0, 'f', 0));
    }
    const double speed = orbit::length(row.velocity);
    return speed <= kMostSpeed ? Result<>()
                               : badRow(Text::tr("The speed is %1 km/s. It must be at most %2 km/s. The unit is km/s.")
                                            .arg(speed, 0, 'g', 6)
                                            .arg(kMostSpeed, 0, 'f', 0));
}

}  // namespace

Result<OrbitRow> oemRow(std::string_view line, TimeSystem system)
{
    const Fields fields = fieldsOf(line);
    const auto date = orbit::parseIsoEpoch(fields.texts[0]);
    if (!date) {
        return badRow(Text::tr("\"%1\" is not a time like 2024-05-10T04:50:02.5.").arg(orbit::quoted(fields.texts[0])));
    }
    if (fields.count != 7 && fields.count != 10) {
        return badRow(Text::tr("The row must have 6 numbers behind its time, or 9 with accelerations."));
    }
    std::array<double, 9> numbers{};
    for (std::size_t i = 0; i + 1 < fields.count; ++i) {
        const auto number = parseFinite(fields.texts[i + 1]);
        if (!number) {
            return badRow(Text::tr("\"%1\" is not a number.").arg(orbit::quoted(fields.texts[i + 1])));
        }
        numbers[i] = *number;
    }
    const OrbitRow row{.time = atomicTime(*date, system),
                       .position = {numbers[0], numbers[1], numbers[2]},
                       .velocity = {numbers[3], numbers[4], numbers[5]}};
    return isPlausible(row).map([&] { return row; });
}

Result<> follows(const OrbitRow& before, const OrbitRow& row)
{
    if (row.time <= before.time) {
        return badRow(Text::tr("The time is not later than the time in the row above. Sort the rows by time."));
    }
    const double cosine =
        orbit::dot(before.position, row.position) / (orbit::length(before.position) * orbit::length(row.position));
    const double degrees = std::acos(std::clamp(cosine, -1.0, 1.0)) * 180.0 / std::numbers::pi;
    return degrees < kWidest
               ? Result<>()
               : badRow(Text::tr("The place is %1° around the Earth from the place in the row above. It must be "
                                 "below %2°. Add rows between them.")
                            .arg(degrees, 0, 'f', 1)
                            .arg(kWidest, 0, 'f', 0));
}

}  // namespace boresight::tables
