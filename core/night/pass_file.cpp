// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/night/pass_file.h"

#include "core/base/text.h"
#include "core/profile/small_file.h"
#include "core/schedule/report_text.h"

#include <QFile>

namespace boresight {

PassFile::PassFile(const QString& path, QObject* parent) : QObject(parent), m_path(path)
{
    connect(&m_writer, &NewestWriter::written, this, [this] { m_problem.clear(); });
    connect(&m_writer, &NewestWriter::failed, this, [this](const QString& reason) {
        m_problem = Text::tr("The running pass could not be stored: %1").arg(reason);
    });
    load();
}

void PassFile::load()
{
    if (m_path.isEmpty() || !QFile::exists(m_path)) {
        return;
    }
    auto read = profile::readFile(m_path).and_then([&](const QByteArray& bytes) {
        return schedule::parsePass({bytes.constData(), static_cast<std::size_t>(bytes.size())}, m_path);
    });
    if (read) {
        m_found = *std::move(read);
    } else {
        m_problem =
            Text::tr("The file of the last pass cannot be read: %1. The next pass replaces it.").arg(read.error().text);
    }
}

void PassFile::keep(const schedule::NewestPass& newest)
{
    if (!m_path.isEmpty()) {
        m_writer.write([path = m_path, newest] {
            return schedule::toText(newest).and_then(
                [&](const std::string& text) { return profile::writeFile(path, QByteArray::fromStdString(text)); });
        });
    }
}

}  // namespace boresight

#include "moc_pass_file.cpp"
