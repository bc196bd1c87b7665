// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mount/paired_mount.h"

namespace boresight {
namespace {

template <class Service>
Service* onlyOne(Service* one, Service* other)
{
    return one == nullptr ? other : other == nullptr ? one : nullptr;
}

}  // namespace

Capabilities PairedMount::capabilities() const
{
    return {.axes = {of(Axis::Azimuth).capabilities().axes[index(Axis::Azimuth)],
                     of(Axis::Elevation).capabilities().axes[index(Axis::Elevation)]}};
}

Result<> PairedMount::available() const
{
    return of(Axis::Azimuth).available().and_then([this] { return of(Axis::Elevation).available(); });
}

const Result<>& PairedMount::interlock() const
{
    const Result<>& first = of(Axis::Azimuth).interlock();
    return first ? of(Axis::Elevation).interlock() : first;
}

Result<> PairedMount::mayType() const
{
    const Result<> first = m_drivers[0]->mayType();
    return first ? first : m_drivers[1]->mayType();
}

MountService* PairedMount::service()
{
    return onlyOne(of(Axis::Azimuth).service(), of(Axis::Elevation).service());
}

const MountService* PairedMount::service() const
{
    return onlyOne(of(Axis::Azimuth).service(), of(Axis::Elevation).service());
}

ThirdAxis* PairedMount::thirdAxis()
{
    return onlyOne(of(Axis::Azimuth).thirdAxis(), of(Axis::Elevation).thirdAxis());
}

const ThirdAxis* PairedMount::thirdAxis() const
{
    return onlyOne(of(Axis::Azimuth).thirdAxis(), of(Axis::Elevation).thirdAxis());
}

void PairedMount::observe(SteadyTime now)
{
    for (MountDriver* const driver : m_drivers) {
        driver->observe(now);
    }
}

MountFindings PairedMount::supervise(const MountSituation& known)
{
    MountFindings found;
    for (MountDriver* const driver : m_drivers) {
        MountFindings more = driver->supervise(known);
        found.interrupted = found.interrupted || more.interrupted;
        found.homed = found.homed || more.homed;
        found.troubles.insert(found.troubles.end(), more.troubles.begin(), more.troubles.end());
    }
    return found;
}

void PairedMount::engage()
{
    for (MountDriver* const driver : m_drivers) {
        driver->engage();
    }
}

void PairedMount::retake()
{
    for (MountDriver* const driver : m_drivers) {
        driver->retake();
    }
}

void PairedMount::brakeHard(bool hard)
{
    for (MountDriver* const driver : m_drivers) {
        driver->brakeHard(hard);
    }
}

void PairedMount::seize()
{
    for (MountDriver* const driver : m_drivers) {
        driver->seize();
    }
}

void PairedMount::recover()
{
    for (MountDriver* const driver : m_drivers) {
        driver->recover();
    }
}

void PairedMount::rearmed()
{
    for (MountDriver* const driver : m_drivers) {
        driver->rearmed();
    }
}

void PairedMount::leave(profile::OnExit how)
{
    for (MountDriver* const driver : m_drivers) {
        driver->leave(how);
    }
}

}  // namespace boresight
