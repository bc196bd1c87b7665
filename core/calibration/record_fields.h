// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/calibration_record.h"

#include <array>
#include <string_view>

// Every key of the file of a history, described once: `fields(visitor, value)` calls the visitor for each, and it
// writes or reads. What is simple comes before the tables, as TOML wants it. Angles are in degrees.
namespace boresight::calibration::record {

inline constexpr int kVersion = 1;

// What a file must keep to; wide on purpose: it refuses what is broken, not what is unusual.
struct Range
{
    double min;
    double max;
};
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
void fields(Visitor& visitor, RecordSite& site)
{
    visitor.angle("latitude_deg", site.latitude, kOfLatitude);
    visitor.angle("longitude_deg", site.longitude, kOfLongitude);
    visitor.number("height_m", site.heightMetres, kOfHeight);
}

template <class Visitor>
void fields(Visitor& visitor, pointing::PointingTerms& terms)
{
    for (const Term term : kAllTerms) {
        visitor.angle(kTermKeys[indexOf(term)], valueOf(terms, term), kOfTerm);
    }
}

template <class Visitor>
void fields(Visitor& visitor, std::array<std::optional<Angle>, kTerms>& sigmas)
{
    for (const Term term : kAllTerms) {
        visitor.optionalAngle(kTermKeys[indexOf(term)], sigmas[indexOf(term)], kOfSigma);
    }
}

template <class Visitor>
void fields(Visitor& visitor, UnreliableSector& sector)
{
    visitor.angle("from_deg", sector.from, kOfAzimuth);
    visitor.angle("to_deg", sector.to, kOfAzimuth);
    visitor.angle("residual_deg", sector.residual, kOfTerm);
}

template <class Visitor>
void fields(Visitor& visitor, DeviationCurve& curve)
{
    visitor.choice("sense", curve.sense, kSenses);
    visitor.angle("constant_deg", curve.constant, kOfTerm);
    visitor.angle("a1_deg", curve.a1, kOfTerm);
    visitor.angle("b1_deg", curve.b1, kOfTerm);
    visitor.angle("a2_deg", curve.a2, kOfTerm);
    visitor.angle("b2_deg", curve.b2, kOfTerm);
    visitor.angle("scatter_deg", curve.scatter, kOfSigma);
    visitor.optionalAngle("constant_sigma_deg", curve.constantSigma, kOfSigma);
    visitor.optionalAngle("elevation_deg", curve.elevation, kOfElevation);
    visitor.list("unreliable", curve.unreliable);
}

template <class Visitor>
void fields(Visitor& visitor, SensorMounting& mounting)
{
    visitor.choice("sense", mounting.sense, kSenses);
    visitor.angle("azimuth_offset_deg", mounting.azimuthOffset, kOfTerm);
    visitor.angle("elevation_offset_deg", mounting.elevationOffset, kOfTerm);
    visitor.optionalTable("curve", mounting.curve);
}

template <class Visitor, class Value>
void fields(Visitor& visitor, Change<Value>& change)
{
    visitor.table("before", change.before);
    visitor.table("after", change.after);
}

template <class Visitor>
void fields(Visitor& visitor, CalibrationPoint& point)
{
    visitor.time("when", point.when);
    visitor.text("label", point.label);
    visitor.angle("axis_azimuth_deg", point.axes.azimuth, kOfAxis);
    visitor.angle("axis_elevation_deg", point.axes.elevation, kOfAxis);
    visitor.angle("true_azimuth_deg", point.truth.azimuth, kOfTerm);
    visitor.angle("true_elevation_deg", point.truth.elevation, kOfElevation);
    visitor.angle("sigma_deg", point.sigma, kOfPointSigma);
    visitor.flag("used", point.isUsed);
}

template <class Visitor>
void fields(Visitor& visitor, CalibrationRecord& record)
{
    visitor.time("when", record.when);
    visitor.text("title", record.title);
    visitor.text("azimuth_drive", record.mount.azimuthDrive);
    visitor.text("elevation_drive", record.mount.elevationDrive);
    visitor.optionalTable("site", record.mount.site);
    visitor.table("terms", record.terms);
    visitor.table("sigmas", record.sigmas);
    visitor.optionalTable("sensor", record.sensor);
    visitor.list("point", record.points);
}

}  // namespace boresight::calibration::record
