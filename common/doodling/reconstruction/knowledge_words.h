// What was found out about a clip's camera, in words for people who do not know what a camera path is.
#pragma once

#include "doodling/reconstruction/shot.h"

#include <string>

namespace ductus {

struct KnowledgeWords
{
    std::string mode;  // "The camera moved, and its path is known."
    std::string limit; // what that means for canvases
};

KnowledgeWords knowledgeWords(const Shot &shot);

} // namespace ductus
