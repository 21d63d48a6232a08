/** The pendulum in space by WebGL: traces as fat instanced lines over the core's own memory. */

import {
  BufferGeometry,
  Camera as SceneCamera,
  Color,
  DoubleSide,
  Float32BufferAttribute,
  InstancedBufferAttribute,
  InstancedBufferGeometry,
  InstancedInterleavedBuffer,
  InterleavedBufferAttribute,
  LinearSRGBColorSpace,
  Mesh,
  Scene as Space,
  ShaderMaterial,
  Vector2,
  Vector3,
  Vector4,
  WebGLRenderer,
  type IUniform,
} from "three";
import { FLOOR, type Camera, type Point } from "./camera";
import { channels } from "./ink";
import type { Bob, Scene, SceneRenderer, Strand } from "./scene";
import { placed } from "./scene";
import { BRASS_FRAGMENT, DISC_VERTEX, RING_FRAGMENT, SHADOW_FRAGMENT, STRAND_FRAGMENT, STRAND_VERTEX } from "./shaders";

type Uniforms = Record<string, IUniform>;

const QUAD = new Float32BufferAttribute([0, -1, 0, 1, -1, 0, 1, 1, 0, 0, 1, 0], 3);
const SQUARE = new Float32BufferAttribute([-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0], 3);
const CORNERS = [0, 1, 2, 0, 2, 3];

interface StrandMesh {
  readonly mesh: Mesh<InstancedBufferGeometry, ShaderMaterial>;
  readonly source: Float32Array;
  readonly buffer: InstancedInterleavedBuffer;
  readonly along: InstancedBufferAttribute;
  /** Points that were there when it was last drawn: fewer of them mean that the trace has begun anew. */
  count: number;
}

export class SpaceRenderer implements SceneRenderer {
  private readonly renderer: WebGLRenderer;
  private readonly space = new Space();
  private readonly eye = new SceneCamera();
  private readonly lens: Uniforms = {
    right: { value: new Vector4() },
    up: { value: new Vector4() },
    depth: { value: new Vector4() },
    focal: { value: 1 },
    centre: { value: new Vector2() },
    size: { value: new Vector2(1, 1) },
  };
  private readonly strands = new Map<string, StrandMesh>();
  private readonly discs: Mesh<BufferGeometry, ShaderMaterial>[] = [];
  private readonly threads: Float32Array[] = [];
  private used = 0;

  /** Throws where the browser has no WebGL. */
  constructor(canvas: HTMLCanvasElement) {
    this.renderer = new WebGLRenderer({ canvas, alpha: true, antialias: false, depth: false, stencil: false, preserveDrawingBuffer: true });
    // Colours go through as the style sheet has them.
    this.renderer.outputColorSpace = LinearSRGBColorSpace;
    this.renderer.setClearColor(0, 0);
  }

  resize(width: number, height: number, density: number): void {
    this.renderer.setPixelRatio(density);
    this.renderer.setSize(width, height, false);
    (this.lens["size"] as IUniform<Vector2>).value.set(width, height);
  }

  draw(scene: Scene): void {
    this.look(scene.camera);
    this.used = 0;
    let order = 0;
    const seen = new Set<string>();
    const strand = (one: Strand): void => {
      seen.add(one.name);
      this.strand(one, scene).renderOrder = order++;
    };
    scene.strands.filter((one) => one.onFloor).forEach(strand);
    for (const bob of scene.bobs) if (!bob.ring) this.shadow(bob, scene).renderOrder = order++;
    scene.threads.forEach((end, index) => strand(this.thread(end, index, scene)));
    scene.strands.filter((one) => !one.onFloor).forEach(strand);
    for (const bob of scene.bobs) this.bob(bob, scene).renderOrder = order++;
    this.discs.forEach((disc, index) => (disc.visible = index < this.used));
    for (const [name, one] of this.strands) if (!seen.has(name)) this.forget(name, one);
    this.renderer.render(this.space, this.eye);
  }

  dispose(): void {
    for (const [name, one] of this.strands) this.forget(name, one);
    for (const disc of this.discs) disc.material.dispose();
    this.renderer.dispose();
  }

