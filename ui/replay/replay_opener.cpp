// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/replay/replay_opener.h"

#include "ui/kit/file_dialog.h"
#include "ui/replay/replay_window.h"

#include <QDir>

namespace boresight::ui {

ReplayOpener::ReplayOpener(const Clock& clock, const QString& stateDir, QObject* parent)
    : QObject(parent), m_clock(clock), m_folder(stateDir + QStringLiteral("/recordings"))
{}

ReplayOpener::~ReplayOpener()
{
    for (const QPointer<ReplayWindow>& window : std::as_const(m_windows)) {
        delete window.data();
    }
}

void ReplayOpener::ask(QWidget& owner)
{
    QFileDialog* const dialog = askForFile(owner, tr("Open recording"), QFileDialog::AcceptOpen,
                                           {tr("Recordings of passes (*.recording)"), tr("All files (*)")});
    dialog->setDirectory(QDir(m_folder).exists() ? m_folder : QDir::homePath());
    connect(dialog, &QFileDialog::fileSelected, this, &ReplayOpener::open);
}

void ReplayOpener::open(const QString& path)
{
    m_files.run(
        this, [path] { return loadTape(path); },
        [this](const Result<SharedTape>& tape) {
            if (!tape) {
                Q_EMIT failed(tape.error().text);
                return;
            }
            // Without a parent, so that the window of the station can always come to the front.
            auto* const window = new ReplayWindow(m_clock, *tape);
            m_windows.removeAll(nullptr);
            m_windows.append(window);
            window->show();
            Q_EMIT opened(window);
        });
}

}  // namespace boresight::ui

#include "moc_replay_opener.cpp"
