// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "ui/kit/file_worker.h"

#include <QList>
#include <QObject>
#include <QPointer>
#include <QString>

// Asks for a recording, reads it beside the gui thread, and opens it in a window of its own. Several may be open. Gui
// thread.
namespace boresight::ui {

class ReplayWindow;

class ReplayOpener : public QObject
{
    Q_OBJECT

public:
    // `stateDir` has the folder of the recordings. The clock must outlive the opener.
    ReplayOpener(const Clock& clock, const QString& stateDir, QObject* parent = nullptr);
    ~ReplayOpener() override;

    void ask(QWidget& owner);
    void open(const QString& path);

Q_SIGNALS:
    void opened(boresight::ui::ReplayWindow* window);
    void failed(const QString& reason);

private:
    const Clock& m_clock;
    QString m_folder;
    QList<QPointer<ReplayWindow>> m_windows;
    FileWorker m_files;
};

}  // namespace boresight::ui
