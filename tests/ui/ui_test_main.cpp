// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/messages/request.h"

#include <QApplication>
#include <QFont>

#include <gtest/gtest.h>

#ifdef BORESIGHT_LOOKS_FOR_LEAKS
#include <sanitizer/lsan_interface.h>
#endif

namespace {

// As in tests/environment.cmake.in, for a program that is started without ctest.
void setUnlessSet(const char* name, const char* value)
{
    if (!qEnvironmentVariableIsSet(name)) {
        qputenv(name, value);
    }
}

// Called before the end of the program, where Qt ends its pooled threads: LeakSanitizer crashes on a thread that is
// just ending ("Tracer caught signal 11", one of 36 runs).
void lookForLeaks()
{
#ifdef BORESIGHT_LOOKS_FOR_LEAKS
    __lsan_do_leak_check();
#endif
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
    const int result = RUN_ALL_TESTS();
    lookForLeaks();
    return result;
}
