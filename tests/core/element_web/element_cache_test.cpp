// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/element_web/element_cache.h"

#include <QFile>
#include <QTemporaryDir>

#include <gmock/gmock.h>

namespace boresight::orbit {
namespace {

class ElementCacheTest : public testing::Test
{
protected:
    void writeState(const QByteArray& bytes) const
    {
        QFile file(cache.fileOf(address) + QStringLiteral(".state"));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(bytes);
    }

    QTemporaryDir folder;
    ElementCache cache{folder.filePath(QStringLiteral("new/elements"))};
    ElementAddress address = *parseElementAddress("celestrak:weather");
};

// REQ-ELEMENTWEB-02: The cache has a file for each address, with the data for the next request. A broken file counts as
// if nothing had been downloaded.
TEST_F(ElementCacheTest, WhatIsKeptComesBack)
{
    EXPECT_EQ(cache.state(address), CacheState{});
    const CacheState state{.etag = "\"a1\"",
                           .lastModified = "Thu, 26 Nov 2026 14:02:00 GMT",
                           .lastTry = UtcTime(std::chrono::seconds(1'800'000'000)),
                           .fetched = UtcTime(std::chrono::seconds(1'790'000'000)),
                           .failures = 2,
                           .problem = QStringLiteral("The server answers 500.")};
    ASSERT_TRUE(cache.keepContent(address, "sets"));
    ASSERT_TRUE(cache.keepState(address, state));
    EXPECT_EQ(cache.state(address), state);
    EXPECT_EQ(cache.state(*parseElementAddress("celestrak:stations")), CacheState{}) << "each has its own";
}

// REQ-ELEMENTWEB-02
TEST_F(ElementCacheTest, WithoutTheElementsTheQuestionHasNoCondition)
{
    ASSERT_TRUE(cache.keepState(address, {.etag = "\"a1\"",
                                          .lastTry = UtcTime(std::chrono::seconds(1'800'000'000)),
                                          .fetched = UtcTime(std::chrono::seconds(1'790'000'000))}));
    const CacheState state = cache.state(address);
    EXPECT_TRUE(state.etag.isEmpty());
    EXPECT_FALSE(state.fetched);
    EXPECT_TRUE(state.lastTry);
}

// REQ-ELEMENTWEB-02
TEST_F(ElementCacheTest, ABrokenStateIsNone)
{
    ASSERT_TRUE(cache.keepContent(address, "sets"));
    for (const char* const broken : {"", "{", "[1]", R"({"last_try": "x", "failures": -3, "etag": "a\r\nHost: b"})",
                                     R"({"last_try": 1e300, "fetched": -1, "etag": 5})"}) {
        writeState(broken);
        const CacheState state = cache.state(address);
        EXPECT_TRUE(state.etag.isEmpty()) << broken;
        EXPECT_FALSE(state.lastTry) << broken;
        EXPECT_EQ(state.failures, 0) << broken;
        EXPECT_TRUE(state.fetched) << "by the time of the file";
    }
}

// Story: random state files of tests/fuzz/cache. A time beyond 2262 became one before 1970, and control characters
// appeared in a request and on the screen.
// REQ-ELEMENTWEB-02
TEST_F(ElementCacheTest, WhatIsSentOrShownHasNoControlCharacters)
{
    ASSERT_TRUE(cache.keepContent(address, "sets"));
    writeState(R"({"etag": "a\u0000b", "last_modified": "\u001b[31m", "problem": "No.\u001b[2J"})");
    const CacheState state = cache.state(address);
    EXPECT_TRUE(state.etag.isEmpty());
    EXPECT_TRUE(state.lastModified.isEmpty());
    EXPECT_TRUE(state.problem.isEmpty());
    writeState(R"({"problem": ")" + QByteArray(5000, 'x') + R"("})");
    EXPECT_TRUE(cache.state(address).problem.isEmpty()) << "a sentence is shorter";
}

// REQ-ELEMENTWEB-02
TEST_F(ElementCacheTest, ATimeBeyondOurClockIsNone)
{
    ASSERT_TRUE(cache.keepContent(address, "sets"));
    writeState(R"({"last_try": 9999999999, "fetched": 9999999999})");
    const CacheState state = cache.state(address);
    EXPECT_FALSE(state.lastTry);
    EXPECT_GT(state.fetched, UtcTime()) << "by the time of the file";
}

}  // namespace
}  // namespace boresight::orbit
