// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/drive_check/drive_check_rig.h"

#include "tests/core/drive_check/finding_name.h"
#include "tests/fakes/text_of.h"

#include <algorithm>
#include <map>

namespace boresight::drive_check {

DriveCheckRig::DriveCheckRig(const sim::PairSettings& settings, const profile::Profile& wanted,
                             const KnownBoards& known, AxisSet axes)
    : pair(settings), profile(wanted), drives(inForce, known, axes)
{}

SteadyTime DriveCheckRig::now() const
{
    return SteadyTime(std::chrono::hours(1)) + std::chrono::duration_cast<SteadyTime::duration>(m_elapsed);
}

void DriveCheckRig::tick()
{
    std::map<std::uint32_t, std::size_t> perDrive;
    for (const CanFrame& frame : drives.frames(now())) {
        sent.push_back(frame);
        mostFramesForOneDrive = std::max(mostFramesForOneDrive, ++perDrive[moteus::fromCanId(frame.id).destination]);
        for (const sim::PairReply& reply : pair.exchange(frame, m_elapsed)) {
            m_underWay.push_back(reply);
        }
    }
    m_elapsed += kTick;
    pair.advanceTo(m_elapsed);
    deliver();
}

void DriveCheckRig::deliver()
{
    std::deque<sim::PairReply> later;
    for (const sim::PairReply& reply : m_underWay) {
        if (reply.due > m_elapsed) {
            later.push_back(reply);
        } else {
            drives.take(reply.frame);
        }
    }
    m_underWay = std::move(later);
}

void DriveCheckRig::run(Seconds time)
{
    for (const Seconds end = m_elapsed + time; m_elapsed < end;) {
        tick();
    }
}

bool DriveCheckRig::reaches(DriveCheckState state, Seconds within)
{
    for (const Seconds end = m_elapsed + within; m_elapsed < end && drives.state() != state;) {
        tick();
    }
    return drives.state() == state;
}

void DriveCheckRig::driveCheck()
{
    drives.begin(now());
    run(kTick);
    for (int i = 0; i < 1000 && drives.state() == DriveCheckState::Running; ++i) {
        tick();
    }
}

void DriveCheckRig::otherToolSays(Axis axis, const std::string& command)
{
    const std::string text = command + '\n';
    pair.drive(axis).receiveText(1, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

sim::PairSettings freshFromTheBox()
{
    sim::PairSettings pair = sim::factoryPair();
    pair.elevation.config.id = 2;
    return pair;
}

std::string obstacle(const DriveCheck& driveCheck)
{
    const Result<> fit = driveCheck.fitToMove();
    return fit ? std::string() : textOf(fit.error());
}

std::vector<std::string> causes(const DriveCheck& driveCheck)
{
    std::vector<std::string> all;
    for (const Finding& finding : driveCheck.findings()) {
        all.push_back(nameOf(finding));
    }
    return all;
}

ProtectionLine line(const DriveCheck& driveCheck, Axis axis, const char* key)
{
    const auto lines = driveCheck.protections(axis);
    const auto found = std::ranges::find(lines, QLatin1String(key), &ProtectionLine::key);
    return found != lines.end() ? *found : ProtectionLine{};
}

}  // namespace boresight::drive_check
