// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drive_check/axis_check.h"
#include "core/drive_check/bus_scan.h"
#include "core/drive_check/findings.h"
#include "core/drive_check/identity_findings.h"
#include "core/messages/drives_status.h"
#include "core/profile/in_force.h"

#include <algorithm>
#include <optional>
#include <vector>

// Checks before anything moves which drives are there and whether their safety settings are right. Scans the bus,
// identifies the boards, and reads the safety settings of all drives over their consoles at the same time. On request
// it writes the settings that differ. Then it watches the heartbeats. Pure: its owner calls frames() every tick, sends
// these frames and passes every received frame in. Its source id is kDiagnosticHostId. Nothing that it sends moves an
// axis or feeds a watchdog. States: README.md.
namespace boresight::drive_check {

// The facts about one drive, as last read.
struct DriveFacts
{
    QString uuid;  // 8-4-4-4-12 digits
    DriveIdentity identity;
    SteadyTime bootedAt;         // its power-up
    bool outputEncoder = false;  // an encoder on the axis shows the wrap after power-up
    double rotorToOutputRatio = 0.0;
    bool holdsWhenNotFed = false;  // its time-out mode holds the axis
    OriginReading origin{};
};

class DriveCheck
{
public:
    // The profile outlives this. `axes`: the axes that have a drive. No other axis may be passed to the functions
    // below.
    DriveCheck(const profile::InForce& profile, const KnownBoards& known, AxisSet axes = kAxes);

    // Compares the values that were read with the new profile.
    void profileChanged(const profile::Profile& before, const profile::Profile& after);
    // Starts the check from the beginning. Also called after other tools had the bus.
    void begin(SteadyTime now);
    // The bus or a drive was lost. Nothing is known until begin().
    void forget();
    // Success if the drives are read and a setting differs that can be written.
    [[nodiscard]] Result<> mayFix() const;
    // Writes the settings that differ and can be written. The caller ensures that all drives are in mode 0.
    [[nodiscard]] Result<> fix(SteadyTime now);
    // Reads the origin of the drive's position count again, unless the drives are being read already.
    void readOrigin(Axis axis);
    // The boards on the bus are the right ones. `known`: the boards that the journal knows from now on.
    void setKnownBoards(const KnownBoards& known);

    // At most one frame for each drive, besides those of a scan.
    [[nodiscard]] std::vector<CanFrame> frames(SteadyTime now);
    void take(const CanFrame& frame);

    [[nodiscard]] bool isFixable() const;  // fix() would write or store something
    // While a check is only repeated until all drives are there, the state is NotDone.
    [[nodiscard]] DriveCheckState state() const { return m_retrying ? DriveCheckState::NotDone : m_state; }
    // The check runs, or will start again by itself.
    [[nodiscard]] bool isUnderWay() const { return m_state != DriveCheckState::NotDone || m_retryAt; }
    // The console of this drive is in use.
    [[nodiscard]] bool isAsking(Axis axis) const { return side(axis).drive.isBusy(); }
    [[nodiscard]] QString progress() const;  // what the check does, or why it is not done; may be empty
    [[nodiscard]] const std::optional<DriveFacts>& facts(Axis axis) const { return side(axis).facts; }
    [[nodiscard]] const QList<ProtectionLine>& protections(Axis axis) const { return side(axis).drive.lines(); }
    // All boards of the last finished scan, in the order of their ids.
    [[nodiscard]] const std::vector<FoundController>& boards() const { return m_boards; }
    // The boards of the last finished scan that the profile does not know.
    [[nodiscard]] const std::vector<UnknownBoard>& unknownBoards() const { return m_unknownBoards; }
    // The reason why nothing may move yet, for the operator.
    [[nodiscard]] Result<> fitToMove() const;
    // The findings of the last finished check, the most serious first. A running check keeps them.
    [[nodiscard]] const std::vector<Finding>& findings() const { return m_findings; }
    // The differences from the previous reading.
    [[nodiscard]] std::vector<Change> takeChanges();
    // The number of power-ups that were detected, also while the bus was lost. After each one the drives are checked
    // again.
    [[nodiscard]] int rebootsSeen(Axis axis) const { return side(axis).drive.heartbeat().reboots(); }

private:
    struct Side
    {
        Axis axis = Axis::Azimuth;
        int id = 0;
        AxisCheck drive;
        std::optional<DriveFacts> facts{};
    };

    [[nodiscard]] const Side& side(Axis axis) const { return *std::ranges::find(m_sides, axis, &Side::axis); }
    [[nodiscard]] Side& side(Axis axis) { return *std::ranges::find(m_sides, axis, &Side::axis); }
    void start(SteadyTime now);
    [[nodiscard]] bool anyBusy() const;
    void endScan(SteadyTime now);
    void endReading(SteadyTime now);
    void collectFacts(Side& side);
    void collectUnknownBoards();
    void collectFindings();
    void addProtectionFinding(const Side& side, Verdict verdict);

    const profile::InForce& m_profile;
    KnownBoards m_known;
    AxisSet m_axes;
    BusScan m_scan;
    std::vector<Side> m_sides;
    DriveCheckState m_state = DriveCheckState::NotDone;
    std::optional<SteadyTime> m_retryAt;
    bool m_retrying = false;  // a check has ended without all drives and is repeated
    bool m_fixed = false;     // the last work was a successful Fix
    std::vector<FoundController> m_boards;
    std::vector<UnknownBoard> m_unknownBoards;
    std::vector<Finding> m_findings;
};

}  // namespace boresight::drive_check
