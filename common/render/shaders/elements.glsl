struct ElementData
{
    vec4 rows[3]; // scene from element: turned, scaled evenly, moved, possibly mirrored
    uint elementId;
    uint order; // place in its layer
    uint stackId;
    float scale;
};

layout(std430, binding = 0) readonly buffer Elements
{
    ElementData elements[];
};

vec3 turned(ElementData e, vec3 direction)
{
    return vec3(dot(e.rows[0].xyz, direction), dot(e.rows[1].xyz, direction), dot(e.rows[2].xyz, direction)) / e.scale;
}

vec3 relativeToEye(ElementData e, vec3 position)
{
    vec3 turnedPosition =
        vec3(dot(e.rows[0].xyz, position), dot(e.rows[1].xyz, position), dot(e.rows[2].xyz, position));
    return turnedPosition + (vec3(e.rows[0].w, e.rows[1].w, e.rows[2].w) - view.eyeInScene.xyz);
}
