// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/rotctld/server.h"
#include "core/rotctld/session.h"
#include "tests/fakes/dummy_rotator.h"
#include "tests/fakes/manual_clock.h"
#include "tests/fakes/rotctld_case_runner.h"
#include "tests/fakes/tcp_peer.h"

#include <QCoreApplication>

#include <memory>

namespace boresight::rotctld {

// A server on a free loopback port with the dummy behind it and a clock that the test turns. Everything runs on the
// test's thread. The pump of a peer runs the event loop once.
struct ServerFixture
{
    explicit ServerFixture(ServerSettings settings = {}, DumpStateForm form = DumpStateForm::OldAndNew)
    {
        settings.port = 0;
        server = std::make_unique<Server>(settings, talkRotctld(rotator, clock, form), rotator, clock);
        listening = server->listen().has_value();
    }

    [[nodiscard]] std::unique_ptr<fakes::TcpPeer> connect() const
    {
        return std::make_unique<fakes::TcpPeer>("127.0.0.1", server->port(), &ServerFixture::turn);
    }
    // Exactly one pass of the event loop. QTest::qWait(0) makes as many passes as fit into a millisecond, so the result
    // of a test of the server's budgets would depend on the computer.
    static void turn() { QCoreApplication::processEvents(QEventLoop::AllEvents); }
    void elapse(std::chrono::milliseconds time)
    {
        clock.advance(time);
        server->housekeep();
        turn();
    }
    [[nodiscard]] fakes::CaseTarget target()
    {
        return {.host = "127.0.0.1",
                .port = server->port(),
                .pump = &ServerFixture::turn,
                .elapse = [this](std::chrono::milliseconds time) { elapse(time); },
                .patience = std::chrono::milliseconds(100)};
    }
    [[nodiscard]] std::string goneReason() const
    {
        return rotator.gone.empty() ? std::string() : rotator.gone.rbegin()->second;
    }

    fakes::ManualClock clock;
    fakes::DummyRotator rotator{clock};
    std::unique_ptr<Server> server;
    bool listening = false;
};

}  // namespace boresight::rotctld
