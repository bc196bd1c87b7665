// SPDX-License-Identifier: GPL-3.0-or-later
// main() for tests that need an event loop but no screen.
#include <QCoreApplication>
#include <QNetworkProxyFactory>

#include <gmock/gmock.h>

int main(int argc, char** argv)
{
    testing::InitGoogleMock(&argc, argv);
    const QCoreApplication application(argc, argv);
    QNetworkProxyFactory::setUseSystemConfiguration(false);  // for the tests' own sockets
    return RUN_ALL_TESTS();
}
