// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/numbers.h"
#include "core/calibration/terms_fields.h"
#include "core/calibration/terms_text.h"

#include <QDateTime>

namespace boresight::calibration {
namespace {

constexpr int kTermsWriterDecimals = 9;  // of degrees, as in a profile
constexpr std::size_t kNameWidth = 22;
constexpr std::size_t kValueWidth = 15;

std::string padded(std::string text, std::size_t width)
{
    text.resize(std::max(text.size() + 1, width), ' ');
    return text;
}

std::string degrees(Angle angle)
{
    return formatFixed(angle.degrees(), kTermsWriterDecimals);
}

// A sigma that rounds to 0 is written as "-", because 0 would mean no uncertainty.
std::string sigmaText(const std::optional<Angle>& sigma)
{
    const std::string text = sigma ? degrees(*sigma) : "-";
    return text.find_first_of("123456789") == std::string::npos ? "-" : text;
}

std::string dateText(UtcTime when)
{
    const auto since = std::chrono::floor<std::chrono::seconds>(when.time_since_epoch());
    return QDateTime::fromSecsSinceEpoch(since.count(), Qt::UTC).toString(Qt::ISODate).toStdString();
}

std::string siteText(const RecordSite& site)
{
    return degrees(site.latitude) + " " + degrees(site.longitude) + " " + formatFixed(site.heightMetres, 3);
}

class HeaderWriter
{
public:
    void text(const std::string& key, const std::string& value)
    {
        m_written += value.empty() ? "" : "# " + key + ": " + value + "\n";
    }

    void date(const std::string& key, const std::optional<UtcTime>& when) { text(key, when ? dateText(*when) : ""); }
    void site(const std::string& key, const std::optional<RecordSite>& place)
    {
        text(key, place ? siteText(*place) : "");
    }

    [[nodiscard]] const std::string& written() const { return m_written; }

private:
    std::string m_written;
};

}  // namespace

std::string toText(const TermSheet& sheet)
{
    std::string text =
        "# Terms of a pointing model. The site is latitude, longitude (degrees north, east), height (m)\n";
    TermSheet copy = sheet;
    HeaderWriter header;
    headerFields(header, copy);
    text += header.written();
    text += padded("#name", kNameWidth) + padded("value", kValueWidth) + "unit sigma\n";
    for (const Term term : kAllTerms) {
        text += padded(std::string(nameOf(term)), kNameWidth) +
                padded(degrees(valueOf(sheet.terms, term)), kValueWidth) + "deg  " +
                sigmaText(sheet.sigmas[indexOf(term)]) + "\n";
    }
    return text;
}

}  // namespace boresight::calibration
