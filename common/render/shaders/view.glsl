// What every shader knows of the view. Positions are in scene units relative to the eye: they keep their digits far
// from the origin.
layout(std140, binding = 0) uniform View
{
    mat4 clipFromRelative;
    vec4 rayDirection[3]; // through the frame's lower left corner, a pixel's step to the right, one up
    vec4 eyeInScene;
    vec4 forward;         // w: depth of which nothing is nearer
    vec4 limits;          // x: smallest depth that is seen
} view;

// Of the sample, where there are several.
#ifdef SAMPLES
#define FRAGMENT_PLACE (floor(gl_FragCoord.xy) + gl_SamplePosition)
#else
#define FRAGMENT_PLACE gl_FragCoord.xy
#endif

// From the eye; as long as depth grows by 1, so that a ray's parameter is depth.
vec3 rayThrough(vec2 fragment)
{
    return view.rayDirection[0].xyz + fragment.x * view.rayDirection[1].xyz + fragment.y * view.rayDirection[2].xyz;
}

// Nearer is larger, and floats keep their digits at every distance.
float depthValue(float depth)
{
    return view.forward.w / depth;
}

vec3 encoded(vec3 linear)
{
    return mix(1.055 * pow(max(linear, vec3(0.0031308)), vec3(1.0 / 2.4)) - 0.055, 12.92 * linear,
               lessThanEqual(linear, vec3(0.0031308)));
}

vec3 toBlendSpace(vec3 linear)
{
#ifdef LINEAR_BLENDING
    return linear;
#else
    return encoded(linear);
#endif
}
