/** The pendulum in space on a canvas of two dimensions, where there is no WebGL. */

import { drawBrass, drawHollow } from "./brass";
import { FLOOR, type Camera, type Point } from "./camera";
import { trace } from "./floor";
import { placed, type Scene, type SceneRenderer, type Strand } from "./scene";
import { drawWay } from "./way";

export class FlatRenderer implements SceneRenderer {
  private readonly context: CanvasRenderingContext2D;
  private size: readonly [number, number] = [0, 0];

  constructor(private readonly canvas: HTMLCanvasElement) {
    this.context = canvas.getContext("2d") as CanvasRenderingContext2D;
  }

  resize(width: number, height: number, density: number): void {
    this.size = [width, height];
    this.canvas.width = Math.round(width * density);
    this.canvas.height = Math.round(height * density);
    this.context.setTransform(density, 0, 0, density, 0, 0);
  }

  draw(scene: Scene): void {
    const { context } = this;
    context.clearRect(0, 0, ...this.size);
    context.save();
    clipToFloor(context, scene.camera, scene.floorRadius);
    for (const strand of scene.strands) if (strand.onFloor) drawStrand(context, scene, strand);
    context.restore();
    for (const bob of scene.bobs) if (!bob.ring) drawShadow(context, scene, bob.at, bob.radius, bob.alpha);
    drawThreads(context, scene);
    for (const strand of scene.strands) if (!strand.onFloor) drawStrand(context, scene, strand);
    for (const bob of scene.bobs) {
      const { x, y, scale } = scene.camera.project(bob.at);
      if (bob.ring) drawHollow(context, x, y, 0.62 * bob.radius * scale, scene.ink, bob.ring, 2.4);
      else drawBrass(context, x, y, bob.radius * scale, scene.ink, bob.alpha);
    }
  }

  dispose(): void {
    this.context.clearRect(0, 0, ...this.size);
  }
}

function clipToFloor(context: CanvasRenderingContext2D, camera: Camera, radius: number): void {
  const rim = Array.from({ length: 64 }, (_, step) => {
    const angle = (step / 64) * 2 * Math.PI;
    return camera.project([radius * Math.cos(angle), radius * Math.sin(angle), FLOOR]);
  });
  trace(context, rim);
  context.clip();
}

function drawShadow(context: CanvasRenderingContext2D, scene: Scene, at: Point, radius: number, alpha: number): void {
  const { x, y, scale } = scene.camera.project([at[0], at[1], FLOOR]);
  if (Math.hypot(at[0], at[1]) > scene.floorRadius) return;
  context.save();
  context.translate(x, y);
  context.scale(1, Math.sin(scene.camera.elevation));
  const size = 1.5 * radius * scale;
  const blob = context.createRadialGradient(0, 0, 0, 0, 0, size);
  blob.addColorStop(0, `rgb(0 0 0 / ${0.34 * alpha})`);
  blob.addColorStop(1, "rgb(0 0 0 / 0)");
  context.fillStyle = blob;
  context.fillRect(-size, -size, 2 * size, 2 * size);
  context.restore();
}

function drawThreads(context: CanvasRenderingContext2D, scene: Scene): void {
  const support = scene.camera.project([0, 0, 0]);
  context.strokeStyle = scene.ink.color[scene.threads.length > 1 ? "soft" : "ink"];
  context.lineWidth = (scene.rod ? 3 : 1.4) * scene.ink.weight;
  for (const end of scene.threads) {
    const at = scene.camera.project(end);
    trace(context, [support, at]);
    context.stroke();
  }
}

function drawStrand(context: CanvasRenderingContext2D, scene: Scene, strand: Strand): void {
  drawWay(context, strand, strand.width, (...at) => {
    const [px, py, pz] = placed(...at, strand.stretch);
    const { x, y } = scene.camera.project([px, py, strand.onFloor ? FLOOR : pz]);
    return [x, y];
  });
}
