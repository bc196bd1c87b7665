// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/messages/station_status.h"

#include "core/base/text.h"

#include <array>

namespace boresight {
namespace {

// Any other source, such as "rotctld" or the address of a client, is the same in all languages.
constexpr std::array kSources{QT_TRANSLATE_NOOP("Text", "azimuth drive"),
                              QT_TRANSLATE_NOOP("Text", "elevation drive"),
                              QT_TRANSLATE_NOOP("Text", "command line"),
                              QT_TRANSLATE_NOOP("Text", "operator"),
                              QT_TRANSLATE_NOOP("Text", "schedule"),
                              QT_TRANSLATE_NOOP("Text", "shell"),
                              QT_TRANSLATE_NOOP("Text", "station"),
                              QT_TRANSLATE_NOOP("Text", "azimuth"),
                              QT_TRANSLATE_NOOP("Text", "elevation"),
                              QT_TRANSLATE_NOOP("Text", "drives"),
                              QT_TRANSLATE_NOOP("Text", "position journal"),
                              QT_TRANSLATE_NOOP("Text", "recording"),
                              QT_TRANSLATE_NOOP("Text", "sensor"),
                              QT_TRANSLATE_NOOP("Text", "calibration"),
                              QT_TRANSLATE_NOOP("Text", "bus"),
                              QT_TRANSLATE_NOOP("Text", "Sun"),
                              QT_TRANSLATE_NOOP("Text", "wind"),
                              QT_TRANSLATE_NOOP("Text", "log")};

}  // namespace

QString word(StationState state)
{
    switch (state) {
        case StationState::Disconnected:
            return Text::tr("DISCONNECTED", "station state");
        case StationState::Standby:
            return Text::tr("STANDBY", "station state");
        case StationState::Hold:
            return Text::tr("HOLD", "station state");
        case StationState::Slew:
            return Text::tr("SLEW", "station state");
        case StationState::Track:
            return Text::tr("TRACK", "station state");
        case StationState::Jog:
            return Text::tr("JOG", "station state");
        case StationState::Parked:
            return Text::tr("PARKED", "station state");
        case StationState::Calibrate:
            return Text::tr("CALIBRATE", "station state");
        case StationState::Stopped:
            return Text::tr("STOPPED", "station state");
        case StationState::Fault:
            return Text::tr("FAULT", "station state");
    }
    return {};
}

QString word(AxisState state)
{
    switch (state) {
        case AxisState::NoData:
            return Text::tr("NO DATA", "axis state");
        case AxisState::Holding:
            return Text::tr("HOLDING", "axis state");
        case AxisState::Moving:
            return Text::tr("MOVING", "axis state");
        case AxisState::Limit:
            return Text::tr("LIMIT", "axis state");
        case AxisState::Stopped:
            return Text::tr("STOPPED", "axis state");
        case AxisState::Fault:
            return Text::tr("FAULT", "axis state");
        case AxisState::On:
            return Text::tr("ON", "axis state");
        case AxisState::Off:
            return Text::tr("OFF", "axis state");
        case AxisState::Missing:
            return Text::tr("NONE", "axis state");
    }
    return {};
}

QString sourceText(const QString& source)
{
    for (const char* const known : kSources) {
        if (source == QLatin1String(known)) {
            return Text::tr(known);
        }
    }
    return source;
}

}  // namespace boresight
