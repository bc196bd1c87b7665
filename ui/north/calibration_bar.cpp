// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/north/calibration_bar.h"

#include "ui/kit/command_button.h"
#include "ui/kit/value_label.h"
#include "ui/north/calibration_words.h"

#include <QHBoxLayout>

namespace boresight::ui {

namespace {

std::uint64_t numberOf(const std::shared_ptr<const CalibrationStatus>& calibration)
{
    return calibration && calibration->proposal ? calibration->proposal->number : 0;
}

bool isUnreliable(const std::shared_ptr<const CalibrationStatus>& calibration)
{
    return calibration && calibration->proposal && !calibration->proposal->doubts.empty();
}

Question questionAbout(const CalibrationProposal& proposal)
{
    const QStringList doubts(proposal.doubts.begin(), proposal.doubts.end());
    return {.title = CalibrationBar::tr("Apply an unreliable result?"),
            .text = CalibrationBar::tr("This result is unreliable. %1\n\nApply anyway changes: %2.\n\nThe mount then "
                                       "points by this result. The log records that you applied it anyway. Undo "
                                       "returns to the calibration before.")
                        .arg(doubts.join(QLatin1Char(' ')), changeText(proposal)),
            .act = CalibrationBar::tr("Apply anyway"),
            .request = request::ApplyCalibration{.proposal = proposal.number, .overridesDoubts = true},
            .action = Action::ApplyCalibration};
}

}  // namespace

CalibrationBar::CalibrationBar(RequestDesk& desk, QWidget* parent)
    : QWidget(parent),
      m_title(new ValueLabel(tr("Proposed calibration"), fonts::label(), {}, this)),
      m_change(new ValueLabel(tr("What Apply changes"), fonts::label(), {}, this)),
      m_notice(new ValueLabel(tr("Refused"), fonts::label(), {}, this)),
      m_apply(new CommandButton(tr("Apply north"), {}, desk, *m_notice, this)),
      m_discard(new CommandButton(tr("Discard"), tr("Drop the proposal. Nothing changes, and the points stay"), desk,
                                  *m_notice, this)),
      m_undo(
          new CommandButton(tr("Undo"), tr("Return to the previous calibration. Nothing moves"), desk, *m_notice, this))
{
    m_discard->setAccessibleName(tr("Discard the proposal"));
    m_undo->setAccessibleName(tr("Undo the calibration"));
    build();
    for (const CommandButton* const button : {m_apply, m_discard}) {
        connect(button, &QPushButton::pressed, this, [this] { m_pressed = m_shown; });
    }
    connect(m_apply, &QPushButton::clicked, this, &CalibrationBar::apply);
    connect(m_discard, &QPushButton::clicked, this,
            [this] { m_discard->ask(request::DiscardCalibration{numberOf(m_pressed)}); });
    connect(m_undo, &QPushButton::clicked, this, [this] { m_undo->ask(request::UndoCalibration{}); });
}

void CalibrationBar::build()
{
    auto* const row = new QHBoxLayout(this);
    row->setContentsMargins(6, 0, 6, 2);
    row->setSpacing(4);
    auto* const lines = new QVBoxLayout;
    lines->setSpacing(0);
    for (ValueLabel* const line : {m_title, m_change, m_notice}) {
        line->setStretching(true);
        line->setWrapping(true);
        lines->addWidget(line);
    }
    m_notice->setCollapsing(true);  // shown in place of the changes, until the next press
    row->addLayout(lines, 1);
    row->addWidget(m_apply);
    row->addWidget(m_discard);
    row->addWidget(m_undo);
}

void CalibrationBar::apply()
{
    if (isUnreliable(m_pressed)) {
        Q_EMIT confirmationWanted(questionAbout(*m_pressed->proposal));
    } else {
        m_apply->ask(request::ApplyCalibration{numberOf(m_pressed)});
    }
}

void CalibrationBar::showStatus(const StationStatus& status)
{
    const CalibrationStatus& calibration = calibrationOf(status);
    const Sentence title = proposalSentence(calibration);
    m_title->setValue(title.text, title.tone, title.symbol);
    showChange(calibration.proposal);
    m_change->setVisible(m_notice->text().isEmpty());
    m_shown = status.calibration;
    showApply(status);
    m_discard->setBlocked(status.permissions.reason(Action::DiscardCalibration));
    m_undo->setBlocked(status.permissions.reason(Action::UndoCalibration));
}

void CalibrationBar::showApply(const StationStatus& status)
{
    const std::optional<CalibrationProposal>& proposal = calibrationOf(status).proposal;
    const QString text = proposal && keepsNorth(*proposal) ? tr("Apply to sensor") : tr("Apply north");
    m_apply->setCommand(
        isUnreliable(status.calibration) ? text + QStringLiteral(" …") : text,
        proposal ? tr("In force at once, and nothing moves: %1").arg(changeText(*proposal)) : QString());
    m_apply->setBlocked(status.permissions.reason(Action::ApplyCalibration));
}

// Every warning comes before the changes, because a warning that is not visible here could be applied unread.
void CalibrationBar::showChange(const std::optional<CalibrationProposal>& proposal)
{
    if (!proposal) {
        m_change->setValue(tr("Steps 1 to 3 find north"), Tone::Secondary);
        return;
    }
    const QStringList warnings = warningsOf(*proposal);
    QStringList lines;
    if (!warnings.isEmpty()) {
        lines << warnings.join(QLatin1Char(' '));
    }
    if (!proposal->remark.isEmpty()) {
        lines << proposal->remark;
    }
    lines << changeText(*proposal);
    m_change->setValue(lines.join(QLatin1Char('\n')), warnings.isEmpty() ? Tone::Secondary : Tone::Warning);
}

}  // namespace boresight::ui

#include "moc_calibration_bar.cpp"
