// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/answer_grammar.h"

#include <string>

namespace boresight::fuzz {
namespace {

const std::string kSet =
    R"({"OBJECT_NAME":"MADE UP","OBJECT_ID":"2026-001A","EPOCH":"2026-11-20T12:00:00","MEAN_MOTION":15.5,)"
    R"("ECCENTRICITY":0.001,"INCLINATION":51.6,"RA_OF_ASC_NODE":100,"ARG_OF_PERICENTER":90,"MEAN_ANOMALY":270,)"
    R"("EPHEMERIS_TYPE":0,"NORAD_CAT_ID":90001,"BSTAR":2e-5})";

std::string answerText(const std::string& status, const std::string& headers, const std::string& content)
{
    return "HTTP/1.1 " + status + "\r\nContent-Length: " + std::to_string(content.size()) + "\r\n" + headers + "\r\n" +
           content;
}

}  // namespace

Grammar answerGrammar()
{
    Grammar grammar;
    const std::string two = "[" + kSet + "]";
    grammar.corpus = {answerText("200 OK", "ETag: \"one\"\r\nLast-Modified: Sat, 21 Nov 2026 00:00:00 GMT\r\n", two),
                      answerText("200 OK", "Content-Type: text/plain\r\n",
                                 "ISS\n1 25544U 98067A   24130.36689744  .00016024  00000+0  27777-3 0  9992\n"
                                 "2 25544  51.6381 147.8590 0003466 150.4670 338.5502 15.51043222452521\n"),
                      "HTTP/1.0 200 OK\r\n\r\n" + two,
                      "HTTP/1.1 200 OK\r\nTransfer-Encoding: chunked\r\n\r\n2\r\n[\n\r\n0\r\n\r\n",
                      "HTTP/1.1 304 Not Modified\r\n\r\n",
                      answerText("302 Found", "Location: /a\r\n", {}),
                      answerText("403 Forbidden", "Content-Type: text/plain\r\n", "Too many questions\n")};
    grammar.tokens = {"HTTP/1.1 ",
                      "200 OK",
                      "304",
                      "401 Unauthorized",
                      "407",
                      "100 Continue\r\n\r\n",
                      "\r\n",
                      "\r\n\r\n",
                      "Content-Length: ",
                      "Content-Length: 99999999999\r\n",
                      "Content-Length: -1\r\n",
                      "Transfer-Encoding: chunked\r\n",
                      "Content-Encoding: gzip\r\n",
                      "Content-Encoding: deflate\r\n",
                      "Location: /a\r\n",
                      "Location: http://127.0.0.1:1/\r\n",
                      "Location: file:///etc/hostname\r\n",
                      "WWW-Authenticate: Basic realm=\"x\"\r\n",
                      "Proxy-Authenticate: NTLM\r\n",
                      "Set-Cookie: a=b\r\n",
                      "Connection: keep-alive\r\n",
                      "Upgrade: h2c\r\n",
                      "ffffffff\r\n",
                      "0\r\n\r\n",
                      "ETag: \"\x01\"\r\n",
                      "<html>",
                      "\x1f\x8b\x08",
                      "\xff",
                      "\x1b"};
    grammar.separators = "\r\n :,\"";
    grammar.maxLength = 2048;
    grammar.persistence = 30;
    return grammar;
}

}  // namespace boresight::fuzz
