// A private depth that grows with the drawing order: what comes later passes GL_LESS, what belongs to the same
// element does not, so that each colours a sample once. Multiples of 2^-23 in 1/2..1 are exact.
uniform uint orderBase;

float orderDepth(uint order)
{
    return 1.0 - float(orderBase + order + 1u) * 1.1920928955078125e-7;
}
