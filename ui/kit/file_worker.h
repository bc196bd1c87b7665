// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>
#include <QThreadPool>

#include <utility>

// Runs work with files outside the gui thread, one after the other in the order of the calls. The result is passed back
// on the gui thread, unless the asker was deleted meanwhile. The destructor waits for the work that has begun.
namespace boresight::ui {

class FileWorker : public QObject
{
    Q_OBJECT

public:
    explicit FileWorker(QObject* parent = nullptr);
    ~FileWorker() override;

    // `work` runs on the worker and uses only its own copies. `then` receives its result.
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
