// The list of all upgrade steps, oldest first. Version 1 is the first of every schema, so there is none yet.
#include "project/migrations/migration_table.h"

namespace ductus {

const MigrationTable &builtInMigrations()
{
    static const MigrationTable table;
    return table;
}

} // namespace ductus