  private look(camera: Camera): void {
    const rows = camera.rows();
    ["right", "up", "depth"].forEach((name, row) => {
      const [x = 0, y = 0, z = 0, w = 0] = rows[row] ?? [];
      (this.lens[name] as IUniform<Vector4>).value.set(x, y, z, w);
    });
    const { focal, centre } = camera.lens;
    (this.lens["focal"] as IUniform<number>).value = focal;
    (this.lens["centre"] as IUniform<Vector2>).value.set(...centre);
  }

  private strand(strand: Strand, scene: Scene): Mesh {
    let found = this.strands.get(strand.name);
    if (!found || found.source.buffer !== strand.points.buffer || found.source.byteOffset !== strand.points.byteOffset || found.source.length !== strand.points.length) {
      if (found) this.forget(strand.name, found);
      found = this.made(strand);
      this.strands.set(strand.name, found);
      this.space.add(found.mesh);
    } else this.upload(found, strand);
    const { uniforms } = found.mesh.material;
    const count = strand.ring ? strand.ring.count : strand.count;
    const capacity = strand.ring ? strand.ring.capacity : Math.max(count, 1);
    found.mesh.geometry.instanceCount = strand.ring ? capacity : Math.max(count - 1, 0);
    const set = (name: string, value: unknown): void => void ((uniforms[name] as IUniform).value = value);
    set("color", color(strand.color));
    set("width", strand.width);
    set("stretch", strand.stretch);
    set("head", strand.ring ? strand.ring.head : count - 1);
    set("count", count);
    set("capacity", capacity);
    set("fade", new Vector2(...strand.alpha));
    set("onFloor", strand.onFloor);
    set("floorRadius", scene.floorRadius);
    const [a = 0, b = 0, c = 0, d = 0] = strand.dash;
    set("dashed", strand.dash.length > 0);
    set("dash", new Vector4(a, b, c, d));
    if (strand.dash.length > 0) measure(found.along, strand, scene.camera);
    return found.mesh;
  }

  private thread(end: Point, index: number, scene: Scene): Strand {
    const points = (this.threads[index] ??= new Float32Array(6));
    points.set([0, 0, 1, end[0], end[1], end[2] + 1]);
    return {
      name: `thread ${index}`,
      points,
      ring: null,
      count: 2,
      color: scene.ink.color[scene.threads.length > 1 ? "soft" : "ink"],
      width: (scene.rod ? 3 : 1.4) * scene.ink.weight,
      dash: [],
      alpha: [1, 1],
      stretch: 1,
      onFloor: false,
    };
  }

  private made(strand: Strand): StrandMesh {
    const buffer = new InstancedInterleavedBuffer(strand.points, 3, 1);
    const along = new InstancedBufferAttribute(new Float32Array(strand.ring ? 2 : 2 * (strand.points.length / 3)), 2);
    // Without dashes one pair of lengths serves every segment.
    if (strand.ring) along.meshPerAttribute = strand.ring.capacity + 1;
    const geometry = new InstancedBufferGeometry();
    geometry.setIndex(CORNERS);
    geometry.setAttribute("position", QUAD);
    geometry.setAttribute("start", new InterleavedBufferAttribute(buffer, 3, 0));
    geometry.setAttribute("end", new InterleavedBufferAttribute(buffer, 3, 3));
    geometry.setAttribute("along", along);
    const names = ["color", "width", "stretch", "head", "count", "capacity", "fade", "onFloor", "floorRadius", "dashed", "dash"];
    const own: Uniforms = Object.fromEntries(names.map((name) => [name, { value: 0 }]));
    const material = this.material(STRAND_VERTEX, STRAND_FRAGMENT, { ...own, floorHeight: { value: FLOOR } });
    const mesh = new Mesh(geometry, material);
    mesh.frustumCulled = false;
    return { mesh, source: strand.points, buffer, along, count: strand.ring?.count ?? 0 };
  }

