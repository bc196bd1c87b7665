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

// What the calibration desk tells the screen: one immutable snapshot, made again when something changed. Unknown is
// empty; sentences are translated. Angles of the axes are mechanical, directions are true. Nothing in here is in force
// but `present`: the rest is found, and waits for the operator's Apply.
namespace boresight {

enum class CalibrationRun
{
    None,
    SensorOffset,
    Swing,
    CrossScan
};

// What runs now, and how the last run ended.
struct CalibrationProgress
{
    CalibrationRun run = CalibrationRun::None;
    double done = 0.0;  // 0…1
    Seconds left{0.0};
    QString text;     // "turning clockwise, 143 samples"
    QString outcome;  // how the last run ended: why there is no result, or that there is one; empty before the first
    bool failed = false;  // the last run gave nothing
};

// Where a swing will turn, told before it starts.
struct SwingPlan
{
    TravelRange azimuth;  // both ends are visited, within the limits of operation
    Angle elevation;      // the boom stays there
    AngularRate rate;
    int headings = 0;  // stops each way; 0: one sweep each way, without a stop
    Seconds duration{0.0};
    QString text;      // both, in a sentence
    QString obstacle;  // why it can not start now; empty: it can
};

struct SwingOutcome
{
    UtcTime when;
    std::vector<calibration::SwingSample> samples;  // SwingResidual::sample counts through these
    calibration::CompassSwing fit;
    std::optional<calibration::AxisTilt> tilt;
    QString noTilt;  // why there is none
};

// A body that calibrates: where it appears now, as the beam sees it.
struct BodyNow
{
    ephemeris::Body body = ephemeris::Body::Sun;
    SkyPointing direction;  // true azimuth; bent by the air as chosen
    bool isUp = false;
    QString obstacle;            // why the beam can not be pointed there now; empty: it can
    QString obstacleOverTheTop;  // the same with the boom past the zenith
    std::optional<UtcTime> nextRise;
    std::optional<UtcTime> nextSet;
};

// Where the beam is seen from the source: across is azimuth × cos(elevation), clockwise positive.
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
    Angle sigma;  // of how well it was centred
    bool isUsed = true;
    PointResidual before;                // with the terms in force
    std::optional<PointResidual> after;  // with those of the fit
    std::optional<Angle> leftOut;        // how far the fit of the others misses it
};

// One term of the pointing model: what is in force, and what would be.
struct TermStatus
{
    std::string key;  // of its setting: "pointing.tilt_north_deg"
    Angle present;
    Angle proposed;
    std::optional<Angle> sigma;  // of what is proposed; empty: nothing was found out about it
    bool isOn = false;           // the points support it, or it was given
};

struct PointFitStatus
{
    std::vector<TermStatus> terms;  // all of them, in the order of PointingTerms
    Angle before;                   // rms on the sky
    Angle after;
    std::optional<double> reducedChiSquare;
    std::vector<QString> remarks;  // which terms are on and why the others are not, which point stands out
};

// What the points that are used say of the terms in force, and of those proposed: rms on the sky.
struct ProposalResiduals
{
    Angle before;
    Angle after;
    std::size_t points = 0;
};

// What Apply would do.
struct CalibrationProposal
{
    std::uint64_t number = 0;  // to be given back with ApplyCalibration: what was seen is what is applied
    QString title;             // "North from the compass swing"
    QString reason;            // where it comes from: "typed", "compass swing"
    QString text;              // in words, with the figures that change
    QString remark;            // "Your level is off by 0.40° ± 0.05°."; mostly empty
    std::vector<TermStatus> terms;
    std::optional<ProposalResiduals> residuals;  // empty: there are no points to compare with
    bool changesSensor = false;                  // its mounting or curve, too
    std::vector<QString> warnings;               // "the place is magnetically hopeless: …"
    QString obstacle;                            // why it can not be applied now; empty: it can
};

struct CalibrationHistoryEntry
{
    UtcTime when;
    QString title;
    QString change;  // "azimuth offset 0.00° → 37.41°, …"
    QString place;   // the site, and "other drives" where a drive's uuid is not today's
    bool inForce = false;
    bool superseded = false;  // undone, and another was applied since: kept to be read, Redo does not lead to it
    bool otherMount = false;  // another site, or another drive: what it says may not hold any more
};

struct CalibrationStatus
{
    CalibrationProgress progress;
    pointing::PointingTerms present;
    calibration::TermSheet sheet;  // the same with all that is known of it, to be exported
    QString otherMount;            // what was applied last was for another drive or site; empty: it was not
    std::optional<calibration::SensorOffset> sensorOffset;
    QString sensorObstacle;                         // why the sensor is no evidence now; empty: it is
    QString averageObstacle;                        // why MeasureSensorOffset would be refused now; empty: it would not
    SwingPlan swingPlan;                            // for what was planned last, at first with the usual rate
    std::vector<calibration::SwingDot> swingSoFar;  // while it turns, thinned to some hundreds
    std::shared_ptr<const SwingOutcome> swing;      // the last; null before the first
    QString noSite;                                 // why there is neither Sun nor Moon; empty: there are
    std::vector<BodyNow> bodies;                    // Sun, Moon
    ephemeris::Refraction refraction = ephemeris::Refraction::Light;
    std::optional<ephemeris::Body> body;  // the mount was led to last, and to nothing else since: TakePoint means it
    bool following = false;               // and the mount follows it now
    bool overTheTop = false;              // with the boom past the zenith
    QString warning;                      // of eyes and feed, while the beam is at the Sun
    QString pointObstacle;                // why TakePoint would be refused now; empty: it would not
    QString knownPointObstacle;           // the same for TakeKnownPoint
    QString noRoom;                       // why there can be no further point; empty: there can
    std::vector<PointStatus> points;
    std::optional<PointFitStatus> fit;
    QString noFit;  // why the points that are used speak for no model; empty: they do, or there are none
    std::optional<calibration::CrossScan> scan;
    std::optional<double> power;  // dB, given last
    bool wantsPower = false;      // a scan waits for the power at this place
    PowerLineStatus powerLine;    // that the profile names
    std::optional<CalibrationProposal> proposal;
    std::vector<CalibrationHistoryEntry> history;  // newest first
    QString historyProblem;                        // why it could not be read or written; mostly empty
    bool canUndo = false;
    bool canRedo = false;
    QString undoObstacle;  // where there is something to take back: why not now; empty: it can be
    QString redoObstacle;
};

}  // namespace boresight
