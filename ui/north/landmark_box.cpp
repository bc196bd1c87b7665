// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/north/landmark_box.h"

#include "ui/kit/caption.h"
#include "ui/kit/command_button.h"
#include "ui/kit/guide_fields.h"
#include "ui/kit/value_label.h"
#include "ui/north/calibration_words.h"

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLineEdit>

namespace boresight::ui {

LandmarkBox::LandmarkBox(RequestDesk& desk, ValueLabel& notice, QWidget* parent)
    : QWidget(parent),
      m_azimuth(makeField({.name = tr("True azimuth of the landmark"),
                           .help = tr("From true north, by a map or a GPS receiver"),
                           .min = 0.0,
                           .max = 360.0,
                           .unit = QStringLiteral("°")},
                          this)),
      m_elevation(makeField({.name = tr("True elevation of the landmark"),
                             .help = tr("0° is level"),
                             .min = -10.0,
                             .max = 90.0,
                             .unit = QStringLiteral("°")},
                            this)),
      m_label(new QLineEdit(this)),
      m_state(new ValueLabel(tr("Landmark"), fonts::label(), {}, this)),
      m_take(new CommandButton(tr("Take point"), tr("The target is centred now. Store the position of the axes"), desk,
                               notice, this))
{
    m_take->setAccessibleName(tr("Store the landmark as a point"));
    m_label->setFont(fonts::label());
    m_label->setMaxLength(40);
    m_label->setMinimumHeight(m_azimuth->minimumHeight());
    m_label->setPlaceholderText(tr("name"));
    m_label->setAccessibleName(tr("Name of the landmark"));
    m_state->setStretching(true);
    m_state->setLines(2);
    build();
    connect(m_take, &QPushButton::clicked, this, &LandmarkBox::take);
    for (QDoubleSpinBox* const field : {m_azimuth, m_elevation}) {
        connect(field, &QDoubleSpinBox::valueChanged, this, &LandmarkBox::describe);
    }
    connect(m_label, &QLineEdit::textChanged, this, &LandmarkBox::describe);
}

void LandmarkBox::build()
{
    auto* const grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(4);
    int column = 0;
    for (const auto& [text, field] : {std::pair(tr("Az"), m_azimuth), std::pair(tr("El"), m_elevation)}) {
        grid->addWidget(makeCaption(text, *field), 0, column++);
        grid->addWidget(field, 0, column++);
    }
    grid->addWidget(m_label, 1, 0, 1, 2);
    grid->addWidget(m_take, 1, 2, 1, 2);
    grid->addWidget(m_state, 2, 0, 1, 4);
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(3, 1);
}

void LandmarkBox::showStatus(const StationStatus& status)
{
    m_status = status;
    describe();
}

void LandmarkBox::describe()
{
    const QString reason = isTold() ? m_status.permissions.reason(Action::TakeKnownPoint)
                                    : tr("Type the direction of the landmark first. For 0 and 0 type its name, too.");
    m_take->setBlocked(reason);
    m_state->setValue(reason.isEmpty() ? tr("points taken: %1").arg(calibrationOf(m_status).points.size())
                                       : tr("Not now: %1").arg(reason),
                      Tone::Secondary);
}

// The fields start with 0° and 0°, which is not yet an entry.
bool LandmarkBox::isTold() const
{
    return m_azimuth->value() != 0.0 || m_elevation->value() != 0.0 || !m_label->text().trimmed().isEmpty();
}

void LandmarkBox::take()
{
    m_take->ask(request::TakeKnownPoint{.truth = {.azimuth = Angle::fromDegrees(m_azimuth->value()).wrapped360(),
                                                  .elevation = Angle::fromDegrees(m_elevation->value())},
                                        .label = m_label->text().trimmed()});
}

}  // namespace boresight::ui

#include "moc_landmark_box.cpp"
