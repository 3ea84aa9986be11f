#include "document/commands/change_value.h"

namespace ductus {

quint64 nextDrag()
{
    static quint64 last = 0;
    return ++last;
}

} // namespace ductus
