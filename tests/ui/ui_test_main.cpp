// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/messages/request.h"

#include <QApplication>
#include <QDeadlineTimer>
#include <QDir>
#include <QFont>
#include <QThread>
#include <QThreadPool>

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

#ifdef BORESIGHT_LOOKS_FOR_LEAKS
// A thread is gone a moment after Qt's pool has ended it.
void endPooledThreads()
{
    QThreadPool::globalInstance()->waitForDone();
    const QDir threads(QStringLiteral("/proc/self/task"));
    const QDeadlineTimer patience(std::chrono::seconds(5));
    while (threads.entryList(QDir::Dirs | QDir::NoDotAndDotDot).size() > 1 && !patience.hasExpired()) {
        QThread::msleep(1);
    }
}
#endif

// LeakSanitizer reads the stacks of all threads, and crashes on one that is just ending ("Tracer caught signal 11", one
// of 36 runs). At the end of the program Qt ends its pooled threads, so they are ended before.
void lookForLeaks()
{
#ifdef BORESIGHT_LOOKS_FOR_LEAKS
    endPooledThreads();
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
