// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/calibration_record.h"
#include "core/records/field_list.h"

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

// Every key of a history file, described once (core/records/field_list.h). Simple keys come before tables, as TOML
// requires. Angles are in degrees.
namespace boresight::calibration::record {

using records::Range;

inline constexpr std::int64_t kVersion = 1;

struct HistoryFile
{
    std::int64_t version = kVersion;
    std::int64_t inForce = 0;
    std::vector<CalibrationRecord> entries;
    std::vector<CalibrationRecord> superseded;
};

// The permitted ranges. They are wide: they reject broken values, not unusual ones.
inline constexpr Range kOfAxis{-36000.0, 36000.0};
inline constexpr Range kOfTerm{-360.0, 360.0};
inline constexpr Range kOfAzimuth{0.0, 360.0};
inline constexpr Range kOfElevation{-90.0, 180.0};
inline constexpr Range kOfSigma{0.0, 360.0};
inline constexpr Range kOfPointSigma{1e-6, 90.0};
inline constexpr Range kOfLatitude{-90.0, 90.0};
inline constexpr Range kOfLongitude{-360.0, 360.0};
inline constexpr Range kOfHeight{-1000.0, 10000.0};  // m

inline constexpr std::array<std::string_view, kTerms> kTermKeys = {
    "azimuth_offset_deg", "elevation_offset_deg",     "tilt_north_deg",   "tilt_east_deg",
    "collimation_deg",    "non_perpendicularity_deg", "elevation_sag_deg"};

inline constexpr std::array<std::string_view, 2> kSenses = {"clockwise", "counterclockwise"};

template <class Visitor>
void siteFields(Visitor& visitor, RecordSite& site)
{
    inDegrees(visitor, "latitude_deg", site.latitude, kOfLatitude);
    inDegrees(visitor, "longitude_deg", site.longitude, kOfLongitude);
    visitor.number("height_m", site.heightMetres, kOfHeight);
}

template <class Visitor>
void termFields(Visitor& visitor, pointing::PointingTerms& terms)
{
    for (const Term term : kAllTerms) {
        inDegrees(visitor, kTermKeys[indexOf(term)], valueOf(terms, term), kOfTerm);
    }
}

template <class Visitor>
void sigmaFields(Visitor& visitor, std::array<std::optional<Angle>, kTerms>& sigmas)
{
    for (const Term term : kAllTerms) {
        optionalInDegrees(visitor, kTermKeys[indexOf(term)], sigmas[indexOf(term)], kOfSigma);
    }
}

template <class Visitor>
void sectorFields(Visitor& visitor, UnreliableSector& sector)
{
    inDegrees(visitor, "from_deg", sector.from, kOfAzimuth);
    inDegrees(visitor, "to_deg", sector.to, kOfAzimuth);
    inDegrees(visitor, "residual_deg", sector.residual, kOfTerm);
}

template <class Visitor>
void curveFields(Visitor& visitor, DeviationCurve& curve)
{
    visitor.choice("sense", curve.sense, kSenses);
    inDegrees(visitor, "constant_deg", curve.constant, kOfTerm);
    inDegrees(visitor, "a1_deg", curve.a1, kOfTerm);
    inDegrees(visitor, "b1_deg", curve.b1, kOfTerm);
    inDegrees(visitor, "a2_deg", curve.a2, kOfTerm);
    inDegrees(visitor, "b2_deg", curve.b2, kOfTerm);
    inDegrees(visitor, "scatter_deg", curve.scatter, kOfSigma);
    optionalInDegrees(visitor, "constant_sigma_deg", curve.constantSigma, kOfSigma);
    optionalInDegrees(visitor, "elevation_deg", curve.elevation, kOfElevation);
    visitor.list("unreliable", curve.unreliable, sectorFields<Visitor>);
}

template <class Visitor>
void mountingFields(Visitor& visitor, SensorMounting& mounting)
{
    visitor.choice("sense", mounting.sense, kSenses);
    inDegrees(visitor, "azimuth_offset_deg", mounting.azimuthOffset, kOfTerm);
    inDegrees(visitor, "elevation_offset_deg", mounting.elevationOffset, kOfTerm);
    optionalTable(visitor, "curve", mounting.curve, curveFields<Visitor>);
}

template <class Visitor, class Value, void fields(Visitor&, Value&)>
void changeFields(Visitor& visitor, Change<Value>& change)
{
    visitor.table("before", change.before, fields);
    visitor.table("after", change.after, fields);
}

template <class Visitor>
void pointFields(Visitor& visitor, CalibrationPoint& point)
{
    visitor.time("when", point.when);
    visitor.text("label", point.label);
    inDegrees(visitor, "axis_azimuth_deg", point.axes.azimuth, kOfAxis);
    inDegrees(visitor, "axis_elevation_deg", point.axes.elevation, kOfAxis);
    inDegrees(visitor, "true_azimuth_deg", point.truth.azimuth, kOfTerm);
    inDegrees(visitor, "true_elevation_deg", point.truth.elevation, kOfElevation);
    inDegrees(visitor, "sigma_deg", point.sigma, kOfPointSigma);
    visitor.flag("used", point.isUsed);
}

template <class Visitor>
void recordFields(Visitor& visitor, CalibrationRecord& record)
{
    visitor.time("when", record.when);
    visitor.text("title", record.title);
    visitor.text("azimuth_drive", record.mount.azimuthDrive);
    visitor.text("elevation_drive", record.mount.elevationDrive);
    optionalTable(visitor, "site", record.mount.site, siteFields<Visitor>);
    visitor.table("terms", record.terms, changeFields<Visitor, pointing::PointingTerms, termFields<Visitor>>);
    visitor.table("sigmas", record.sigmas, sigmaFields<Visitor>);
    optionalTable(visitor, "sensor", record.sensor, changeFields<Visitor, SensorMounting, mountingFields<Visitor>>);
    visitor.list("point", record.points, pointFields<Visitor>);
}

template <class Visitor>
void historyFields(Visitor& visitor, HistoryFile& file)
{
    visitor.whole("version", file.version, {kVersion, kVersion});
    visitor.countOf("in_force", file.inForce, "calibration");
    visitor.list("calibration", file.entries, recordFields<Visitor>);
    visitor.list("superseded", file.superseded, recordFields<Visitor>);
}

}  // namespace boresight::calibration::record
