// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wind/wind_source.h"

#include <gtest/gtest.h>

namespace boresight::wind {
namespace {

// REQ-WIND-01: The readings arrive by UDP at a port of this computer (at 127.0.0.1 unless the profile names another
// address), from one topic of the broker, or from a page of a web server. Any other source is refused.
TEST(WindSource, IsAPortATopicOrAPage)
{
    EXPECT_EQ(parseSource(""), SourceName{});
    EXPECT_EQ(parseSource("udp:4541"),
              (SourceName{.kind = SourceKind::Udp, .place = QStringLiteral("127.0.0.1"), .port = 4541}));
    EXPECT_EQ(parseSource("udp:0.0.0.0:1"),
              (SourceName{.kind = SourceKind::Udp, .place = QStringLiteral("0.0.0.0"), .port = 1}));
    EXPECT_EQ(parseSource("mqtt:shack/wind"),
              (SourceName{.kind = SourceKind::Mqtt, .place = QStringLiteral("shack/wind")}));
    EXPECT_EQ(parseSource("http://10.0.0.5:8080/wind?unit=ms"),
              (SourceName{.kind = SourceKind::Page, .place = QStringLiteral("http://10.0.0.5:8080/wind?unit=ms")}));
    for (const char* const text :
         {"http://",        "http:///wind", "http://a b/", "ftp://a/b", "udp:",      "udp:0",    "udp:65536",
          "udp:shack:4541", "udp::4541",    "udp:45 41",   "mqtt:",     "mqtt:a/#",  "mqtt:+/b", "mqtt:$SYS/x",
          "tcp:4541",       "4541",         "none",        "udp",       " udp:4541", "mqtt:a\nb"}) {
        EXPECT_FALSE(parseSource(text)) << text;
    }
    EXPECT_FALSE(parseSource("mqtt:" + std::string(2000, 'x')));
}

}  // namespace
}  // namespace boresight::wind
