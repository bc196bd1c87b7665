// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/outputs/named_output.h"

#include "core/base/text.h"
#include "core/outputs/output_maker.h"
#include "core/profile/output_settings.h"

#include <utility>

namespace boresight::outputs {

NamedOutput::NamedOutput(const profile::InForce& profile, NameIn nameIn, const QString& use, const Clock& clock,
                         QObject* parent)
    : QObject(parent),
      m_profile(profile),
      m_nameIn(nameIn),
      m_clock(clock),
      m_make([this, use](const contacts::OutputName& name) { return makeOutput(name, use, m_profile->mqtt, m_clock); })
{}

NamedOutput::~NamedOutput()
{
    close();
}

QString NamedOutput::name() const
{
    return toQString(m_nameIn(*m_profile));
}

void NamedOutput::open()
{
    m_open = true;
    begin();
}

void NamedOutput::close()
{
    m_open = false;
    retire();
}

bool NamedOutput::differs(const profile::Profile& before, const profile::Profile& after) const
{
    return profile::isAnotherOutput(m_nameIn(before), before.mqtt, m_nameIn(after), after.mqtt);
}

void NamedOutput::reopen()
{
    retire();
    begin();
}

void NamedOutput::begin()
{
    if (!m_open || m_output || m_former) {
        return;
    }
    m_output = m_make(contacts::parseOutput(m_nameIn(*m_profile)).value_or(contacts::OutputName{}));
    if (m_output) {
        connect(m_output.get(), &Output::reached, this, &NamedOutput::take);
        connect(m_output.get(), &Output::failed, this, &NamedOutput::fail);
        order(false);
    }
}

// Switches the output off and keeps it until it is off or has failed. The next output may need the same port or file,
// so it begins after that. Nothing waits here: a signal of the output reports its end.
void NamedOutput::retire()
{
    if (m_output) {
        m_former = std::move(m_output);
        m_retired = m_clock.now();
        m_former->disconnect(this);
        const auto letGo = [this, former = m_former.get()] {
            if (m_former.get() == former && former->isIdle()) {
                m_former.reset();
                begin();
            }
        };
        connect(m_former.get(), &Output::reached, this, letGo, Qt::QueuedConnection);
        connect(m_former.get(), &Output::failed, this, letGo, Qt::QueuedConnection);
        m_former->set(false);
    }
    m_order = {};
    m_isOn = false;
    m_problem.clear();
}

void NamedOutput::order(bool on)
{
    if (!m_output) {
        return;
    }
    const SteadyTime now = m_clock.now();
    const bool isDue = !m_order.at || now - *m_order.at >= kRepeat;
    if (on != m_order.on || isDue) {
        m_order = {.on = on,
                   .isReached = m_order.isReached && on == m_order.on,
                   .at = now,
                   .unanswered = m_order.unanswered.value_or(now)};
        m_output->set(on);
    }
    if (m_order.unanswered && now - *m_order.unanswered >= kPatience) {
        fail(Text::tr("no answer for %1 s").arg(kPatience.count()));
    }
}

void NamedOutput::take(bool on)
{
    m_isOn = on;
    m_order.unanswered.reset();
    m_order.isReached = on == m_order.on;
    if (m_order.isReached) {
        m_problem.clear();
    }
    Q_EMIT reached(on);
}

void NamedOutput::fail(const QString& reason)
{
    m_isOn = false;
    m_order.unanswered.reset();
    m_order.isReached = false;
    m_problem = reason;
    Q_EMIT failed(reason);
}

contacts::OutputAnswer NamedOutput::answer() const
{
    if (isAwaited() && m_clock.now() - m_retired >= kPatience) {
        return {.problem = Text::tr("the output before it has not answered for %1 s").arg(kPatience.count())};
    }
    return {.isOn = m_order.isReached ? std::optional(m_order.on) : std::nullopt, .problem = m_problem};
}

}  // namespace boresight::outputs

#include "moc_named_output.cpp"
