#include "project/migrations/migration_table.h"

namespace ductus {

void MigrationTable::add(const std::string &schema, int fromVersion, Step step)
{
    const bool isNew = mSteps.emplace(std::pair(schema, fromVersion), std::move(step)).second;
    DUCTUS_ASSERT(isNew);
}

Result<void> MigrationTable::migrate(OrderedJson &object, const std::string &schema, int version, int target,
                                     const std::string &place) const
try {
    for (; version < target; ++version) {
        const auto step = mSteps.find({schema, version});
        if (step == mSteps.end())
            return Error{ErrorCode::Unsupported, "Reading the project",
                         "there is no way to read " + schema + " version " + std::to_string(version), "",
                         place};
        if (Result<void> done = step->second(object); !done)
            return done;
        object["version"] = version + 1;
    }
    return {};
} catch (const nlohmann::json::exception &error) { // a step that trusted a hostile file
    return Error{ErrorCode::Malformed, "Upgrading " + schema + " version " + std::to_string(version),
                 error.what(), "", place};
}

} // namespace ductus
