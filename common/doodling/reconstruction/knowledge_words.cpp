#include "doodling/reconstruction/knowledge_words.h"

namespace ductus {

KnowledgeWords knowledgeWords(const Shot &shot)
{
    switch (shot.knowledge) {
    case CameraKnowledge::SolvedCameras:
        return {"The camera moved, and its path is known.",
                "Canvases stay where they are put in the scene, and what is nearer hides them. How far away "
                "things that move by themselves are is judged by where they touch the ground."};
    case CameraKnowledge::RotationOnly:
        return {"The camera turned without moving far enough to show depth.",
                "Canvases stay where they are put. How far away things are is guessed: set it with the depth "
                "slider where something should pass in front."};
    case CameraKnowledge::Tripod:
        return {"The camera stood still.",
                "Canvases stay where they are put, or follow what moves. How far away things are is guessed: "
                "set it with the depth slider where something should pass in front."};
    }
    return {};
}

} // namespace ductus
