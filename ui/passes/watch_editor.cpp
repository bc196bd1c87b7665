// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/passes/watch_editor.h"

#include "core/targets/target.h"
#include "ui/kit/caption.h"
#include "ui/kit/command_button.h"
#include "ui/kit/decimal_box.h"
#include "ui/kit/value_label.h"
#include "ui/link/profile_draft.h"

#include <QComboBox>
#include <QGridLayout>
#include <QSpinBox>

#include <algorithm>

namespace boresight::ui {

namespace {

constexpr int kLeastImportant = 99;
constexpr double kHighest = 89.0;  // °

QString nameOf(int number, const StationStatus& status)
{
    if (status.satellites) {
        const auto found = std::ranges::find(*status.satellites, number, &orbit::ElementSet::number);
        if (found != status.satellites->end()) {
            return targets::satelliteName(*found);
        }
    }
    return QString::number(number);
}

}  // namespace

WatchEditor::WatchEditor(ProfileDraft& draft, RequestDesk& desk, QWidget* parent)
    : QWidget(parent),
      m_draft(draft),
      m_satellite(new QComboBox(this)),
      m_priority(new QSpinBox(this)),
      m_lowest(new DecimalBox(this)),
      m_refused(new ValueLabel(tr("Refused"), fonts::label(), {}, this)),
      m_set(new CommandButton(tr("Set"), tr("Store priority and lowest elevation of this satellite"), desk, *m_refused,
                              this)),
      m_remove(new CommandButton(tr("Remove"), tr("Remove this satellite from the schedule"), desk, *m_refused, this))
{
    build();
    connect(m_satellite, &QComboBox::currentIndexChanged, this, &WatchEditor::showChosen);
    connect(m_set, &QPushButton::clicked, this, &WatchEditor::change);
    connect(m_remove, &QPushButton::clicked, this, &WatchEditor::remove);
}

void WatchEditor::build()
{
    m_satellite->setAccessibleName(tr("Watched satellite"));
    m_satellite->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_satellite->setMinimumContentsLength(4);
    m_priority->setRange(1, kLeastImportant);
    m_priority->setAccessibleName(tr("Priority of the satellite"));
    m_priority->setToolTip(tr("1 is the most important."));
    m_lowest->setRange(0.0, kHighest);
    m_lowest->setDecimals(0);
    m_lowest->setSuffix(QStringLiteral("°"));
    m_lowest->setAccessibleName(tr("Lowest elevation of the satellite"));
    m_lowest->setToolTip(tr("Only the part of its passes above this elevation counts."));
    m_refused->setLines(2);
    m_refused->setStretching(true);
    m_refused->setCollapsing(true);
    for (QWidget* const field : std::initializer_list<QWidget*>{m_satellite, m_priority, m_lowest}) {
        field->setMinimumHeight(kRowHeight);
    }
    auto* const grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(kGrid);
    grid->setVerticalSpacing(4);
    // The satellite has its own line, so that "ISS (ZARYA)" and longer names fit at 1024 px.
    grid->addWidget(m_satellite, 0, 0, 1, 5);
    grid->addWidget(m_remove, 0, 5);
    grid->addWidget(makeCaption(tr("priority"), *m_priority), 1, 0);
    grid->addWidget(m_priority, 1, 1);
    grid->addWidget(makeCaption(tr("from"), *m_lowest), 1, 2);
    grid->addWidget(m_lowest, 1, 3);
    grid->addWidget(m_set, 1, 5);
    grid->addWidget(m_refused, 2, 0, 1, 6);
    grid->setColumnStretch(4, 1);
}

// A selection and typed text stay while the list does not change.
void WatchEditor::showStatus(const StationStatus& status)
{
    if (status.profile->schedule.watch != m_entries || m_satellite->count() != static_cast<int>(m_entries.size())) {
        showList(status);
    }
    const QString none = m_entries.empty() ? tr("No satellite is watched. Add one on the page Coming.") : QString();
    m_set->setBlocked(none);
    m_remove->setBlocked(none);
    for (QWidget* const field : std::initializer_list<QWidget*>{m_satellite, m_priority, m_lowest}) {
        field->setEnabled(none.isEmpty());
    }
}

void WatchEditor::showList(const StationStatus& status)
{
    const QVariant chosen = m_satellite->currentData();
    m_entries = status.profile->schedule.watch;
    const QSignalBlocker quiet(m_satellite);
    m_satellite->clear();
    for (const schedule::WatchEntry& entry : m_entries) {
        m_satellite->addItem(nameOf(entry.number, status), entry.number);
    }
    m_satellite->setCurrentIndex(std::max(m_satellite->findData(chosen), m_entries.empty() ? -1 : 0));
    showChosen();
}

void WatchEditor::showChosen()
{
    if (const int row = m_satellite->currentIndex(); row >= 0) {
        const schedule::WatchEntry& entry = m_entries[std::size_t(row)];
        m_priority->setValue(entry.priority);
        m_lowest->setValue(entry.leastElevation.degrees());
    }
}

void WatchEditor::change()
{
    const schedule::WatchEntry wanted{.number = m_satellite->currentData().toInt(),
                                      .priority = m_priority->value(),
                                      .leastElevation = Angle::fromDegrees(m_lowest->value())};
    m_set->await([&](QObject* asker, const RequestDesk::Reply& reply) {
        m_draft.applyAlone(
            [wanted](profile::Profile& profile) {
                const auto old =
                    std::ranges::find(profile.schedule.watch, wanted.number, &schedule::WatchEntry::number);
                if (old != profile.schedule.watch.end()) {
                    *old = wanted;
                }
            },
            asker, reply);
    });
}

void WatchEditor::remove()
{
    m_remove->await([&](QObject* asker, const RequestDesk::Reply& reply) {
        m_draft.applyAlone(
            [number = m_satellite->currentData().toInt()](profile::Profile& profile) {
                std::erase_if(profile.schedule.watch,
                              [&](const schedule::WatchEntry& one) { return one.number == number; });
            },
            asker, reply);
    });
}

}  // namespace boresight::ui

#include "moc_watch_editor.cpp"
