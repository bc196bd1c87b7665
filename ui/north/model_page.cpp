// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/north/model_page.h"

#include "ui/kit/choice_button.h"
#include "ui/kit/command_button.h"
#include "ui/kit/format.h"
#include "ui/kit/read_table.h"
#include "ui/kit/value_label.h"
#include "ui/north/calibration_words.h"
#include "ui/north/point_model.h"
#include "ui/north/residual_sky.h"
#include "ui/north/term_model.h"
#include "ui/north/terms_box.h"

#include <QButtonGroup>
#include <QHeaderView>
#include <QPlainTextEdit>
#include <QStackedWidget>
#include <QTableView>
#include <QVBoxLayout>

namespace boresight::ui {

namespace {

QString remarksOf(const StationStatus& status)
{
    const CalibrationStatus& calibration = calibrationOf(status);
    QStringList lines;
    if (status.sensor.azimuthSigma) {
        lines << ModelPage::tr(
                     "Here the sensor measures the azimuth to %1 (1 sigma). It cannot check a more exact model")
                     .arg(angleText(*status.sensor.azimuthSigma, 1));
    }
    if (calibration.proposal) {
        lines << warningsOf(*calibration.proposal);
    }
    if (calibration.fit) {
        for (const QString& remark : calibration.fit->remarks) {
            if (!lines.contains(remark)) {
                lines << remark;
            }
        }
    }
    return lines.join(QLatin1Char('\n'));
}

}  // namespace

ModelPage::ModelPage(RequestDesk& desk, QWidget* parent)
    : QWidget(parent),
      m_terms(new TermModel(this)),
      m_points(new PointModel(this)),
      m_summary(new ValueLabel(tr("How well the model fits"), fonts::label(), {}, this)),
      m_notice(new ValueLabel(tr("Refused"), fonts::label(), {}, this)),
      m_remarks(new QPlainTextEdit(this)),
      m_termTable(makeReadTable(tr("Terms of the pointing model"), *m_terms, this)),
      m_pointTable(makeReadTable(tr("Calibration points"), *m_points, this)),
      m_sky(new ResidualSky(this)),
      m_use(new CommandButton(tr("Leave out"), {}, desk, *m_notice, this)),
      m_drop(new CommandButton(tr("Drop"), tr("Delete the selected point"), desk, *m_notice, this)),
      m_given(new TermsBox(desk, *m_notice, this)),
      m_views(new QStackedWidget(this))
{
    m_drop->setAccessibleName(tr("Drop the selected point"));
    build();
    connect(m_use, &QPushButton::clicked, this, &ModelPage::useOrNot);
    connect(m_drop, &QPushButton::clicked, this, &ModelPage::drop);
    connect(m_pointTable->selectionModel(), &QItemSelectionModel::currentRowChanged, this, &ModelPage::showSelected);
}

void ModelPage::build()
{
    auto* const row = new QHBoxLayout;
    row->setSpacing(2);
    auto* const group = new QButtonGroup(this);
    const std::pair<QString, QString> views[] = {{tr("Terms"), tr("The terms of the pointing model")},
                                                 {tr("Points"), tr("The points and their residuals")},
                                                 {tr("Type"), tr("Type the terms, or exchange them with a file")}};
    for (std::size_t view = 0; view < m_choices.size(); ++view) {
        auto* const button = new ChoiceButton(views[view].first, views[view].second, this);
        button->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
        m_choices[view] = button;
        group->addButton(button);
        row->addWidget(button);
        connect(button, &QToolButton::clicked, this, [this, view] { showView(static_cast<View>(view)); });
    }
    m_summary->setStretching(true);
    m_summary->setLines(3);
    m_notice->setStretching(true);
    m_notice->setCollapsing(true);
    row->addSpacing(4);
    row->addWidget(m_summary, 1);
    m_views->addWidget(makeTerms());
    m_views->addWidget(makePoints());
    m_views->addWidget(m_given);
    showView(View::Terms);
    // shows the proposal beside the terms in effect
    connect(m_given, &TermsBox::proposed, this, [this] { showView(View::Terms); });
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(6, 4, 6, 0);
    column->setSpacing(4);
    column->addLayout(row);
    column->addWidget(m_views, 1);
    column->addWidget(m_notice);
}

void ModelPage::showView(View view)
{
    m_choices[static_cast<std::size_t>(view)]->setChecked(true);
    m_views->setCurrentIndex(static_cast<int>(view));
}

QWidget* ModelPage::makeTerms()
{
    auto* const box = new QWidget(this);
    auto* const column = new QVBoxLayout(box);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    m_termTable->horizontalHeader()->setSectionResizeMode(TermModel::Name, QHeaderView::Stretch);
    m_remarks->setFont(fonts::label());
    m_remarks->setReadOnly(true);
    m_remarks->setTabChangesFocus(true);
    m_remarks->setAccessibleName(tr("Remarks on the fit"));
    m_remarks->setPlaceholderText(
        tr("1 point finds the azimuth offset. 2 points also find the elevation offset. With 3 points or more the fit "
           "finds other terms."));
    m_remarks->setMinimumHeight(2 * m_remarks->fontMetrics().lineSpacing() + 10);
    m_remarks->setMaximumHeight(5 * m_remarks->fontMetrics().lineSpacing() + 10);
    m_remarks->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored);
    column->addWidget(m_termTable, 4);
    column->addWidget(m_remarks, 1);
    return box;
}

