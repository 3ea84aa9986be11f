// A table that is printed row by row while its numbers are measured, and kept for the JSON report.
#pragma once

#include <nlohmann/json.hpp>
#include <ostream>
#include <string>
#include <variant>
#include <vector>

namespace ductus {

struct Column
{
    std::string key;     // in the JSON report
    std::string heading; // on paper
    int width = 8;
    int decimals = 0; // of numbers
};

/// Nothing (printed as "-", null in JSON), a text or a number.
using Cell = std::variant<std::monostate, std::string, double>;

class Table
{
public:
    /// Prints \a title and the headings. \a out must outlive the table.
    Table(std::ostream &out, const std::string &title, std::vector<Column> columns);

    /// Prints a row; cells left out at the end stay empty. The first column is aligned to the left.
    void add(const std::vector<Cell> &cells);

    /// A row whose measurement failed: the first cell and why.
    void addFailure(const std::string &name, const std::string &reason);

    /// A line of text below the rows so far; kept under "notes".
    void note(const std::string &text);

    int failures() const { return mFailures; }
    nlohmann::ordered_json json() const;

private:
    std::ostream &mOut;
    std::string mTitle;
    std::vector<Column> mColumns;
    nlohmann::ordered_json mRows = nlohmann::ordered_json::array();
    nlohmann::ordered_json mNotes = nlohmann::ordered_json::array();
    int mFailures = 0;
};

} // namespace ductus
