#include "benchmarks/report/table.h"

#include "base/assert.h"

#include <cmath>
#include <cstdio>

namespace ductus {

namespace {

std::string textOf(const Cell &cell, int decimals)
{
    if (const auto *text = std::get_if<std::string>(&cell))
        return *text;
    const auto *number = std::get_if<double>(&cell);
    if (!number || !std::isfinite(*number))
        return number ? "nan" : "-";
    char buffer[512];
    std::snprintf(buffer, sizeof buffer, "%.*f", decimals, *number);
    return buffer;
}

nlohmann::ordered_json jsonOf(const Cell &cell)
{
    if (const auto *text = std::get_if<std::string>(&cell))
        return *text;
    if (const auto *number = std::get_if<double>(&cell))
        return *number;
    return nullptr;
}

std::string padded(const std::string &text, int width, bool left)
{
    const std::string space(std::size_t(std::max(0, width - int(text.size()))), ' ');
    return left ? text + space : space + text;
}

} // namespace

Table::Table(std::ostream &out, const std::string &title, std::vector<Column> columns)
    : mOut(out), mTitle(title), mColumns(std::move(columns))
{
    DUCTUS_ASSERT(!mColumns.empty());
    std::string headings, rule;
    for (Column &column : mColumns) {
        column.width = std::max(column.width, int(column.heading.size()));
        const bool first = &column == &mColumns.front();
        headings += (first ? "" : "  ") + padded(column.heading, column.width, first);
        rule += (first ? "" : "  ") + std::string(std::size_t(column.width), '-');
    }
    mOut << '\n' << title << '\n' << headings << '\n' << rule << std::endl;
}

void Table::add(const std::vector<Cell> &cells)
{
    DUCTUS_ASSERT(cells.size() <= mColumns.size());
    nlohmann::ordered_json row;
    std::string line;
    for (std::size_t i = 0; i < mColumns.size(); ++i) {
        const Cell cell = i < cells.size() ? cells[i] : Cell();
        line += (i ? "  " : "") + padded(textOf(cell, mColumns[i].decimals), mColumns[i].width, i == 0);
        row[mColumns[i].key] = jsonOf(cell);
    }
    mRows.push_back(row);
    mOut << line << std::endl; // flushed: the next row may take a minute
}

void Table::addFailure(const std::string &name, const std::string &reason)
{
    ++mFailures;
    mRows.push_back({{mColumns.front().key, name}, {"error", reason}});
    mOut << padded(name, mColumns.front().width, true) << "  FAILED: " << reason << std::endl;
}

void Table::note(const std::string &text)
{
    mNotes.push_back(text);
    mOut << text << std::endl;
}

nlohmann::ordered_json Table::json() const
{
    return {{"title", mTitle}, {"rows", mRows}, {"notes", mNotes}};
}

} // namespace ductus
