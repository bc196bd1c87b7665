// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/can/can_link.h"
#include "tests/fakes/pseudo_terminal.h"
#include "tests/fakes/wait_until.h"

#include <gtest/gtest.h>

namespace boresight::fakes {

inline const QByteArray kProbe = "can status\n";

// A healthy adapter behind the terminal answers the one question of an opened link. The link sends frames afterwards.
inline void answerProbe(PseudoTerminal& terminal, const CanLink& link)
{
    ASSERT_TRUE(waitUntil([&] { return terminal.written == kProbe; })) << terminal.written.toStdString();
    terminal.takeWritten();
    // The first answer shows in the text of the link: then it has arrived.
    terminal.write("lec=0 dlec=0 err=1 warn=1 busoff=0 pexc=0 tdc=0\r\n");
    ASSERT_TRUE(waitUntil([&] { return !link.status().text.isEmpty(); }));
    terminal.write("lec=0 dlec=0 err=0 warn=0 busoff=0 pexc=0 tdc=0\r\n");
    ASSERT_TRUE(waitUntil([&] { return link.status().text.isEmpty(); }));
}

}  // namespace boresight::fakes
