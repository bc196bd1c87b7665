// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/drives_status.h"
#include "core/profile/in_force.h"
#include "core/survey/axis_survey.h"
#include "core/survey/bus_scan.h"
#include "core/survey/findings.h"
#include "core/survey/identity_findings.h"

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

// Who the drives are and whether their own protections are right, before anything moves: scans the bus, identifies,
// reads the protections of the drives side by side over their consoles, writes what differs when told to, and then
// listens to their heartbeats. Pure: its owner calls frames() every tick, sends them and brings every received frame.
// Its source number is kDiagnosticHostId; nothing it sends moves an axis or feeds a watchdog. States: README.md.
namespace boresight::survey {

// Of one drive, as last read.
struct DriveFacts
{
    QString uuid;  // 8-4-4-4-12 digits
    DriveIdentity identity;
    SteadyTime bootedAt;         // its power-up
    bool outputEncoder = false;  // an encoder on the axis tells the turn after power-up
    double rotorToOutputRatio = 0.0;
    bool holdsWhenNotFed = false;  // its time-out mode holds the axis
    OriginReading origin{};
};

class DriveSurvey
{
public:
    // The profile outlives this. `axes`: those that have a drive, and the only ones that may be asked about.
    DriveSurvey(const profile::InForce& profile, const KnownBoards& known, AxisSet axes = kAxes);

    // What was found is judged again.
    void profileChanged(const profile::Profile& before, const profile::Profile& after);
    // From the beginning; also after other tools had the bus.
    void begin(SteadyTime now);
    // The bus or a drive was lost: nothing is known until begin().
    void forget();
    // The drives are read, and something differs that can be written.
    [[nodiscard]] Result<> mayFix() const;
    // Writes what differs and can be written. All drives must be in mode 0: the caller sees to that.
    [[nodiscard]] Result<> fix(SteadyTime now);
    // Reads again what the drive's position counts from, unless the drives are being read anyway.
    void readOrigin(Axis axis);
    // The boards are right as they are: what the memory knows from now on.
    void setKnownBoards(const KnownBoards& known);

    // At most one frame for each drive, besides those of a scan.
    [[nodiscard]] std::vector<CanFrame> frames(SteadyTime now);
    void take(const CanFrame& frame);

    [[nodiscard]] bool isFixable() const;  // there is something that fix() would write or store
    // A survey that is only repeated until all drives are there is NotDone.
    [[nodiscard]] SurveyState state() const { return m_retrying ? SurveyState::NotDone : m_state; }
    // Runs, or will again by itself.
    [[nodiscard]] bool isUnderWay() const { return m_state != SurveyState::NotDone || m_retryAt; }
    // The console of this drive is in use.
    [[nodiscard]] bool isAsking(Axis axis) const { return side(axis).drive.isBusy(); }
    [[nodiscard]] QString progress() const;  // what it does, or why it is not done; may be empty
    [[nodiscard]] const std::optional<DriveFacts>& facts(Axis axis) const { return side(axis).facts; }
    [[nodiscard]] std::span<const ProtectionLine> protections(Axis axis) const { return side(axis).drive.lines(); }
    // All boards of the last scan that ended, by their ids.
    [[nodiscard]] const std::vector<FoundController>& boards() const { return m_boards; }
    // Boards that the profile does not know, of the last scan that ended.
    [[nodiscard]] const std::vector<Stranger>& strangers() const { return m_strangers; }
    // In the operator's words why nothing may move yet.
    [[nodiscard]] Result<> fitToMove() const;
    // Of the last survey that ended, the weightiest first; a running one keeps them.
    [[nodiscard]] const std::vector<Finding>& findings() const { return m_findings; }
    // What differs from the reading before.
    [[nodiscard]] std::vector<Change> takeChanges();
    // Power-ups noticed, also those behind a lost bus; the drives are then surveyed again by itself.
    [[nodiscard]] int rebootsSeen(Axis axis) const { return side(axis).drive.heartbeat().reboots(); }

private:
    struct Side
    {
        Axis axis = Axis::Azimuth;
        int id = 0;
        AxisSurvey drive;
        std::optional<DriveFacts> facts{};
    };

    [[nodiscard]] const Side& side(Axis axis) const { return *std::ranges::find(m_sides, axis, &Side::axis); }
    [[nodiscard]] Side& side(Axis axis) { return *std::ranges::find(m_sides, axis, &Side::axis); }
    void start(SteadyTime now);
    [[nodiscard]] bool anyBusy() const;
    void endScan(SteadyTime now);
    void endReading(SteadyTime now);
    void collectFacts(Side& side);
    void collectStrangers();
    void collectFindings();
    void addProtectionFinding(const Side& side, Verdict verdict);

    const profile::InForce& m_profile;
    KnownBoards m_known;
    AxisSet m_axes;
    BusScan m_scan;
    std::vector<Side> m_sides;
    SurveyState m_state = SurveyState::NotDone;
    std::optional<SteadyTime> m_retryAt;
    bool m_retrying = false;  // a survey has ended without all drives, and is repeated
    bool m_fixed = false;     // the last thing done was a Fix that worked
    std::vector<FoundController> m_boards;
    std::vector<Stranger> m_strangers;
    std::vector<Finding> m_findings;
};

}  // namespace boresight::survey
