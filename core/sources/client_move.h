// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/control/motion_source.h"

// A client moves the mount at a rate until the client sends another command or disconnects. Station thread only.
namespace boresight::sources {

class ClientMove : public SourceOf<ClientMove, request::Move>
{
public:
    using SourceOf::SourceOf;

    Result<> ask(const request::Move& wanted, const Source& by);
    void gone(const Source& client) override;
};

}  // namespace boresight::sources
