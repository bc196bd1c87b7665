// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus_mount/proof_run.h"

#include "core/base/text.h"

namespace boresight {

void ProofRun::begin(const CrashStopProof& proof)
{
    m_proof = proof;
    m_text.clear();
}

MountService::ProofStep ProofRun::step(SteadyTime now, UtcTime utc)
{
    if (!m_proof || (m_proof->runningUp() && !m_drives.engaged())) {
        return {};
    }
    const Axis axis = m_proof->axis();
    Drive& drive = m_drives.drive(axis);
    const auto& place = drive.place();
    if (!place) {
        end(Text::tr("ended because the drive no longer reports a position"));
        return {.ended = true};
    }
    const bool settled = drive.phase() == Drive::Phase::Engaged || drive.phase() == Drive::Phase::Listening;
    switch (m_proof->step(now, {.received = place->received, .angle = *m_drives.measured(axis), .settled = settled})) {
        case CrashStopProof::Action::Run:
            return {.run = axis == Axis::Azimuth ? AxisRates{.azimuth = m_proof->rate()}
                                                 : AxisRates{.elevation = m_proof->rate()}};
        case CrashStopProof::Action::Starve:
            drive.starve();
            return {.rest = true};
        case CrashStopProof::Action::Recover:
            keepStop(axis, utc);
            drive.engage();
            return {};
        case CrashStopProof::Action::Wait:
            return {};
        case CrashStopProof::Action::Finish:
            break;
    }
    end(m_proof->failure().isEmpty() ? Text::tr("done") : m_proof->failure());
    return {.ended = true};
}

void ProofRun::keepStop(Axis axis, UtcTime utc)
{
    if (const auto stop = m_proof->takeStop()) {
        const auto& facts = m_facts.facts(axis);
        m_turns.keep(axis, {.drive = facts ? facts->uuid : QString(),
                            .rate = stop->rate,
                            .angle = stop->angle,
                            .time = stop->time,
                            .when = utc});
        m_log.add(Severity::Advisory, toQString(m_drives.drive(axis).name()),
                  Text::tr("crash stop from %1°/s: stopped after %2° and %3 ms")
                      .arg(stop->rate.degrees(), 0, 'f', 1)
                      .arg(stop->angle.degrees(), 0, 'f', 2)
                      .arg(stop->time.count()));
    }
}

void ProofRun::end(const QString& how)
{
    for (const Axis axis : m_drives.axes()) {
        if (m_drives.drive(axis).phase() == Drive::Phase::Starving) {
            m_drives.drive(axis).engage();
        }
    }
    m_proof.reset();
    m_text = how;
    m_log.add(Severity::Advisory, QStringLiteral("station"), Text::tr("crash-stop test: %1").arg(how));
}

}  // namespace boresight
