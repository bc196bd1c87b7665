// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/messages/request.h"

#include <QApplication>
#include <QFont>

#include <gtest/gtest.h>

namespace {

// As in tests/environment.cmake.in, for a program that is started without ctest.
void setUnlessSet(const char* name, const char* value)
{
    if (!qEnvironmentVariableIsSet(name)) {
        qputenv(name, value);
    }
}

}  // namespace

// Real widgets without a display: the offscreen platform, and the same font on every computer.
int main(int argc, char* argv[])
{
    setUnlessSet("QT_QPA_PLATFORM", "offscreen");
    setUnlessSet("FONTCONFIG_FILE", BORESIGHT_TEST_FONTS);
    QApplication app(argc, argv);
    QApplication::setStyle(QStringLiteral("Fusion"));
    QApplication::setFont(QFont(qEnvironmentVariable("BORESIGHT_TEST_FONT", QStringLiteral("DejaVu Sans")), 10));
    qRegisterMetaType<boresight::NumberedRequest>();
    ::testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
