// Upgrades of old objects, step by step, on plain JSON before any object exists: (schema, version v) ->
// version v+1. A step lives in a file of its own named after the version it leads to (sketch_surface_2.cpp)
// and is listed in built_in_migrations.cpp; a released step never changes.
#pragma once

#include "base/result.h"
#include "project/json/json_writer.h"

#include <functional>
#include <map>
#include <string>

namespace ductus {

class MigrationTable
{
public:
    /// Changes the object from one version to the next; needs not touch the field "version".
    using Step = std::function<Result<void>(OrderedJson &object)>;

    /// \a step leads from \a fromVersion to the next. A second step for the same version is a bug.
    void add(const std::string &schema, int fromVersion, Step step);

    /// Brings \a object from \a version up to \a target, setting its field "version" after every step.
    /// Unsupported if a step is missing; an error of a step ends it, \a object is then worthless. \a place is
    /// told in errors.
    Result<void> migrate(OrderedJson &object, const std::string &schema, int version, int target,
                         const std::string &place) const;

private:
    std::map<std::pair<std::string, int>, Step> mSteps;
};

/// The steps of all released versions.
const MigrationTable &builtInMigrations();

} // namespace ductus
