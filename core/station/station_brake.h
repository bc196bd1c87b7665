// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/text.h"
#include "core/control/station_control.h"
#include "core/mount/mount_connection.h"
#include "core/outputs/missing_output.h"
#include "core/outputs/named_output.h"
#include "core/outputs/output_maker.h"
#include "core/outputs/simulated_output.h"
#include "core/profile/in_force.h"

#include <utility>

// The output of the brakes of the axes, between the control and the profile. With a simulated mount nothing real is
// switched. A pin of a board of the mount is switched by the mount, which may be simulated. Station thread.
namespace boresight {

class StationBrake
{
public:
    // All arguments but the parent outlive this.
    StationBrake(const profile::InForce& profile, StationControl& control, MountConnection& mount, const Clock& clock,
                 QObject* parent)
        : m_control(control),
          m_output(
              profile, [](const profile::Profile& named) -> const std::string& { return named.brake.output; }, kUse,
              clock, parent)
    {
        m_output.setMaker([&profile, &mount, &clock](const contacts::OutputName& name) {
            if (name.kind == contacts::OutputKind::Pin) {
                return outputOf(mount, name.pin);
            }
            return mount.simulated() ? outputs::simulatedOutput(name)  // no drive holds the real antenna
                                     : outputs::makeOutput(name, kUse, profile->mqtt, clock);
        });
    }

    // Replaces how the output is made. Call before open().
    void setMaker(outputs::NamedOutput::Make make) { m_output.setMaker(std::move(make)); }
    void open() { m_output.open(); }
    void close() { m_output.close(); }
    // Before each tick of the control: passes the answer of the output on.
    void tellAnswer() { m_control.takeBrake(m_output.answer()); }
    // After the tick: switches the output as the control wants it. An output that fails is not switched on again,
    // because that may open and close a brake while the antenna stops.
    void obey()
    {
        if (!m_control.releasesBrake() || m_output.answer().problem.isEmpty()) {
            m_output.order(m_control.releasesBrake());
        }
    }
    void profileChanged(const profile::Profile& before, const profile::Profile& after)
    {
        if (m_output.differs(before, after)) {
            m_output.reopen();
        }
    }

private:
    static inline const QString kUse = QStringLiteral("brake");

    [[nodiscard]] static std::unique_ptr<outputs::Output> outputOf(MountConnection& mount,
                                                                   const contacts::BoardPin& pin)
    {
        auto output = mount.pinOutput(pin);
        return output ? std::move(output)
                      : std::make_unique<outputs::MissingOutput>(Text::tr("this mount has no such pins"));
    }

    StationControl& m_control;
    outputs::NamedOutput m_output;
};

}  // namespace boresight
