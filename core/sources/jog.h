// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/control/motion_source.h"

// A held button moves the mount at a rate. The motion ends when the button is released or its keep-alive is missing.
// Station thread only.
namespace boresight::sources {

class Jog : public SourceOf<Jog, request::Jog>
{
public:
    using SourceOf::SourceOf;

    Result<> ask(const request::Jog& wanted, const Source& by);
    void step(SteadyTime now) override;

private:
    SteadyTime m_deadline{};  // the next keep-alive must arrive before it, while a jog runs
};

}  // namespace boresight::sources