  /** Sends what is new of a ring, in two pieces where it goes round, or all of a line. */
  private upload(found: StrandMesh, { ring }: Strand): void {
    if (ring && ring.count >= found.count) {
      const { changedFrom, head, capacity } = ring;
      const pieces = changedFrom <= head ? [[changedFrom, head]] : [[changedFrom, capacity], [0, head]];
      for (const [from = 0, to = 0] of pieces) found.buffer.addUpdateRange(3 * from, 3 * (to - from + 1));
      found.buffer.addUpdateRange(3 * capacity, 3);
    }
    found.count = ring?.count ?? 0;
    found.buffer.needsUpdate = true;
  }

  private material(vertexShader: string, fragmentShader: string, uniforms: Uniforms): ShaderMaterial {
    return new ShaderMaterial({
      vertexShader,
      fragmentShader,
      uniforms: { ...this.lens, ...uniforms },
      transparent: true,
      side: DoubleSide,
      depthTest: false,
      depthWrite: false,
    });
  }

  private forget(name: string, one: StrandMesh): void {
    this.space.remove(one.mesh);
    one.mesh.geometry.dispose();
    one.mesh.material.dispose();
    this.strands.delete(name);
  }

  private disc(fragment: string, at: Point, radius: number, squash: number, uniforms: Uniforms): Mesh {
    let disc = this.discs[this.used];
    if (!disc) {
      const geometry = new BufferGeometry();
      geometry.setIndex(CORNERS);
      geometry.setAttribute("position", SQUARE);
      disc = new Mesh(geometry, this.material(DISC_VERTEX, fragment, {}));
      disc.frustumCulled = false;
      this.discs.push(disc);
      this.space.add(disc);
    }
    this.used++;
    if (disc.material.fragmentShader !== fragment) {
      disc.material.dispose();
      disc.material = this.material(DISC_VERTEX, fragment, {});
    }
    Object.assign(disc.material.uniforms, uniforms, {
      at: { value: new Vector3(...at) },
      radius: { value: radius },
      squash: { value: squash },
    });
    return disc;
  }

  private shadow({ at, radius, alpha }: Bob, scene: Scene): Mesh {
    const inside = Math.hypot(at[0], at[1]) <= scene.floorRadius;
    return this.disc(SHADOW_FRAGMENT, [at[0], at[1], FLOOR], 1.5 * radius, Math.sin(scene.camera.elevation), {
      alpha: { value: inside ? alpha : 0 },
    });
  }

  private bob(bob: Bob, { ink }: Scene): Mesh {
    if (bob.ring)
      return this.disc(RING_FRAGMENT, bob.at, 0.62 * bob.radius, 1, {
        color: { value: color(bob.ring) },
        paper: { value: color(ink.color.paper) },
        width: { value: 2.4 },
      });
    return this.disc(BRASS_FRAGMENT, bob.at, bob.radius, 1, {
      light: { value: color(ink.color["brass-light"]) },
      middle: { value: color(ink.color.brass) },
      dark: { value: color(ink.color["brass-dark"]) },
      alpha: { value: bob.alpha },
    });
  }
}

const colors = new Map<string, Color>();

function color(text: string): Color {
  let found = colors.get(text);
  if (!found) {
    const [red, green, blue] = channels(text);
    colors.set(text, (found = new Color().setRGB(red / 255, green / 255, blue / 255, LinearSRGBColorSpace)));
  }
  return found;
}

/** The way along a line to each of its points, px, newest first so that the dashes go with the bob. */
function measure(along: InstancedBufferAttribute, strand: Strand, camera: Camera): void {
  const { points, count } = strand;
  let way = 0;
  let after: { x: number; y: number } | null = null;
  for (let index = count - 1; index >= 0; index--) {
    const base = 3 * index;
    const [x, y, z] = placed(points[base] ?? 0, points[base + 1] ?? 0, points[base + 2] ?? 0, strand.stretch);
    const here = camera.project([x, y, strand.onFloor ? FLOOR : z]);
    if (after) {
      const before = way;
      way += Math.hypot(after.x - here.x, after.y - here.y);
      along.setXY(index, way, before);
    }
    after = here;
  }
  along.needsUpdate = true;
}
