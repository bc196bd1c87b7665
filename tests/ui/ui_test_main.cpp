// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/messages/request.h"

#include <QApplication>
#include <QFont>

#include <gtest/gtest.h>

// Real widgets without a display: the offscreen platform, and one font on every machine.
int main(int argc, char* argv[])
{
    if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) {
        qputenv("QT_QPA_PLATFORM", "offscreen");
    }
    QApplication::setStyle(QStringLiteral("Fusion"));
    QApplication app(argc, argv);
    QApplication::setFont(QFont(QStringLiteral("DejaVu Sans"), 10));
    qRegisterMetaType<boresight::NumberedRequest>();
    ::testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
