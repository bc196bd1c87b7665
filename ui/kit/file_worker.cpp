// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/file_worker.h"

namespace boresight::ui {

FileWorker::FileWorker(QObject* parent) : QObject(parent)
{
    m_pool.setMaxThreadCount(1);
}

FileWorker::~FileWorker()
{
    m_pool.waitForDone();
}

}  // namespace boresight::ui

#include "moc_file_worker.cpp"
