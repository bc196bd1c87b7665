// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/calibration/axis_tilt.h"
#include "core/calibration/compass_swing.h"
#include "core/calibration/cross_scan.h"
#include "core/calibration/sensor_offset.h"
#include "core/calibration/swing_tally.h"
#include "core/calibration/terms_text.h"
#include "core/ephemeris/almanac.h"
#include "core/ephemeris/refraction.h"
#include "core/messages/power_line_status.h"
#include "core/pointing/pointing_model.h"
#include "core/units/sky.h"

#include <QString>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

// What the calibration desk reports to the screen: one immutable snapshot, which is replaced after each change. An
// unknown value is empty. Sentences are translated. Angles of the axes are mechanical, directions are true. Only
// `present` is in force. Everything else was measured and waits for the operator's Apply.
namespace boresight {

enum class CalibrationRun
{
    None,
    SensorOffset,
    Swing,
    CrossScan
};

// The present run, and how the last run ended.
struct CalibrationProgress
{
    CalibrationRun run = CalibrationRun::None;
    double done = 0.0;  // 0…1
    Seconds left{0.0};
    QString text;     // "turning clockwise, 143 samples"
    QString outcome;  // how the last run ended: why there is no result, or that there is one; empty before the first
    bool failed = false;  // the last run gave no result
};

// Where a compass swing will turn the mount, reported before the swing starts.
struct SwingPlan
{
    TravelRange azimuth;  // both ends are visited, within the limits of operation
    Angle elevation;      // the boom stays there
    AngularRate rate;
    int headings = 0;  // stops each way; 0: one sweep each way, without a stop
    Seconds duration{0.0};
    QString text;      // the range and the duration, in a sentence
    QString obstacle;  // why the swing cannot start now; empty: it can
};

struct SwingOutcome
{
    UtcTime when;
    std::vector<calibration::SwingSample> samples;  // SwingResidual::sample counts through these
    calibration::CompassSwing fit;
    std::optional<calibration::AxisTilt> tilt;
    QString noTilt;  // why `tilt` is empty
};

// A body used for calibration, and its present direction as the beam sees it.
struct BodyNow
{
    ephemeris::Body body = ephemeris::Body::Sun;
    SkyPointing direction;  // true azimuth, with the chosen refraction
    bool isUp = false;
    QString obstacle;            // why the beam cannot be pointed there now; empty: it can
    QString obstacleOverTheTop;  // the same with the boom past the zenith
    std::optional<UtcTime> nextRise;
    std::optional<UtcTime> nextSet;
};

// The direction of the beam minus that of the source. `across` is azimuth × cos(elevation), clockwise positive.
struct PointResidual
{
    Angle across;
    Angle elevation;
};

struct PointStatus
{
    QString label;  // "Sun"
    UtcTime when;
    AxisPosition axes;
    SkyPointing truth;
    Angle sigma;  // uncertainty of the centring
    bool isUsed = true;
    PointResidual before;                // with the terms in force
    std::optional<PointResidual> after;  // with the terms of the fit
    std::optional<Angle> leftOut;        // residual of this point against a fit of the other points
};

// One term of the pointing model: its value in force and its proposed value.
struct TermStatus
{
    std::string key;  // the key of its setting: "pointing.tilt_north_deg"
    Angle present;
    Angle proposed;
    std::optional<Angle> sigma;  // uncertainty of `proposed`; empty: the points do not determine the term
    bool isOn = false;           // the points support the term, or the operator entered it
};

struct PointFitStatus
{
    std::vector<TermStatus> terms;  // all of them, in the order of PointingTerms
    Angle before;                   // rms on the sky
    Angle after;
    std::optional<double> reducedChiSquare;
    std::vector<QString> remarks;  // which terms are on and why the others are not, which point stands out
};

// The rms error on the sky of the used points, with the terms in force and with the proposed terms.
struct ProposalResiduals
{
    Angle before;
    Angle after;
    std::size_t points = 0;
};

// The changes that Apply would make.
struct CalibrationProposal
{
    std::uint64_t number = 0;  // ApplyCalibration repeats it, so that only the proposal on the screen is applied
    QString title;             // "North from the compass swing"
    QString reason;            // its origin: "typed", "compass swing"
    QString text;              // in words, with the values that change
    QString remark;            // "Your level is off by 0.40° ± 0.05°."; mostly empty
    std::vector<TermStatus> terms;
    std::optional<ProposalResiduals> residuals;  // empty: there are no points to compare with
    bool changesSensor = false;                  // it also changes the mounting or the curve of the sensor
    std::vector<QString> doubts = {};            // why it is unreliable: Apply needs ApplyCalibration::overridesDoubts
    std::vector<QString> warnings;               // "the place is magnetically hopeless: …"
    QString obstacle;                            // why it cannot be applied now; empty: it can
};

struct CalibrationHistoryEntry
{
    UtcTime when;
    QString title;
    QString change;  // "azimuth offset 0.00° → 37.41°, …"
    QString place;   // the site, and "other drives" if the uuid of a drive has changed since
    bool inForce = false;
    bool superseded = false;  // undone before another one was applied: shown, but Redo cannot restore it
    bool otherMount = false;  // made at another site or with another drive, so it may be wrong for this mount
};

struct CalibrationStatus
{
    CalibrationProgress progress;
    pointing::PointingTerms present;
    calibration::TermSheet sheet;  // `present` with all known details, for the export
    QString otherMount;            // set if the last applied calibration was for another drive or site; else empty
    std::optional<calibration::SensorOffset> sensorOffset;
    QString sensorObstacle;   // why the sensor cannot be used now; empty: it can
    QString averageObstacle;  // why MeasureSensorOffset would be refused now; empty: it would be accepted
    SwingPlan swingPlan;      // of the last PlanSwing request, at first with the usual rate
    std::vector<calibration::SwingDot> swingSoFar;  // of the running swing, thinned to a few hundred
    std::shared_ptr<const SwingOutcome> swing;      // of the last swing; null before the first
    QString noSite;                                 // why Sun and Moon are not computed; empty: they are
    std::vector<BodyNow> bodies;                    // Sun, Moon
    ephemeris::Refraction refraction = ephemeris::Refraction::Light;
    std::optional<ephemeris::Body>
        body;                    // the last target of the mount; empty after any other motion. TakePoint uses it
    bool following = false;      // the mount follows `body` now
    bool overTheTop = false;     // with the boom past the zenith
    QString warning;             // about eyes and feed, while the beam points at the Sun
    QString pointObstacle;       // why TakePoint would be refused now; empty: it would be accepted
    QString knownPointObstacle;  // the same for TakeKnownPoint
    QString noRoom;              // why no further point can be added; empty: it can
    std::vector<PointStatus> points;
    std::optional<PointFitStatus> fit;
    QString noFit;  // why the used points give no model; empty: they give one, or there are no points
    std::optional<calibration::CrossScan> scan;
    std::optional<double> power;  // dB, the last one entered or received
    bool wantsPower = false;      // a scan waits for the power at this place
    PowerLineStatus powerLine;    // of the line in the profile
    std::optional<CalibrationProposal> proposal;
    std::vector<CalibrationHistoryEntry> history;  // newest first
    QString historyProblem;                        // why the history could not be read or written; else empty
    bool canUndo = false;
    bool canRedo = false;
    QString undoObstacle;  // why Undo would be refused now, if there is something to undo; empty: it would be accepted
    QString redoObstacle;  // the same for Redo
};

}  // namespace boresight
