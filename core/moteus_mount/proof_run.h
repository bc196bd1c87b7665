// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/event_log.h"
#include "core/moteus_mount/crash_stop_proof.h"
#include "core/moteus_mount/drive_pair.h"
#include "core/moteus_mount/turn_keeper.h"
#include "core/moteus_mount/turn_watch.h"
#include "core/mount/mount_service.h"

#include <QString>

#include <optional>

// Runs the crash-stop test on the drives: lets each drive run without commands, recovers it and records how its axis
// stopped. Whether the test may begin is decided by the caller. Station thread only.
namespace boresight {

class ProofRun
{
public:
    ProofRun(DrivePair& drives, TurnKeeper& turns, const TurnWatch& facts, EventLog& log)
        : m_drives(drives), m_turns(turns), m_facts(facts), m_log(log)
    {}

    void begin(const CrashStopProof& proof);
    [[nodiscard]] bool running() const { return m_proof.has_value(); }
    // The progress of the test, or how the last one ended.
    [[nodiscard]] QString text() const { return m_proof ? m_proof->progress() : m_text; }
    // Once in a tick: how the test wants the mount to be moved.
    [[nodiscard]] MountService::ProofStep step(SteadyTime now, UtcTime utc);
    void end(const QString& how);

private:
    void keepStop(Axis axis, UtcTime utc);

    DrivePair& m_drives;
    TurnKeeper& m_turns;
    const TurnWatch& m_facts;
    EventLog& m_log;
    std::optional<CrashStopProof> m_proof;
    QString m_text;
};

}  // namespace boresight