QWidget* ModelPage::makePoints()
{
    auto* const box = new QWidget(this);
    auto* const row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    auto* const left = new QVBoxLayout;
    left->setSpacing(4);
    auto* const buttons = new QHBoxLayout;
    buttons->setSpacing(4);
    for (CommandButton* const button : {m_use, m_drop}) {
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        buttons->addWidget(button);
    }
    m_pointTable->horizontalHeader()->setSectionResizeMode(PointModel::Label, QHeaderView::Stretch);
    left->addWidget(m_pointTable, 1);
    left->addLayout(buttons);
    row->addLayout(left, 5);
    row->addWidget(m_sky, 3);
    return box;
}

void ModelPage::showStatus(const StationStatus& status)
{
    const bool anew = status.calibration != m_status.calibration;
    m_status = status;
    if (anew) {
        const CalibrationStatus& calibration = calibrationOf(status);
        m_terms->show(calibration);
        m_points->show(calibration.points);
        m_sky->showPoints(calibration.points);
        m_summary->setValue(fitText(calibration));
        m_given->showStatus(status);
        if (const QString remarks = remarksOf(status); remarks != m_remarks->toPlainText()) {
            m_remarks->setPlainText(remarks);
        }
    }
    showSelected();
}

int ModelPage::selected() const
{
    return m_pointTable->currentIndex().row();
}

void ModelPage::showSelected()
{
    const int row = selected();
    m_sky->setSelected(row);
    const bool isUsed = row < 0 || m_points->point(row).isUsed;
    m_use->setCommand(isUsed ? tr("Leave out") : tr("Use again"),
                      isUsed ? tr("Leave the selected point out of the fit. It stays in the list")
                             : tr("Use the selected point in the fit again"));
    QString reason = m_status.permissions.reason(Action::ChangePoints);
    if (reason.isEmpty() && row < 0) {
        reason = tr("Select a point first.");
    }
    m_use->setBlocked(reason);
    m_drop->setBlocked(reason);
}

void ModelPage::useOrNot()
{
    if (const int row = selected(); row >= 0) {
        m_use->ask(request::UsePoint{.index = static_cast<std::size_t>(row), .used = !m_points->point(row).isUsed});
    }
}

void ModelPage::drop()
{
    if (const int row = selected(); row >= 0) {
        m_drop->ask(request::DropPoint{static_cast<std::size_t>(row)});
    }
}

}  // namespace boresight::ui

#include "moc_model_page.cpp"
