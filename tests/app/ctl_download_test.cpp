// SPDX-License-Identifier: GPL-3.0-or-later
// boresightctl with element sets from an address.
#include "core/element_web/element_cache.h"
#include "tests/app/ctl_sky_fixture.h"

#include <gmock/gmock.h>

namespace boresight {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

using CtlDownload = CtlSkyFixture;

// REQ-CTL-09: --elements accepts addresses as the station does. Downloads that are due come first and are reported.
// Otherwise the cache is used. A problem with an address is reported.
TEST_F(CtlDownload, AnAddressIsReadFromTheCache)
{
    const QByteArray before = qgetenv("XDG_CACHE_HOME");
    qputenv("XDG_CACHE_HOME", QFile::encodeName(folder.path()));
    const orbit::ElementCache cache(orbit::ElementCache::userFolder());
    const auto group = orbit::parseElementAddress("celestrak:stations");
    ASSERT_TRUE(cache.keepContent(*group, QByteArray::fromStdString(kStation)));
    const UtcTime now = SystemClock().utc();
    ASSERT_TRUE(cache.keepState(*group, {.lastTry = now, .fetched = now}));
    const char* const day = "--from 2024-05-09T12:00:00Z --days 1";
    const Outcome known = passes(QStringLiteral("celestrak:stations"), day);
    EXPECT_EQ(known.status, 0);
    EXPECT_THAT(known.output, HasSubstr("ISS (ZARYA),25544,"));
    EXPECT_EQ(known.errors, "");
    const Outcome refused = passes(QStringLiteral("http://127.0.0.1:1/a.tle"), day);
    EXPECT_EQ(refused.status, 1);
    EXPECT_THAT(refused.errors, AllOf(StartsWith("Boresight downloads element sets"),
                                      HasSubstr("http://127.0.0.1:1/a.tle: The download has failed: "),
                                      HasSubstr("The cache has no elements of this source.")));
    qputenv("XDG_CACHE_HOME", before);
}

}  // namespace boresight
