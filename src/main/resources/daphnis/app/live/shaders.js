// Shaders of WebGL 2. A sphere is a square that faces the eye, and the fragment shader asks for each pixel where its
// line of sight meets the sphere: silhouettes, shading and depth are exact at every size, for four corners a sphere.

const COLOUR = `
uniform vec3 uMap[8];
uniform vec2 uRange;      // the numbers at the ends of the colour bar
uniform int uKind;        // 0 linear, 1 by logarithm, 2 one colour for each number
vec3 colourOf(float value) {
    if (uKind == 2) return uMap[int(value + 0.5) % 8];
    float t = uKind == 1 ? log(max(value, 1e-37) / uRange.x) / log(uRange.y / uRange.x)
                         : (value - uRange.x) / (uRange.y - uRange.x);
    if (!(uRange.x < uRange.y)) t = 0.5;
    float place = clamp(t, 0.0, 1.0) * 7.0;
    int k = min(int(place), 6);
    return mix(uMap[k], uMap[k + 1], place - float(k));
}
`;

const HEAD = `#version 300 es
precision highp float;
precision highp int;
`;

const ATTRIBUTES = `
layout(location = 0) in float aX;
layout(location = 1) in float aY;
layout(location = 2) in float aZ;
layout(location = 3) in float aRadius;
layout(location = 4) in float aValue;
uniform float uScale;     // of lengths, so that no square of one is too large or small for a float
uniform mat4 uView;       // to the eye, which looks along -z
uniform mat4 uProjection;
uniform float uFocus;     // pixels for a length of 1 at a distance of 1
uniform vec3 uBody;
uniform bool uIsBody;
`;

export const SPHERE_VERTEX = HEAD + ATTRIBUTES + COLOUR + `
out vec3 vPoint;
flat out vec3 vCentre;
flat out float vRadius;
flat out vec3 vColour;
flat out int vIsSmall;
void main() {
    vec3 c = (uView * vec4(vec3(aX, aY, aZ) * uScale, 1.0)).xyz;
    float radius = aRadius * uScale;
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
    float d = length(c);
    vCentre = c;
    vRadius = radius;
    vColour = uIsBody ? uBody : colourOf(aValue);
    // Less than a pixel: a pixel, or it would flicker.
    float pixel = -c.z / uFocus;
    vIsSmall = radius < pixel ? 1 : 0;
    if (d <= radius || c.z >= 0.0) {
        gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
        vPoint = c;
        return;
    }
    // The cone of all tangents from the eye cuts the plane through the centre, across the line of sight, in a circle of
    // this radius, which is more than that of the sphere.
    float size = vIsSmall == 1 ? 0.75 * pixel : radius * d / sqrt((d - radius) * (d + radius));
    vec3 ahead = c / d;
    vec3 right = normalize(cross(ahead, abs(ahead.y) < 0.9 ? vec3(0, 1, 0) : vec3(1, 0, 0)));
    vec3 up = cross(right, ahead);
    vPoint = c + (right * corner.x + up * corner.y) * size;
    gl_Position = uProjection * vec4(vPoint, 1.0);
}
`;

/** The colour and depth of a pixel at which a line of sight, a unit vector, may meet a sphere. */
const MEETING = `
uniform mat4 uProjection;
uniform bool uIsFlat;     // discs, which are seen from above
out vec4 colour;
void meet(vec3 ray, vec3 centre, float radius, bool isSmall, vec3 paint) {
    vec3 hit = centre;
    float light = 0.9;
    if (!isSmall) {
        // The nearest point of the line to the centre, by its offset from it: no difference of large numbers.
        vec3 foot = (uIsFlat ? ray * (centre.z / ray.z) : ray * dot(ray, centre)) - centre;
        float inside = radius * radius - dot(foot, foot);
        if (inside < 0.0) discard;
        if (!uIsFlat) {
            vec3 offset = foot - ray * sqrt(inside);
            hit = centre + offset;
            vec3 normal = offset / radius;
            light = 0.38 + 0.62 * max(0.0, dot(normal, normalize(vec3(-0.35, 0.5, 0.8))));
        } else if (inside < 0.16 * radius * radius) {
            light = 0.6;
        }
    }
    vec4 clip = uProjection * vec4(hit, 1.0);
    gl_FragDepth = clamp(0.5 * clip.z / clip.w + 0.5, 0.0, 1.0);
    colour = vec4(paint * light, 1.0);
}
`;

