// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QSocketNotifier>

#include <array>
#include <memory>

// Unix signals as Qt signals on the thread that created this object, so that a program can end in good order: SIGTERM,
// SIGINT and SIGHUP. One object per program.
namespace boresight::app {

// The effect of SIGHUP. It ends a program with a terminal or a window. A service reads its settings again.
enum class HangUp
{
    Ends,  // unless the program was started to outlive its terminal (nohup)
    Reloads,
};

class UnixSignals : public QObject
{
    Q_OBJECT

public:
    explicit UnixSignals(HangUp hangUp = HangUp::Ends, QObject* parent = nullptr);
    ~UnixSignals() override;

Q_SIGNALS:
    void endRequested();
    void reloadRequested();

private:
    HangUp m_hangUp;
    std::array<int, 2> m_sockets{-1, -1};
    std::unique_ptr<QSocketNotifier> m_notifier;
};

}  // namespace boresight::app
