// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/calibration_status.h"
#include "core/messages/station_status.h"

#include <QWidget>

#include <array>

class QDoubleSpinBox;

// The terms of the pointing model as typed text or from a text file. They become the proposal, and are applied like any
// other result. Fields without typing show the value in effect.
namespace boresight::ui {

class CommandButton;
class RequestDesk;
class ValueLabel;

class TermsBox : public QWidget
{
    Q_OBJECT

public:
    TermsBox(RequestDesk& desk, ValueLabel& notice, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);

Q_SIGNALS:
    void proposed();  // the station has accepted them

private:
    struct Field
    {
        QDoubleSpinBox* box = nullptr;
        Angle inForce;
        bool typed = false;
    };

    void build();
    [[nodiscard]] QLayout* makeButtons();
    [[nodiscard]] static bool isAsInForce(const Field& one);
    void addField(calibration::Term term);
    void showInForce();
    void propose();
    void chooseImport();
    void import(const QString& path);
    void chooseExport();
    void exportTo(const QString& path);
    void complain(const QString& reason);
    [[nodiscard]] Field& field(calibration::Term term) { return m_fields[calibration::indexOf(term)]; }

    ValueLabel& m_notice;
    std::array<Field, calibration::kTerms> m_fields{};
    calibration::TermSheet m_sheet;
    CommandButton* m_propose;
    CommandButton* m_reset;
    CommandButton* m_import;
    CommandButton* m_export;
};

}  // namespace boresight::ui
