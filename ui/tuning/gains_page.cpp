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

#include <algorithm>
#include <cmath>

namespace boresight::ui {

namespace {

constexpr int kGainDigits = 6;  // as many as the drive prints
constexpr int kGainSteps = 50;  // approximate number of steps over the range
constexpr int kMostDecimals = 12;

int exponentOf(double value)
{
    return static_cast<int>(std::floor(std::log10(value)));
}

// The largest value has the digits of the drive, and the smallest value has three of them.
int decimalsOf(const GainLine& line)
{
    const int forMost = line.most > 0.0 ? kGainDigits - 1 - exponentOf(line.most) : 0;
    const int forLeast = line.least > 0.0 ? 2 - exponentOf(line.least) : 0;
    return std::clamp(std::max(forMost, forLeast), 0, kMostDecimals);
}

// 1, 2 or 5 times a power of ten.
double stepOf(const GainLine& line)
{
    const double largest = (line.most - line.least) / kGainSteps;
    if (!(largest > 0.0)) {
        return std::pow(10.0, -decimalsOf(line));
    }
    const double power = std::pow(10.0, exponentOf(largest));
    return largest >= 5.0 * power ? 5.0 * power : largest >= 2.0 * power ? 2.0 * power : power;
}

}  // namespace

GainsPage::GainsPage(RequestDesk& desk, QWidget* parent)
    : AskingPanel(desk, parent),
      m_model(new GainsModel(this)),
      m_table(makeTable()),
      m_state(new ValueLabel(tr("Gains of the drive"), fonts::label(), {}, this)),
      m_reason(new ValueLabel(tr("Limits of the selected gain"), fonts::label(), {}, this)),
      m_notice(new ValueLabel(tr("Refused"), fonts::label(), {}, this)),
      m_value(new DecimalBox(this)),
      m_read(new CommandButton(tr("Read"), tr("Read the gains of this drive. Nothing moves"), desk, *m_notice, this)),
      m_write(new CommandButton(tr("Write"), tr("Write this value and read it back. In force until a power cycle"),
                                desk, *m_notice, this)),
      m_putBack(new CommandButton(tr("Put back"), tr("Write the gains that were read first"), desk, *m_notice, this)),
      m_store(new CommandButton(tr("Store …"), tr("Store the gains in the drive permanently. Asks first"), desk,
                                *m_notice, this))
{
    build();
    connect(m_read, &QPushButton::clicked, this, [this] { m_read->ask(request::ReadGains{m_axis}); });
    connect(m_write, &QPushButton::clicked, this, &GainsPage::write);
    connect(m_putBack, &QPushButton::clicked, this, &GainsPage::putBack);
    connect(m_store, &QPushButton::clicked, this, &GainsPage::store);
    connect(m_value, &QDoubleSpinBox::valueChanged, this, &GainsPage::showButtons);
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

// Empty if no gain is selected, or it was not read.
const GainLine* GainsPage::selected() const
{
    const QModelIndex current = m_table->currentIndex();
    const auto& lines = gains().lines;
    if (!current.isValid() || static_cast<std::size_t>(current.row()) >= lines.size()) {
        return nullptr;
    }
    const GainLine& line = lines[static_cast<std::size_t>(current.row())];
    return line.value ? &line : nullptr;
}

void GainsPage::setAxis(Axis axis)
{
    m_axis = axis;
    showStatus(StationStatus(m_status));
}

void GainsPage::showStatus(const StationStatus& status)
{
    m_status = status;
    m_model->show(gains());
    const bool trial = gains().onTrial && !gains().busy;
    const QString text = gains().text.isEmpty() ? tr("The gains of this drive have not been read.") : gains().text;
    m_state->setValue(trial && !gains().failed ? tr("On trial, not stored: %1").arg(text) : text,
                      gains().failed ? Tone::Warning
                      : trial        ? Tone::Advisory
                                     : Tone::Normal,
                      gains().failed ? Symbol::Warning
                      : trial        ? Symbol::Advisory
                                     : Symbol::None);
    showSelected();
    showWhetherPossible(status);
}

void GainsPage::showButtons()
{
    const auto reason = [this](Action action) { return m_status.permissions.reason(actionOf(action, m_axis)); };
    const GainLine* const line = selected();
    m_read->setBlocked(reason(Action::ReadAzimuthGains));
    if (line == nullptr) {
        m_write->setBlocked(tr("Select a gain in the table first."));
    } else {
        const QString refused = reason(line->needsOff ? Action::SetAzimuthFilter : Action::SetAzimuthGains);
        m_write->setBlocked(!refused.isEmpty() || isEdited() ? refused
                                                             : tr("This value is in force. Enter another one first."));
    }
    m_putBack->setBlocked(reason(Action::PutAzimuthGainsBack));
    m_store->setBlocked(reason(Action::StoreAzimuthGains));
}

void GainsPage::showSelected()
{
    const GainLine* const line = selected();
    m_value->setEnabled(line != nullptr);
    if (line == nullptr) {
        m_loaded.reset();
        m_reason->setValue(tr("Select a gain to change it."), Tone::Secondary);
    } else {
        load(*line);
        m_reason->setValue(QStringLiteral("%1, %2: %3…%4. %5")
                               .arg(line->key, line->unit, gainText(line->least), gainText(line->most), line->bounds));
    }
    showButtons();
}

// The typed value stays until a different value is read from the drive.
void GainsPage::load(const GainLine& line)
{
    const int row = m_table->currentIndex().row();
    const bool isOther =
        !m_loaded || m_loaded->axis != m_axis || m_loaded->row != row || m_loaded->line.value != line.value;
    if (!isOther && m_loaded->line == line) {
        return;
    }
    const bool offers = isOther || !isEdited();
    m_loaded = Loaded{.axis = m_axis, .row = row, .line = line, .offered = isOther ? 0.0 : m_loaded->offered};
    m_value->setDecimals(decimalsOf(line));
    m_value->setRange(line.least, line.most);
    m_value->setSingleStep(stepOf(line));
    if (offers) {
        m_value->setValue(*line.value);
        m_loaded->offered = m_value->value();
    }
}

bool GainsPage::isEdited() const
{
    if (!m_loaded) {
        return false;
    }
    const GainLine& line = m_loaded->line;
    const bool isWithin = *line.value >= line.least && *line.value <= line.most;  // otherwise the box shows the bound
    return !isWithin || m_value->value() != m_loaded->offered;
}

void GainsPage::write()
{
    const GainLine* const line = selected();
    if (line == nullptr) {
        return;
    }
    const request::SetGain wanted{.axis = m_axis,
                                  .gain = static_cast<Gain>(m_table->currentIndex().row()),
                                  .value = std::clamp(m_value->value(), line->least, line->most)};
    if (line->needsOff) {
        askAboutFilter(tr("Write"), wanted, Action::SetAzimuthFilter);
    } else {
        m_write->ask(wanted);
    }
}

void GainsPage::putBack()
{
    const request::PutGainsBack wanted{m_axis};
    if (std::ranges::any_of(gains().lines, [](const GainLine& line) {
            return line.needsOff && line.value && line.first && !isSameGain(*line.first, *line.value);
        })) {
        askAboutFilter(tr("Put back"), wanted, Action::PutAzimuthGainsBack);
    } else {
        m_putBack->ask(wanted);
    }
}

void GainsPage::askAboutFilter(const QString& act, const Request& request, Action action)
{
    askFirst({.title = tr("Write the encoder filter?"),
              .text = tr("With another filter the drive counts its position from a new zero. The cable wrap of the %1 "
                         "is unknown until you enter the position. Nothing moves.")
                          .arg(name(m_axis)),
              .act = act,
              .request = request,
              .action = actionOf(action, m_axis)},
             m_status);
}

void GainsPage::store()
{
    QString text;
    for (std::size_t i = 0; i < gains().lines.size(); ++i) {
        const GainLine& line = gains().lines[i];
        if (line.value && line.stored && !isSameGain(*line.stored, *line.value)) {
            text += QStringLiteral("%1: %2 → %3\n").arg(line.key, gainText(*line.stored), gainText(*line.value));
        }
    }
    askFirst({.title = tr("Store the gains in the %1 drive?").arg(name(m_axis)),
              .text = text + tr("\nThe drive keeps these gains after a power cycle. It also stores all its other "
                                "present settings. Nothing moves."),
              .act = tr("Store"),
              .request = request::StoreGains{m_axis},
              .action = actionOf(Action::StoreAzimuthGains, m_axis)},
             m_status);
}

}  // namespace boresight::ui

#include "moc_gains_page.cpp"
