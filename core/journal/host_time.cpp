// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/journal/host_time.h"

#include <QFile>

#include <sys/timex.h>

namespace boresight::journal {
namespace {

// The limit of the clock error that the kernel reports. A Linux client asks its time server at least every 34 minutes.
// Between two queries the bound grows to 1.0 s (500 ppm).
constexpr long kLargestErrorMicroseconds = 2'000'000;

QString readBootId()
{
    QFile file(QStringLiteral("/proc/sys/kernel/random/boot_id"));
    return file.open(QIODevice::ReadOnly) ? QString::fromLatin1(file.readAll()).trimmed() : QString();
}

bool utcIsExact()
{
    timex state{};  // modes 0: the call only reads
    const int result = ::adjtimex(&state);
    return result != -1 && result != TIME_ERROR && state.maxerror < kLargestErrorMicroseconds;
}

}  // namespace

HostTime hostTime(const Clock& clock)
{
    static const QString boot = readBootId();
    return {.boot = boot, .sinceBoot = clock.now().time_since_epoch(), .utcIsExact = utcIsExact()};
}

}  // namespace boresight::journal
