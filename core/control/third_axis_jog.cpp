// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/control/third_axis_jog.h"

#include "core/base/text.h"
#include "core/motion/motion.h"
#include "core/tracking/emergency_braking.h"
#include "core/units/degrees_text.h"

namespace boresight {
namespace {

const QString kThirdAxis = QStringLiteral("third axis");

}  // namespace

Result<> ThirdAxisJog::mayMove() const
{
    const ThirdAxis* const axis = m_of.mount.thirdAxis();
    if (axis == nullptr) {
        return failure(ErrorCode::NotAvailable,
                       Text::tr("This mount has no third axis. To use one, enter its board in the profile "
                                "(third_axis.id)."));
    }
    return m_of.arming.isReady().and_then([&] { return axis->fit(); });
}

Result<> ThirdAxisJog::mayJog(AngularRate rate) const
{
    return mayMove().and_then([&]() -> Result<> {
        if (abs(rate) > limits().speed) {
            return failure(ErrorCode::OutOfRange, Text::tr("The rate is above the limit of the third axis (%1°/s).")
                                                      .arg(limits().speed.degrees(), 0, 'f', 1));
        }
        const Angle place = *m_of.mount.thirdAxis()->place();
        const bool isUpwards = rate > AngularRate{};
        const Angle end = isUpwards ? travel().max : travel().min;
        if (isUpwards ? place > end - kAtEdge : place < end + kAtEdge) {
            return failure(ErrorCode::OutOfRange,
                           Text::tr("The third axis is at the end of its travel (%1).").arg(degreesText(end, 1)));
        }
        return {};
    });
}

Result<> ThirdAxisJog::ask(const request::JogThirdAxis& wanted, const Source& by)
{
    if (Result<> may = operatorOnly(by); !may) {
        return may;
    }
    if (wanted.rate == AngularRate{}) {
        m_rate = {};
        m_needsRelease = false;
        return {};
    }
    if (Result<> may = mayJog(wanted.rate); !may) {
        if (m_rate != AngularRate{}) {
            end(may.error().text);
        }
        m_needsRelease = true;  // the same press must not move the axis later
        return may;
    }
    if (m_needsRelease) {
        return failure(ErrorCode::Refused,
                       Text::tr("The jog of the third axis was ended. Release the button and press it again."));
    }
    begin(wanted.rate, by);
    return {};
}

void ThirdAxisJog::begin(AngularRate rate, const Source& by)
{
    if (m_rate == AngularRate{}) {
        m_of.log.add(Severity::Advisory, by.name,
                     Text::tr("jogs the third axis (%1)").arg(toQString(m_of.profile->thirdAxis.name)));
    }
    m_rate = rate;
    m_deadline = m_now + kJogKeepAlive;
    if (!m_of.mount.thirdAxis()->follows()) {
        m_of.mount.thirdAxis()->engage();
    }
}

void ThirdAxisJog::end(const QString& why)
{
    m_rate = {};
    m_needsRelease = true;
    m_of.log.add(Severity::Warning, kThirdAxis, Text::tr("the jog ends: %1").arg(why));
}

// Each of these ends a jog whose button is still held.
void ThirdAxisJog::watch(ThirdAxis& axis)
{
    const auto loss = axis.takeLoss();
    if (m_rate == AngularRate{}) {
        if (loss) {
            m_of.log.add(Severity::Warning, kThirdAxis, Text::tr("is not held any more: %1").arg(*loss));
        }
        return;
    }
    if (loss) {
        end(*loss);
    } else if (const Result<> may = mayMove(); !may) {
        end(may.error().text);
    } else if (m_now > m_deadline) {
        end(Text::tr("its keep-alive did not come"));
    }
}

void ThirdAxisJog::step(Seconds dt, SteadyTime now)
{
    m_now = now;
    ThirdAxis* const axis = m_of.mount.thirdAxis();
    if (axis == nullptr) {
        return;
    }
    watch(*axis);
    const bool stop = m_of.arming.stopLatched();
    if (stop && m_of.mount.available() && !m_of.arming.closing()) {
        axis->seize();
    }
    if (const auto place = axis->takeFollowing()) {
        m_motion.emplace(limits(), travel(), *place);
    } else if (!axis->follows()) {
        m_motion.reset();
    }
    if (!m_motion) {
        return;
    }
    m_motion->setLimits(limits());
    m_motion->setTravel(travel());
    axis->brakeHard(stop);
    axis->command(stop ? m_motion->brake(dt, tracking::emergencyBraking(limits())) : m_motion->run(dt, m_rate));
}

bool ThirdAxisJog::recover(const Source& by)
{
    ThirdAxis* const axis = m_of.mount.thirdAxis();
    if (axis == nullptr || !axis->isFaulted()) {
        return false;
    }
    m_of.log.add(Severity::Advisory, by.name, Text::tr("re-arms the third axis, and nothing moves"));
    axis->recover();
    return true;
}

bool ThirdAxisJog::atRest() const
{
    const ThirdAxis* const axis = m_of.mount.thirdAxis();
    return axis == nullptr || !axis->underOrders() || (m_motion && m_motion->atRest());
}

void ThirdAxisJog::leave(profile::OnExit how)
{
    if (ThirdAxis* const axis = m_of.mount.thirdAxis(); axis != nullptr) {
        axis->leave(how);
    }
}

void ThirdAxisJog::describe(StationStatus& status) const
{
    const auto refuse = [&](Action action, AngularRate rate) {
        const Result<> may = mayJog(rate);
        status.permissions.refuse(action, may ? QString() : may.error().text);
    };
    refuse(Action::JogThirdAxisUp, limits().speed);
    refuse(Action::JogThirdAxisDown, -limits().speed);
    if (const ThirdAxis* const axis = m_of.mount.thirdAxis(); axis != nullptr) {
        status.thirdAxis = ThirdAxisStatus{
            .name = toQString(m_of.profile->thirdAxis.name), .travel = travel(), .fastest = limits().speed};
        axis->describe(*status.thirdAxis);
    }
}

}  // namespace boresight
