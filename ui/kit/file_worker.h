// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>
#include <QThreadPool>

#include <utility>

// Work with files beside the gui thread, one after the other, in the order it was asked for. What it found comes back
// on the gui thread, unless the asker is gone by then. The end of the worker waits for what was begun.
namespace boresight::ui {

class FileWorker : public QObject
{
    Q_OBJECT

public:
    explicit FileWorker(QObject* parent = nullptr);
    ~FileWorker() override;

    // `work` runs on the worker and touches nothing but its own copies; `then` gets what it returns.
    template <class Work, class Then>
    void run(QObject* asker, Work work, Then then)
    {
        m_pool.start([this, to = QPointer<QObject>(asker), work = std::move(work), then = std::move(then)] {
            auto found = work();
            QMetaObject::invokeMethod(
                this,
                [to, then, found = std::move(found)] {
                    if (to) {
                        then(found);
                    }
                },
                Qt::QueuedConnection);
        });
    }

private:
    QThreadPool m_pool;
};

}  // namespace boresight::ui
