// SPDX-License-Identifier: GPL-3.0-or-later
// manual_pdf FILE: writes the user manual as a PDF file.

#include "ui/manual/manual_pdf.h"

#include <QGuiApplication>
#include <QTextStream>

int main(int argc, char** argv)
{
    const QGuiApplication application(argc, argv);
    QTextStream complaint(stderr);
    const QStringList arguments = QGuiApplication::arguments();
    if (arguments.size() != 2) {
        complaint << "usage: manual_pdf FILE\n";
        return 2;
    }
    const boresight::Result<> written = boresight::ui::writeManualPdf(arguments.at(1));
    if (!written) {
        complaint << written.error().text << '\n';
        return 1;
    }
    return 0;
}
