// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/can/can_link.h"
#include "tests/fakes/pseudo_terminal.h"
#include "tests/fakes/wait_until.h"

#include <gtest/gtest.h>

namespace boresight::fakes {

inline const QByteArray kProbe = "can status\n";

// Answers as a healthy adapter behind the terminal: it replies to the single query of a link that was opened. After
// that the link sends frames.
inline void answerProbe(PseudoTerminal& terminal, const CanLink& link)
{
    ASSERT_TRUE(waitUntil([&] { return terminal.written == kProbe; })) << terminal.written.toStdString();
    terminal.takeWritten();
    // The first answer has arrived when it shows in the text of the link.
    terminal.write("lec=0 dlec=0 err=1 warn=1 busoff=0 pexc=0 tdc=0\r\n");
    ASSERT_TRUE(waitUntil([&] { return !link.status().text.isEmpty(); }));
    terminal.write("lec=0 dlec=0 err=0 warn=0 busoff=0 pexc=0 tdc=0\r\n");
    ASSERT_TRUE(waitUntil([&] { return link.status().text.isEmpty(); }));
}

}  // namespace boresight::fakes
