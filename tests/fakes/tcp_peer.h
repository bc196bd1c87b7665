// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

// The client's end of a TCP connection for tests: a plain socket that shows the segments as they arrive. `pump` is
// called between two looks. It runs the event loop if the server is on the same thread, and may sleep for a millisecond
// if not.
namespace boresight::fakes {

class TcpPeer
{
public:
    using Pump = std::function<void()>;
    using Enough = std::function<bool(const std::string& received)>;

    TcpPeer(const std::string& host, std::uint16_t port, Pump pump);
    ~TcpPeer();
    TcpPeer(const TcpPeer&) = delete;
    TcpPeer& operator=(const TcpPeer&) = delete;

    [[nodiscard]] bool connected() const { return m_fd >= 0; }
    // Sends everything unless the server closes. Gives up when nothing is accepted for `patience`.
    bool send(std::string_view bytes, std::chrono::milliseconds patience = std::chrono::seconds(30));
    void endSending();
    void reset();  // closes with RST
    // Reads until `enough` accepts the received text and then nothing comes for `quiet`. The first part takes at most
    // `patience` and a minimum number of looks.
    std::string receive(const Enough& enough, std::chrono::milliseconds quiet, std::chrono::milliseconds patience);
    std::string receiveLines(int count);  // until this number of line feeds has arrived
    // Sends one command. Returns its reply of `lines` lines, or the single line that refuses it.
    std::string ask(std::string_view command, int lines = 1);
    std::string receiveUntilClosed(std::chrono::milliseconds patience = std::chrono::minutes(1));
    [[nodiscard]] bool closedByServer();                                                   // looks without waiting long
    [[nodiscard]] const std::vector<std::size_t>& segments() const { return m_segments; }  // sizes of all reads

private:
    bool readSome(std::string& into);

    Pump m_pump;
    int m_fd = -1;
    bool m_closed = false;
    std::vector<std::size_t> m_segments;
};

}  // namespace boresight::fakes
