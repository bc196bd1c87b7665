// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/can/unusable_link.h"

#include <utility>

namespace boresight {

UnusableLink::UnusableLink(QString name, Error why, QObject* parent)
    : CanLink(parent), m_name(std::move(name)), m_why(std::move(why))
{}

LinkStatus UnusableLink::status() const
{
    return {.state = LinkState::Lost, .text = m_why.text};
}

Result<> UnusableLink::open()
{
    return tl::unexpected(m_why);
}

Result<> UnusableLink::send(std::span<const CanFrame>)
{
    return tl::unexpected(m_why);
}

}  // namespace boresight

#include "moc_unusable_link.cpp"