const SPHERE = `
flat in vec3 vCentre;
flat in float vRadius;
flat in vec3 vColour;
flat in int vIsSmall;
`;

export const SPHERE_FRAGMENT = HEAD + MEETING + SPHERE + `
in vec3 vPoint;
void main() { meet(normalize(vPoint), vCentre, vRadius, vIsSmall == 1, vColour); }
`;

// The same of a point in place of a square, for many spheres that are small in the picture: one corner each. A point
// whose centre is outside the picture is not drawn, and devices have a largest one.
export const DOT_VERTEX = HEAD + ATTRIBUTES + COLOUR + `
flat out vec3 vCentre;
flat out float vRadius;
flat out vec3 vColour;
flat out int vIsSmall;
void main() {
    vec3 c = (uView * vec4(vec3(aX, aY, aZ) * uScale, 1.0)).xyz;
    float radius = aRadius * uScale;
    vCentre = c;
    vRadius = radius;
    vColour = uIsBody ? uBody : colourOf(aValue);
    gl_Position = uProjection * vec4(c, 1.0);
    float z = max(-c.z, 1.001 * radius);
    vIsSmall = radius * uFocus < z ? 1 : 0;
    // Off the middle of the picture a sphere is an ellipse, longer by the distance over the depth.
    gl_PointSize = vIsSmall == 1 ? 1.5 : 1.0 + 2.1 * radius * uFocus / sqrt(z * z - radius * radius) * length(c) / z;
}
`;

export const DOT_FRAGMENT = HEAD + MEETING + SPHERE + `
uniform vec2 uPixels;     // width and height of the picture
void main() {
    vec2 place = (2.0 * gl_FragCoord.xy / uPixels - 1.0) / vec2(uProjection[0][0], uProjection[1][1]);
    meet(normalize(vec3(place, -1.0)), vCentre, vRadius, vIsSmall == 1, vColour);
}
`;

// Very many spheres: points of about their size, of which the driver makes pixels without a loop over corners.
export const POINT_VERTEX = HEAD + ATTRIBUTES + COLOUR + `
flat out vec3 vColour;
flat out int vIsRound;
void main() {
    vec4 c = uView * vec4(vec3(aX, aY, aZ) * uScale, 1.0);
    gl_Position = uProjection * c;
    float size = 2.0 * aRadius * uScale * uFocus / max(-c.z, 1e-30);
    gl_PointSize = clamp(size, 1.0, 48.0);
    vIsRound = size > 2.5 ? 1 : 0;
    vColour = uIsBody ? uBody : colourOf(aValue);
}
`;

export const POINT_FRAGMENT = HEAD + `
flat in vec3 vColour;
flat in int vIsRound;
out vec4 colour;
void main() {
    float light = 0.9;
    if (vIsRound == 1) {
        vec2 p = gl_PointCoord * 2.0 - 1.0;
        float inside = 1.0 - dot(p, p);
        if (inside < 0.0) discard;
        light = 0.38 + 0.62 * max(0.0, dot(vec3(p.x, -p.y, sqrt(inside)), normalize(vec3(-0.35, 0.5, 0.8))));
    }
    colour = vec4(vColour * light, 1.0);
}
`;

export const LINE_VERTEX = HEAD + `
layout(location = 0) in vec3 aPlace;
uniform float uScale;
uniform mat4 uView;
uniform mat4 uProjection;
void main() { gl_Position = uProjection * uView * vec4(aPlace * uScale, 1.0); }
`;

export const LINE_FRAGMENT = HEAD + `
uniform vec3 uInk;
out vec4 colour;
void main() { colour = vec4(uInk, 1.0); }
`;
