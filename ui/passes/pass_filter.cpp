// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/passes/pass_filter.h"

#include "ui/kit/caption.h"
#include "ui/kit/choice_button.h"
#include "ui/kit/decimal_box.h"
#include "ui/kit/theme.h"
#include "ui/look/glyph.h"

#include <QHBoxLayout>
#include <QLineEdit>

namespace boresight::ui {

namespace {

constexpr double kHighestFilter = 89.0;  // °

}  // namespace

PassFilter::PassFilter(QWidget* parent)
    : QWidget(parent),
      m_words(new QLineEdit(this)),
      m_lowest(new DecimalBox(this)),
      m_favourites(new ChoiceButton({}, tr("Favourites only"), this))
{
    m_words->setAccessibleName(tr("Satellites to list"));
    m_words->setPlaceholderText(tr("Name or number"));
    m_words->setClearButtonEnabled(true);
    m_words->setMinimumHeight(kRowHeight);
    m_lowest->setRange(0.0, kHighestFilter);
    m_lowest->setDecimals(0);
    m_lowest->setSuffix(QStringLiteral("°"));
    m_lowest->setAccessibleName(tr("Elevation that a listed pass must reach"));
    m_lowest->setToolTip(tr("Passes that stay lower are not listed"));
    m_lowest->setMinimumHeight(kRowHeight);
    m_favourites->setIcon(glyphIcon(Glyph::Favourite));
    m_favourites->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    auto* const row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(kGrid);
    row->addWidget(m_words, 1);
    row->addWidget(makeCaption(tr("at least"), *m_lowest));
    row->addWidget(m_lowest);
    row->addWidget(m_favourites);
    connect(m_words, &QLineEdit::textChanged, this, &PassFilter::changed);
    connect(m_lowest, &QDoubleSpinBox::valueChanged, this, &PassFilter::changed);
    connect(m_favourites, &QToolButton::toggled, this, &PassFilter::changed);
}

PassChoice PassFilter::choice() const
{
    return {.words = m_words->text(),
            .lowest = Angle::fromDegrees(m_lowest->value()),
            .onlyFavourites = m_favourites->isChecked()};
}

void PassFilter::setOnlyFavourites(bool on)
{
    m_favourites->setChecked(on);
}

}  // namespace boresight::ui

#include "moc_pass_filter.cpp"
