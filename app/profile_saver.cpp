// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/profile_saver.h"

namespace boresight::app {

ProfileSaver::ProfileSaver(const Options& options, QObject* parent)
    : QObject(parent), m_kept(options), m_next(options, m_kept)
{
    m_worker.setMaxThreadCount(1);
    m_worker.setExpiryTimeout(-1);
    const NextProfile::Choice choice = m_next.first();
    m_first = choice.profile;
    // Queued, because nobody is connected to the signal yet.
    QMetaObject::invokeMethod(
        this, [this, problems = choice.problems] { report(problems); }, Qt::QueuedConnection);
}

ProfileSaver::~ProfileSaver()
{
    m_worker.waitForDone();
}

void ProfileSaver::report(const QStringList& problems)
{
    for (const QString& problem : problems) {
        Q_EMIT failed(problem);
    }
}

void ProfileSaver::save(const profile::Profile& wanted)
{
    m_worker.start([this, wanted] {
        if (const Result<> saved = m_kept.save(wanted); !saved) {
            report({saved.error().text});
        }
    });
}

void ProfileSaver::findNext(const profile::Profile& wanted)
{
    m_worker.start([this, wanted] {
        const NextProfile::Choice choice = m_next.next(wanted);
        report(choice.problems);
        Q_EMIT nextFound(choice.profile);
    });
}

}  // namespace boresight::app

#include "moc_profile_saver.cpp"
