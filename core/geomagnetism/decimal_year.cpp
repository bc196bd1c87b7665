// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geomagnetism/decimal_year.h"

namespace boresight::geomagnetism {

double decimalYear(UtcTime utc)
{
    using namespace std::chrono;
    const year date = year_month_day(floor<days>(utc)).year();
    const UtcTime begin = sys_days(date / January / 1);
    const UtcTime end = sys_days((date + years(1)) / January / 1);
    return static_cast<double>(static_cast<int>(date)) + Seconds(utc - begin) / Seconds(end - begin);
}

}  // namespace boresight::geomagnetism
