// What the update commands of all apps share: which options they take, and how they tell what has changed
// behind the links of a project.
#pragma once

#include "base/error.h"
#include "cli/batch_command.h"
#include "project/links/document_link.h"

#include <optional>
#include <string>
#include <vector>

namespace ductus {

struct UpdateOptions
{
    QCommandLineOption output, check, json;

    UpdateOptions();
    void addTo(BatchParser &parser) const;
};

struct LinkLine
{
    DocumentLink link;
    bool isChanged = false;
    std::optional<Error> problem; // why that could not be told
    const char *countName;        // in JSON, the number below
    int count = 0;
};

/// On standard output, after the command's work; \a none: what to say where there are no links.
void printLinks(const std::vector<LinkLine> &links, bool isUpdated, bool asJson, const std::string &none);

} // namespace ductus
