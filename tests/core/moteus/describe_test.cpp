// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus/describe.h"

#include "tests/core/moteus/golden.h"

#include <gtest/gtest.h>

namespace boresight::moteus {
namespace {

std::string words(std::uint32_t id, const char* hex)
{
    return describe(golden::frame(id, golden::bytes(QString::fromLatin1(hex))));
}

TEST(MoteusDescribe, SpellsOutARequest)
{
    EXPECT_EQ(words(0x8001, "01000a06200000808011005050"),
              "request from 0 to drive 1, wants a reply\n"
              "write 0x000 mode 10 position (i8)\n"
              "write 0x020 commanded position 0 rev (i16)\n"
              "write 0x021 commanded velocity -8.16 rev/s (i16)\n"
              "read 0x000 mode as i8\n"
              "padding 2\n");
}

TEST(MoteusDescribe, SpellsOutAReply)
{
    EXPECT_EQ(words(0x100, "2100012d010000803e210f22210c01210b002502008030010231090150"),
              "reply of drive 1 to 0\n"
              "reply 0x000 mode 1 fault (i8)\n"
              "reply 0x001 position 0.25 rev (f32)\n"
              "reply 0x00f fault 34 over voltage (i8)\n"
              "reply 0x00c home state 1 referenced within one rotor turn (i8)\n"
              "reply 0x00b trajectory complete 0 no (i8)\n"
              "reply 0x002 velocity unset (i16)\n"
              "write error 0x001 position: code 2 (not writable)\n"
              "read error 0x009 unknown register 0x9: code 1 (unknown, not accessible or not in that format)\n"
              "padding 1\n");
}

TEST(MoteusDescribe, ShowsIdentityAsBitsAndTextAsText)
{
    EXPECT_EQ(words(0x200, "29d00298badcfe43010d044f4b0d0a4101020122"),
              "reply of drive 2 to 0\n"
              "reply 0x150 UUID 1 0xfedcba98 (i32)\n"
              "tunnel 1 to host, packet 13: \"OK\\r\\n\"\n"
              "tunnel 1 to host: \"\\x01\\\"\"\n");
    EXPECT_EQ(words(0x9002, "4001026f0a440105304201275050"),
              "request from 16 to drive 2, wants a reply\n"
              "tunnel 1 to drive: \"o\\n\"\n"
              "poll tunnel 1, packet 5 seen, at most 48 bytes\n"
              "poll tunnel 1, at most 39 bytes\n"
              "padding 2\n");
}

// Found by the fuzzer: identity registers exist as i32 only, but a damaged frame may contain any type.
TEST(MoteusDescribe, IdentityAsAnythingElseIsAPlainNumber)
{
    EXPECT_EQ(words(0x100, "2dd00200003b7c"), "reply of drive 1 to 0\nreply 0x150 UUID 1 3.88383805e+36 (f32)\n");
}

TEST(MoteusDescribe, SaysWhoSpeaksToWhom)
{
    EXPECT_EQ(words(0x1002, "400100"), "request from 16 to drive 2, no reply wanted\ntunnel 1 to drive: \"\"\n");
    EXPECT_EQ(words(0x7f, ""), "request from 0 to every drive, no reply wanted\n");
    EXPECT_EQ(words(0x264, ""), "reply of drive 2 to 100\n");
    EXPECT_EQ(words(0x19748001, "50"), "request from 0 to drive 1, wants a reply, prefix 0x1974\npadding 1\n");
}

TEST(MoteusDescribe, SaysWhatCannotBeRead)
{
    EXPECT_EQ(words(0x100, "2d0100"), "reply of drive 1 to 0\nthe last subframe is cut off\n");
    EXPECT_EQ(words(0x100, "60"), "reply of drive 1 to 0\nunknown subframe: the rest cannot be read\n");
    EXPECT_EQ(words(0x8001, "1cffffffff0f00"),
              "request from 0 to drive 1, wants a reply\n"
              "read 4294967295 registers from 0x000 mode as f32: more than a reply can hold\n");
}

}  // namespace
}  // namespace boresight::moteus
