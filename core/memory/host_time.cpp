// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/memory/host_time.h"

#include <QFile>

#include <sys/timex.h>

namespace boresight::memory {
namespace {

// The kernel's own bound of its error. A time server asked every 34 minutes, the rarest a Linux client asks, lets the
// bound grow to 1.0 s in between (500 ppm).
constexpr long kLargestErrorMicroseconds = 2'000'000;

QString readBootId()
{
    QFile file(QStringLiteral("/proc/sys/kernel/random/boot_id"));
    return file.open(QIODevice::ReadOnly) ? QString::fromLatin1(file.readAll()).trimmed() : QString();
}

bool utcIsExact()
{
    timex state{};  // modes 0: only asks
    const int result = ::adjtimex(&state);
    return result != -1 && result != TIME_ERROR && state.maxerror < kLargestErrorMicroseconds;
}

}  // namespace

HostTime hostTime(const Clock& clock)
{
    static const QString boot = readBootId();
    return {.boot = boot, .sinceBoot = clock.now().time_since_epoch(), .utcIsExact = utcIsExact()};
}

}  // namespace boresight::memory
