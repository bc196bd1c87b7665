// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

// The client's end of a TCP connection for tests: a plain socket which shows segments as they come. `pump` runs between
// looks; with a server on the same thread it turns the event loop, with one elsewhere it may sleep a millisecond.
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
    // Sends all of it unless the server closes; gives up when nothing moves for `patience`.
    bool send(std::string_view bytes, std::chrono::milliseconds patience = std::chrono::seconds(30));
    void endSending();
    void reset();  // closes with RST
    // Reads until `enough` likes what has come and then nothing for `quiet`; at most `patience` for the first part, and
    // many looks.
    std::string receive(const Enough& enough, std::chrono::milliseconds quiet, std::chrono::milliseconds patience);
    std::string receiveLines(int count);  // until so many line feeds have come
    // One command, and its reply of so many lines, or of the one line that refuses it.
    std::string ask(std::string_view command, int lines = 1);
    std::string receiveUntilClosed(std::chrono::milliseconds patience = std::chrono::seconds(5));
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
