// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/guide/model_choice.h"

#include <QCompleter>
#include <QLineEdit>

#include <algorithm>

namespace boresight::ui {
namespace {

QString lineOf(const RotatorModel& model)
{
    return QStringLiteral("%1 %2").arg(model.number).arg(model.name);
}

int leadingNumber(const QString& text)
{
    return text.trimmed().section(QLatin1Char(' '), 0, 0).toInt();
}

}  // namespace

ModelChoice::ModelChoice(QWidget* parent)
    : TouchCombo(tr("Model of the rotator"), tr("Type a part of its name, its maker or its number"), parent)
{
    setEditable(true);
    lineEdit()->setPlaceholderText(tr("Model: type a part of its name"));
    completer()->setCompletionMode(QCompleter::PopupCompletion);
    completer()->setFilterMode(Qt::MatchContains);
    completer()->setCaseSensitivity(Qt::CaseInsensitive);
}

void ModelChoice::showModels(const RotatorModels& models)
{
    m_models = models;
    QStringList lines;
    for (const RotatorModel& model : models.list) {
        lines << lineOf(model);
    }
    setLines(lines);
    choose(leadingNumber(currentText()));
}

// Before the list arrives, the number alone is shown.
void ModelChoice::choose(int number)
{
    if (number <= 0) {
        return;
    }
    const auto at = std::ranges::find(m_models.list, number, &RotatorModel::number);
    setEditText(at == m_models.list.end() ? QString::number(number) : lineOf(*at));
}

int ModelChoice::number() const
{
    const int number = leadingNumber(currentText());
    return std::ranges::find(m_models.list, number, &RotatorModel::number) == m_models.list.end() ? 0 : number;
}

QString ModelChoice::whyNone() const
{
    if (!m_models.problem.isEmpty()) {
        return m_models.problem;
    }
    return number() > 0 ? QString() : tr("Choose the model of the rotator.");
}

}  // namespace boresight::ui

#include "moc_model_choice.cpp"
