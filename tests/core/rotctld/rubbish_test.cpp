// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/rotctld/server_fixture.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

// Data that is not meant for a rotator must neither move nor stop the mount, complete or cut into packets.
namespace boresight::rotctld {
namespace {

using namespace std::string_literals;

struct Rubbish
{
    const char* name;
    std::string bytes;
    bool recognised;  // by the first line
};

const std::vector<Rubbish>& corpus()
{
    static const std::vector<Rubbish> all{
        {"Browser",
         "GET / HTTP/1.1\r\nHost: 127.0.0.1:4533\r\nUser-Agent: Mozilla/5.0 (X11; Linux x86_64) AppleWebKit/537.36 "
         "(KHTML, "
         "like Gecko) Chrome/120.0 Safari/537.36\r\nUpgrade-Insecure-Requests: 1\r\nSec-Fetch-Mode: navigate\r\n\r\n",
         true},
        {"BrowserPost", "POST / HTTP/1.1\r\nHost: x\r\nContent-Type: text/plain\r\n\r\nP 120 30\nK\nS\nM UP 50\n",
         true},
        {"Headers", "User-Agent: Mozilla/5.0 (KHTML, like Gecko)\r\nK \r\nS \r\n", true},
        {"Http2", "PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n", true},
        {"Rtsp", "OPTIONS / RTSP/1.0\r\n\r\nSETUP rtsp://x RTSP/1.0\r\n", true},
        {"Delete", "DELETE / HTTP/1.1\r\n\r\nS \r\n", true},
        {"Tls", "\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03\nS \nK \n"s, true},
        {"Ssh", "SSH-2.0-OpenSSH_9.2p1 Debian-2\r\nS \r\nK \r\n", true},
        {"Easycomm", "AZ EL \n", true},
        {"EasycommPoint", "AZ120.0 EL45.0 UP145000000 UUSB DN435000000 DUSB\nSA SE\nML\nMU\n", true},
        {"EasycommStop", "SA SE\n", true},
        {"Gs232", "C2\rW120 045\rM180\rS\rR\r", true},
        {"Gs232Point", "W000 000\n", true},
        {"Gs232Turn", "M180\rL\rS\r", true},
        {"Mail", "EHLO scanner\r\nMAIL FROM:<a@b>\r\nRCPT TO:<K@S>\r\n", true},
        {"Memcached", "STATS\r\nSTATS items\r\nKILL 1\r\n", false},
        {"Irc", "NICK a\r\nUSER a b c d\r\nKICK #a b\r\nPING 1\r\nPART #a\r\n", false},
        {"Telescope", ":GA#:GR#:Sr12:00:00#:MS#:Q#", false},
        {"Rdp", "\x03\x00\x00\x13\x0e\xe0\x00\x00\x00\x00\x00\x01\x00\x08\x00\x03\x00\x00\x00"s, true},
        {"Smb", "\x00\x00\x00\xa4\xffSMBr\x00\x00\x00\x00\x08\x01@\x00\x00K \x00S \x00"s, false},
        {"Json", "{\"jsonrpc\": \"2.0\", \"method\": \"P 10 5\", \"K\": 1, \"S\": 2}\n", false},
        {"Prose", "Kings Stop at Park; Move Up Please\nPlease Stop\nKeep going\n", false},
        {"Xml", "<?xml version=\"1.0\"?><PST><AZIMUTH>85</AZIMUTH><STOP>1</STOP><PARK>1</PARK></PST>\n", false},
        {"Rot2Prog", "W0000000000\x1f W3360600606\x0f S"s, true},
    };
    return all;
}

class RotctldRubbish : public ::testing::TestWithParam<Rubbish>
{};

// REQ-ROTCTLD-03 (RotctldRubbish.*): Nothing that a browser, a port scanner or a program with a foreign protocol sends
// moves or stops the mount.
TEST_P(RotctldRubbish, MovesNothing)
{
    for (const std::size_t piece : {std::size_t{100'000}, std::size_t{50}, std::size_t{7}, std::size_t{2}}) {
        ServerFixture fixture;
        const auto peer = fixture.connect();
        std::string_view rest = GetParam().bytes;
        while (!rest.empty() && peer->send(rest.substr(0, piece))) {
            rest.remove_prefix(std::min(piece, rest.size()));
            ServerFixture::turn();
            ServerFixture::turn();
        }
        peer->endSending();
        peer->receiveUntilClosed();
        EXPECT_EQ(fixture.rotator.actions, 0) << "in pieces of " << piece;
        if (GetParam().recognised && piece > GetParam().bytes.size()) {
            EXPECT_EQ(fixture.goneReason().substr(0, 23), "is not a rotctld client");
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Corpus, RotctldRubbish, ::testing::ValuesIn(corpus()),
                         [](const auto& rubbish) { return rubbish.param.name; });

struct SessionRun
{
    fakes::ManualClock clock;
    fakes::DummyRotator rotator{clock};
    Session session{{.id = 1, .address = "test"}, rotator, clock, DumpStateForm::OldAndNew};

    std::string feed(std::string_view bytes)
    {
        session.receive(bytes);
        std::string replies;
        while (session.step(replies)) {
        }
        return replies;
    }
};

TEST(RotctldRubbishFuzz, RandomBytesMoveNothing)
{
    std::mt19937 random(20261121);
    std::uniform_int_distribution<int> byte(0, 255);
    for (int round = 0; round < 2000; ++round) {
        SessionRun run;
        std::string bytes(2000, ' ');
        for (char& character : bytes) {
            character = static_cast<char>(byte(random));
        }
        run.feed(bytes);
        ASSERT_EQ(run.rotator.actions, 0) << "round " << round;
        ASSERT_FALSE(run.session.ending().isEmpty()) << "round " << round;
    }
}

// Damaged commands may or may not be understood. What reaches the rotator is always finite, and replies keep their
// form.
TEST(RotctldRubbishFuzz, DamagedCommandsStayHarmless)
{
    std::mt19937 random(4533);
    const std::string good =
        "p\nP 228.91 44.30\n+\\set_pos 12 7\n|\\get_pos\n;P 1,5 2\nM 8 50\n\\dump_state\nL 10 50 6\nV SPEED "
        "2\n??\nK\nS\n1\n";
    const std::string spice =
        "\n\r\t #+;|\\?\xff\x00"
        "0-.,eEnaifxPpKSM"s;
    for (int round = 0; round < 20000; ++round) {
        SessionRun run;
        std::string bytes = good;
        for (int damage = 0; damage < 4; ++damage) {
            const std::size_t at = random() % bytes.size();
            const char replacement = spice[random() % spice.size()];
            switch (random() % 3) {
                case 0:
                    bytes[at] = replacement;
                    break;
                case 1:
                    bytes.insert(at, 1, replacement);
                    break;
                default:
                    bytes.erase(at, 1 + random() % 3);
            }
        }
        const std::string replies = run.feed(bytes);
        ASSERT_TRUE(replies.empty() || replies.back() == '\n') << bytes;
        ASSERT_LT(replies.size(), 20'000U) << bytes;
        if (const auto request = run.rotator.lastRequest) {
            ASSERT_TRUE(request->azimuth.isFinite() && abs(request->elevation) <= 180_deg) << bytes;
        }
    }
}

}  // namespace
}  // namespace boresight::rotctld
