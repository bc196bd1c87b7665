// SPDX-License-Identifier: GPL-3.0-or-later
// main() for tests that need an event loop but no screen.
#include <QCoreApplication>

#include <gmock/gmock.h>

int main(int argc, char** argv)
{
    testing::InitGoogleMock(&argc, argv);
    const QCoreApplication application(argc, argv);
    return RUN_ALL_TESTS();
}
