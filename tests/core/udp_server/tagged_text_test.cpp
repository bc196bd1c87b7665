// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/udp_server/tagged_text.h"

#include <gtest/gtest.h>

#include <string>

namespace boresight::udp {
namespace {

TEST(TaggedText, HasABodyBetweenItsEnds)
{
    EXPECT_EQ(bodyOf("<PST>AZ?</PST>", "PST"), "AZ?");
    EXPECT_EQ(bodyOf(" <PST></PST>\r\n", "PST"), "");
    EXPECT_EQ(bodyOf("<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<A> <b>1</b></A>", "A"), " <b>1</b>");
    EXPECT_EQ(bodyOf("<?XML VERSION=\"1.0\"?><A>1</A>", "A"), "1");
    for (const char* const text : {"", "PST", "<PST>", "<PST></PS>", "<PST>1</PST>2", "0<PST>1</PST>", "<PST/>",
                                   "<PST>1</pst>", "<?xml <PST>1</PST>"}) {
        EXPECT_FALSE(bodyOf(text, "PST")) << text;
    }
}

TEST(TaggedText, HasValues)
{
    EXPECT_EQ(valueOf("<stop><rotor>A B</rotor></stop>", "rotor"), "A B");
    EXPECT_EQ(valueOf("<a>1</a><a>2</a>", "a"), "1");
    EXPECT_FALSE(valueOf("<a>1", "a"));
    EXPECT_FALSE(valueOf("1</a>", "a"));
}

TEST(TaggedText, HasFieldsOneAfterTheOther)
{
    const auto fields = fieldsIn("\n  <a> 1 </a>\r\n\t<b></b>");
    ASSERT_TRUE(fields);
    ASSERT_EQ(fields->size(), 2U);
    EXPECT_EQ((*fields)[0].name, "a");
    EXPECT_EQ((*fields)[0].value, "1");
    EXPECT_EQ((*fields)[1].name, "b");
    EXPECT_EQ((*fields)[1].value, "");
    EXPECT_TRUE(fieldsIn(" ")->empty());
    for (const char* const body :
         {"1", "<a>1</a>2", "<a>1", "<a>1</b>", "<a><b>1</b></a>", "<a", "<a b=\"1\">1</a>", "<>1</", "<a>1</a><"}) {
        EXPECT_FALSE(fieldsIn(body)) << body;
    }
}

TEST(TaggedText, HasABoundedNumberOfFields)
{
    std::string body;
    for (std::size_t i = 0; i < kMostFields; ++i) {
        body += "<a>1</a>";
    }
    EXPECT_EQ(fieldsIn(body)->size(), kMostFields);
    EXPECT_FALSE(fieldsIn(body + "<a>1</a>"));
}

}  // namespace
}  // namespace boresight::udp
