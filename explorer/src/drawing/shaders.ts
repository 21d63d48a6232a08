/** What the graphics processor does for a strand, a bob and its shadow. */

/** From space to the screen: three rows of the camera, its lens in px, and the size of the canvas. */
const PROJECTION = /* glsl */ `
  uniform vec4 right, up, depth;
  uniform float focal;
  uniform vec2 centre, size;
  vec2 pixel(vec3 at) {
    vec4 one = vec4(at, 1.0);
    return centre + focal / dot(depth, one) * vec2(dot(right, one), -dot(up, one));
  }
  vec4 screen(vec2 px) { return vec4(2.0 * px.x / size.x - 1.0, 1.0 - 2.0 * px.y / size.y, 0.0, 1.0); }
`;

export const STRAND_VERTEX = /* glsl */ `
  ${PROJECTION}
  attribute vec3 start, end;
  attribute vec2 along;
  uniform float stretch, floorHeight, width, head, count, capacity;
  uniform vec2 fade;
  uniform bool onFloor, dashed;
  varying float side, alpha, travelled;
  varying vec2 flat_;
  vec3 placed(vec3 point) {
    vec3 at = vec3(stretch * point.xy, point.z - 1.0);
    if (stretch != 1.0) at.z = -sqrt(max(0.0, 1.0 - dot(at.xy, at.xy)));
    if (onFloor) at.z = floorHeight;
    return at;
  }
  void main() {
    // The segment from point i to i + 1 is as old as its newer end.
    float age = mod(head - float(gl_InstanceID) - 1.0 + capacity, capacity);
    vec3 from = placed(start), to = placed(end);
    vec2 a = pixel(from), b = pixel(to);
    vec2 way = b - a;
    float length_ = length(way);
    vec2 dir = length_ > 1e-6 ? way / length_ : vec2(1.0, 0.0);
    float half_ = 0.5 * width + 0.75;
    vec2 px = mix(a, b, position.x) + dir * (position.x - 0.5) * (dashed ? 0.0 : 0.5) + vec2(-dir.y, dir.x) * position.y * half_;
    side = position.y * half_;
    travelled = mix(along.x, along.y, position.x);
    flat_ = mix(from, to, position.x).xy;
    float share = floor(clamp(age / max(count - 2.0, 1.0), 0.0, 1.0) * 36.0) / 36.0;
    alpha = mix(fade.x, fade.y, share);
    gl_Position = age > count - 1.5 ? vec4(2.0, 2.0, 2.0, 1.0) : screen(px);
  }
`;

export const STRAND_FRAGMENT = /* glsl */ `
  precision highp float;
  uniform vec3 color;
  uniform float width, floorRadius;
  uniform vec4 dash;
  uniform bool onFloor, dashed;
  varying float side, alpha, travelled;
  varying vec2 flat_;
  void main() {
    if (onFloor && dot(flat_, flat_) > floorRadius * floorRadius) discard;
    float off = abs(side) - 0.5 * width;
    if (dashed) {
      float place = mod(travelled, dash.x + dash.y + dash.z + dash.w);
      float second = place - dash.x - dash.y;
      // How far from the nearer dash, px: negative on it; what is shorter than 1 px is a dot with a round edge.
      float first = max(-place, place - dash.x);
      float other = dash.z > 0.0 ? max(-second, second - dash.z) : 1e3;
      float wrapped = dash.x + dash.y + dash.z + dash.w - place;
      float gap = min(min(first, other), wrapped);
      if (dash.x < 1.0) off = length(vec2(max(gap, 0.0), side)) - 0.5 * width;
      else off = max(off, gap);
    }
    float cover = clamp(0.5 - off, 0.0, 1.0);
    if (cover <= 0.0) discard;
    gl_FragColor = vec4(color, alpha * cover);
  }
`;

export const DISC_VERTEX = /* glsl */ `
  ${PROJECTION}
  uniform vec3 at;
  uniform float radius, squash;
  varying vec2 place;
  varying float pixels;
  void main() {
    float scale = focal / dot(depth, vec4(at, 1.0));
    pixels = radius * scale;
    place = position.xy * (1.0 + 1.5 / pixels);
    gl_Position = screen(pixel(at) + place * vec2(1.0, squash) * pixels);
  }
`;

/** The same light on brass as on the canvas: from the upper left, with dark edges. */
export const BRASS_FRAGMENT = /* glsl */ `
  precision highp float;
  uniform vec3 light, middle, dark;
  uniform float alpha;
  varying vec2 place;
  varying float pixels;
  void main() {
    vec2 from = vec2(-0.35, -0.4);
    vec2 way = place - from;
    // The share of the way from the brightest point to the edge of the ball.
    float a = dot(way, way), b = dot(from, way), c = dot(from, from) - 1.0;
    float t = a > 1e-9 ? a / (-b + sqrt(max(b * b - a * c, 0.0))) : 0.0;
    vec3 shade = t < 0.42 ? mix(light, middle, t / 0.42) : mix(middle, dark, (t - 0.42) / 0.58);
    float cover = clamp(0.5 + (1.0 - length(place)) * pixels, 0.0, 1.0);
    gl_FragColor = vec4(shade, alpha * cover);
  }
`;

export const RING_FRAGMENT = /* glsl */ `
  precision highp float;
  uniform vec3 color, paper;
  uniform float width;
  varying vec2 place;
  varying float pixels;
  void main() {
    float from = length(place) * pixels;
    float line = clamp(0.5 * width + 0.5 - abs(from - pixels + 0.5 * width), 0.0, 1.0);
    float inside = clamp(0.5 + pixels - from, 0.0, 1.0);
    gl_FragColor = vec4(mix(paper, color, line), max(line, 0.85 * inside) * inside);
  }
`;

export const SHADOW_FRAGMENT = /* glsl */ `
  precision highp float;
  uniform float alpha;
  varying vec2 place;
  void main() {
    gl_FragColor = vec4(0.0, 0.0, 0.0, 0.34 * alpha * clamp(1.0 - length(place), 0.0, 1.0));
  }
`;
