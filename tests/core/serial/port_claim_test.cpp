// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/serial/port_claim.h"

#include "core/base/file_descriptor.h"
#include "tests/fakes/text_of.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <string>

namespace boresight {
namespace {

FileDescriptor openPort(const char* path)
{
    return FileDescriptor(::open(path, O_RDWR | O_NOCTTY | O_CLOEXEC));
}

// REQ-CAN-19
TEST(PortClaim, IsOneAtATimeAndEndsWithThePort)
{
    const FileDescriptor device(::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC));
    ASSERT_EQ(::grantpt(device.number()), 0);
    ASSERT_EQ(::unlockpt(device.number()), 0);
    const char* const path = ::ptsname(device.number());
    FileDescriptor first = openPort(path);
    ASSERT_TRUE(first.isOpen());
    ASSERT_EQ(ioctl(first.number(), TIOCEXCL), 0);
    ASSERT_TRUE(claimPort(first.number()));
    int exclusive = 1;
    ASSERT_EQ(ioctl(first.number(), TIOCGEXCL, &exclusive), 0);
    EXPECT_EQ(exclusive, 0) << "it would outlive a killed program";

    const FileDescriptor second = openPort(path);
    ASSERT_TRUE(second.isOpen());
    const Result<> claimed = claimPort(second.number());
    ASSERT_FALSE(claimed);
    EXPECT_EQ(claimed.error().code, ErrorCode::Busy);
    EXPECT_EQ(textOf(claimed.error()),
              program_invocation_short_name + std::string(" (process ") + std::to_string(::getpid()) + ")");
    first.reset();
    EXPECT_TRUE(claimPort(second.number()));
}

}  // namespace
}  // namespace boresight
