// SPDX-License-Identifier: GPL-3.0-or-later
// REQ-ELEMENTWEB-952 (Fuzz.cache): Whatever the state file of the downloaded elements contains, the values read from it
// are in range: headers of one line, a short printable problem, valid times and numbers of failures. Written and read
// again they are the same.
#include "core/base/control_characters.h"
#include "core/element_web/element_cache.h"
#include "tests/fuzz/harness.h"
#include "tests/fuzz/memory_folder.h"

#include <QFile>
#include <QTemporaryDir>

namespace boresight::fuzz {
namespace {

using namespace boresight::orbit;

void write(const QString& path, const QByteArray& bytes)
{
    QFile file(path);
    require(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size(), "the test can write");
}

// With a file of elements and without one.
class Cache
{
public:
    Cache() { write(m_cache.fileOf(m_downloaded), "elements"); }

    void take(const QByteArray& bytes)
    {
        for (const ElementAddress& address : {m_downloaded, m_empty}) {
            write(m_cache.fileOf(address) + QStringLiteral(".state"), bytes);
            const CacheState state = m_cache.state(address);
            check(state);
            require(m_cache.keepState(address, state).has_value(), "it can be written");
            require(m_cache.state(address) == state, "it reads back as it was");
            if (!state.etag.isEmpty() || !state.problem.isEmpty()) {
                accept();
            }
        }
    }

private:
    static void check(const CacheState& state)
    {
        for (const QByteArray& header : {state.etag, state.lastModified}) {
            require(!hasControlCharacters(header.toStdString()) && header.size() <= 500, "a header is one short line");
        }
        require(!hasControlCharacters(state.problem.toStdString()), "a problem is one printable line");
        require(state.problem.size() < 800, "a problem is short");
        require(state.failures >= 0 && state.failures <= 1000, "so many failures are possible");
        const UtcTime first{};
        require(!state.lastTry || *state.lastTry > first, "a server was asked after 1970");
        require(!state.fetched || *state.fetched > first, "elements came after 1970");
    }

    QTemporaryDir m_folder{memoryFolder(QStringLiteral("fuzz_cache"))};
    ElementCache m_cache{m_folder.path()};
    ElementAddress m_downloaded = *parseElementAddress("https://elements.example/a");
    ElementAddress m_empty = *parseElementAddress("https://elements.example/b");
};

}  // namespace

Grammar grammar()
{
    Grammar grammar;
    grammar.corpus = {
        R"({"etag":"\"one\"","failures":0,"fetched":1795000000,"last_modified":"Sat, 21 Nov 2026 00:00:00 GMT",)"
        R"("last_try":1795000000,"problem":""})",
        R"({"etag":"","failures":3,"fetched":null,"last_modified":"","last_try":1795003600,)"
        R"("problem":"The server answers 403 Forbidden. The server sent: \"Too many questions\"."})"};
    grammar.tokens = {"\"etag\"",     "\"last_modified\"",
                      "\"last_try\"", "\"fetched\"",
                      "\"failures\"", "\"problem\"",
                      "null",         "true",
                      "[]",           "{}",
                      "-1",           "0",
                      "1e308",        "9999999999",
                      "10000000000",  "9223372036854775807",
                      "0.5",          "\\n",
                      "\\r",          "\\u0000",
                      "\\u001b[31m",  "\\u202e",
                      "\\ud800",      "\"",
                      "\\\"",         "\xff"};
    grammar.separators = "{},:\"";
    grammar.maxLength = 4096;
    grammar.persistence = 40;
    return grammar;
}

void feed(std::span<const std::uint8_t> input)
{
    static Cache cache;
    const std::string_view text = asText(input);
    cache.take(QByteArray(text.data(), static_cast<qsizetype>(text.size())));
}

}  // namespace boresight::fuzz
