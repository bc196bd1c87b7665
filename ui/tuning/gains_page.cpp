// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tuning/gains_page.h"

#include "ui/kit/axes.h"
#include "ui/kit/caption.h"
#include "ui/kit/command_button.h"
#include "ui/kit/decimal_box.h"
#include "ui/kit/read_table.h"
#include "ui/kit/value_label.h"
#include "ui/tuning/gains_model.h"
#include "ui/tuning/tuning_words.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QTableView>
#include <QVBoxLayout>

namespace boresight::ui {

GainsPage::GainsPage(RequestDesk& desk, QWidget* parent)
    : AskingPanel(desk, parent),
      m_model(new GainsModel(this)),
      m_table(makeTable()),
      m_state(new ValueLabel(tr("Gains of the drive"), fonts::label(), {}, this)),
      m_reason(new ValueLabel(tr("Bounds of the selected gain"), fonts::label(), {}, this)),
      m_notice(new ValueLabel(tr("Refused"), fonts::label(), {}, this)),
      m_value(new DecimalBox(this)),
      m_read(new CommandButton(tr("Read"), tr("Read the gains of this drive. Nothing moves"), desk, *m_notice, this)),
      m_write(new CommandButton(tr("Write"), tr("Write this value and read it back. In force until a power cycle"),
                                desk, *m_notice, this)),
      m_putBack(
          new CommandButton(tr("Put back"), tr("Write the gains as they were found first"), desk, *m_notice, this)),
      m_store(new CommandButton(tr("Store …"), tr("Keep the gains in the drive without power; asks first"), desk,
                                *m_notice, this))
{
    build();
    connect(m_read, &QPushButton::clicked, this, [this] { m_read->ask(request::ReadGains{m_axis}); });
    connect(m_write, &QPushButton::clicked, this, &GainsPage::write);
    connect(m_putBack, &QPushButton::clicked, this, [this] { m_putBack->ask(request::PutGainsBack{m_axis}); });
    connect(m_store, &QPushButton::clicked, this, &GainsPage::store);
    connect(m_table->selectionModel(), &QItemSelectionModel::currentChanged, this, &GainsPage::showSelected);
    showSelected();
}

void GainsPage::build()
{
    auto* const column = new QVBoxLayout(&controls());
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    for (ValueLabel* const line : {m_state, m_reason, m_notice}) {
        line->setStretching(true);
    }
    m_reason->setLines(2);
    m_notice->setCollapsing(true);
    m_value->setFont(fonts::text());
    m_value->setDecimals(3);
    m_value->setMinimumHeight(kTouchSize);
    m_value->setAccessibleName(tr("New value of the selected gain"));
    auto* const row = new QHBoxLayout;
    row->setSpacing(4);
    row->addWidget(m_value, 2);
    for (CommandButton* const button : {m_write, m_read, m_putBack, m_store}) {
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        row->addWidget(button, 1);
    }
    column->addWidget(m_state);
    column->addWidget(m_table, 1);
    column->addWidget(m_reason);
    column->addLayout(row);
    column->addWidget(m_notice);
}

QTableView* GainsPage::makeTable()
{
    QTableView* const table = makeReadTable(tr("Gains"), *m_model, this);
    table->verticalHeader()->setDefaultSectionSize(table->fontMetrics().lineSpacing() + 4);
    QHeaderView* const header = table->horizontalHeader();
    header->setSectionResizeMode(GainsModel::Name, QHeaderView::Stretch);
    for (const int column : {GainsModel::Found, GainsModel::Now, GainsModel::Range}) {
        header->setSectionResizeMode(column, QHeaderView::ResizeToContents);
    }
    return table;
}

const DriveGains& GainsPage::gains() const
{
    return driveOf(m_status, m_axis).gains;
}

std::optional<Gain> GainsPage::selected() const
{
    const QModelIndex current = m_table->currentIndex();
    return current.isValid() ? std::optional(static_cast<Gain>(current.row())) : std::nullopt;
}

void GainsPage::setAxis(Axis axis)
{
    m_axis = axis;
    showStatus(StationStatus(m_status));
    showSelected();
}

void GainsPage::showStatus(const StationStatus& status)
{
    m_status = status;
    const bool wasRead = m_write->isEnabled();
    m_model->show(gains());
    const bool trial = gains().onTrial && !gains().busy;
    const QString text = gains().text.isEmpty() ? tr("The gains of this drive were not read yet.") : gains().text;
    m_state->setValue(trial && !gains().failed ? tr("On trial, not stored: %1").arg(text) : text,
                      gains().failed ? Tone::Warning
                      : trial        ? Tone::Advisory
                                     : Tone::Normal,
                      gains().failed ? Symbol::Warning
                      : trial        ? Symbol::Advisory
                                     : Symbol::None);
    showButtons();
    if (wasRead != m_write->isEnabled()) {
        showSelected();
    }
    showWhetherPossible(status);
}

void GainsPage::showButtons()
{
    const auto reason = [this](Action action) { return m_status.permissions.reason(actionOf(action, m_axis)); };
    const auto gain = selected();
    const Action set = gain == Gain::EncoderFilter ? Action::SetAzimuthFilter : Action::SetAzimuthGains;
    m_read->setBlocked(reason(Action::ReadAzimuthGains));
    m_write->setBlocked(gain ? reason(set) : tr("Select a gain in the table first."));
    m_putBack->setBlocked(reason(Action::PutAzimuthGainsBack));
    m_store->setBlocked(reason(Action::StoreAzimuthGains));
}

void GainsPage::showSelected()
{
    const auto gain = selected();
    const auto& lines = m_model->lines();
    const auto row = static_cast<std::size_t>(gain.value_or(Gain::Count));
    if (row >= lines.size() || !lines[row].value) {
        m_value->setEnabled(false);
        m_reason->setValue(tr("Select a gain to change it."), Tone::Secondary);
    } else {
        const GainLine& line = lines[row];
        m_value->setEnabled(true);
        m_value->setRange(line.least, line.most);
        m_value->setSingleStep(*line.value / 10.0);
        m_value->setValue(*line.value);
        m_reason->setValue(QStringLiteral("%1, %2: %3…%4. %5")
                               .arg(line.key, line.unit, gainText(line.least), gainText(line.most), line.bounds));
    }
    showButtons();
}

void GainsPage::write()
{
    const auto gain = selected();
    if (!gain) {
        return;
    }
    const request::SetGain wanted{.axis = m_axis, .gain = *gain, .value = m_value->value()};
    if (*gain != Gain::EncoderFilter) {
        m_write->ask(wanted);
        return;
    }
    askFirst({.title = tr("Write the encoder filter?"),
              .text = tr("The drive then counts its position anew. The cable wrap of the %1 is unknown until you "
                         "confirm where the axis stands. Nothing moves.")
                          .arg(name(m_axis)),
              .act = tr("Write"),
              .request = wanted,
              .action = actionOf(Action::SetAzimuthFilter, m_axis)},
             m_status);
}

void GainsPage::store()
{
    QString text;
    for (std::size_t i = 0; i < gains().lines.size(); ++i) {
        const GainLine& line = gains().lines[i];
        if (line.value && line.stored && *line.value != *line.stored) {
            text += QStringLiteral("%1: %2 → %3\n").arg(line.key, gainText(*line.stored), gainText(*line.value));
        }
    }
    askFirst(
        {.title = tr("Store the gains in the %1 drive?").arg(name(m_axis)),
         .text = text + tr("\nThe drive keeps them without power. Everything else that is in force in it is stored "
                           "too. Nothing moves."),
         .act = tr("Store"),
         .request = request::StoreGains{m_axis},
         .action = actionOf(Action::StoreAzimuthGains, m_axis)},
        m_status);
}

}  // namespace boresight::ui

#include "moc_gains_page.cpp"
