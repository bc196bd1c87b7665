// SPDX-License-Identifier: GPL-3.0-or-later
// The part of StationControl for what is done to the drives themselves: turns, proof, switching off, leaving the bus.
#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/control/station_control.h"

namespace boresight {
namespace {

// Fast enough to be told from standing, slow enough to harm nothing.
constexpr AngularRate kSlowestProof = AngularRate::fromDegrees(0.5);
constexpr AngularRate kFastestProof = AngularRate::fromDegrees(5.0);

}  // namespace

Result<> StationControl::handle(const request::ReadDrives&, const Source& source)
{
    return operatorOnly(source).and_then([this] { return gates().mayReadDrives(); });
}

Result<> StationControl::handle(const request::FixDrives&, const Source& source)
{
    return operatorOnly(source).and_then([this] { return gates().mayFixDrives(); }).map([&] {
        takeOver(source);  // else the next target of a client would switch them on in the middle of it
    });
}

Result<> StationControl::handle(const request::SwitchOff&, const Source& source)
{
    return operatorOnly(source).and_then([this] { return gates().maySwitchOff(); }).map([&] {
        takeOver(source);  // else the next target of a client would switch them on again
        holdHere(Activity::None);
        for (const Axis axis : kAxes) {
            m_drives.drive(axis).release();
        }
        m_log.add(Severity::Warning, source.name, Text::tr("switches both drives off: nothing holds the axes"));
    });
}

Result<> StationControl::handle(const request::ReleaseBus&, const Source& source)
{
    return operatorOnly(source).and_then([this] { return gates().drivesRest(); }).map([&] {
        m_arming.setReleased(true);
        takeOver(source);
        holdHere(Activity::None);
        for (const Axis axis : kAxes) {
            m_drives.drive(axis).listen();
            m_turns.forget(axis);
            learn(axis, std::nullopt);
        }
        m_log.add(Severity::Warning, source.name,
                  Text::tr("leaves the bus to other tools; drives that held go on by their time-out mode"));
    });
}

Result<> StationControl::handle(const request::TakeBus&, const Source& source)
{
    return operatorOnly(source).and_then([&]() -> Result<> {
        if (!m_arming.released()) {
            return failure(ErrorCode::Refused, Text::tr("the bus was not left to other tools"));
        }
        m_arming.setReleased(false);
        m_started = m_clock.now();  // the drives have had no question yet
        m_log.add(Severity::Advisory, source.name, Text::tr("takes the bus back: the drives are read anew"));
        return {};
    });
}

Result<> StationControl::handle(const request::ChooseTurn& wanted, const Source& source)
{
    return operatorOnly(source).and_then([this] { return gates().drivesRest(); }).and_then([&] {
        takeOver(source);
        return m_turns.choose(wanted.axis, wanted.angle, m_drives.drive(wanted.axis), source.name);
    });
}

Result<> StationControl::handle(const request::ProveCrashStop& wanted, const Source& source)
{
    if (const Result<> may = operatorOnly(source).and_then([&] { return gates().mayProve(source); }); !may) {
        return may;
    }
    const AngularRate rate = abs(wanted.rate);
    if (rate < kSlowestProof || rate > kFastestProof) {
        return failure(ErrorCode::OutOfRange, Text::tr("a crash stop is proven at %1 to %2°/s")
                                                  .arg(toQString(formatFixed(kSlowestProof.degrees(), 1)),
                                                       toQString(formatFixed(kFastestProof.degrees(), 1))));
    }
    const pointing::AxisBox here = pointing::AxisBox::at(*m_drives.measured());
    return CrashStopProof::prepare(rate, *m_drives.measured(), m_motion.region().azimuthsAround(here),
                                   m_motion.region().elevationsAround(here))
        .map([&](const CrashStopProof& proof) {
            begin(Activity::Proving, source, Text::tr("crash-stop proof at %1°/s").arg(rate.degrees(), 0, 'f', 1));
            m_proof.begin(proof);
        });
}

Result<> StationControl::handle(const request::EndProof&, const Source& source)
{
    if (!m_proof.running()) {
        return failure(ErrorCode::Refused, Text::tr("no proof is running"));
    }
    m_proof.end(Text::tr("ended by the %1").arg(Text::of(source.name.toStdString())));
    holdHere(Activity::Holding);
    return {};
}

}  // namespace boresight
