/**
 * Stands in for the canvases of the page while its picture is taken: what is drawn is kept as SVG.
 * It knows what the page's drawings use, and nothing else.
 */
(() => {
  const shape = (number) => String(Math.round(number * 10) / 10);

  /** #rrggbb and opacity of a colour as the page writes them. */
  function paint(color) {
    const found = /^rgb\((\d+) (\d+) (\d+) \/ ([\d.e-]+)\)$/.exec(color);
    if (!found) return [color, 1];
    const hex = found.slice(1, 4).map((one) => Number(one).toString(16).padStart(2, "0"));
    return [`#${hex.join("")}`, Number(found[4])];
  }

  let gradients = 0;

  class Gradient {
    constructor(kind, numbers) {
      [this.kind, this.numbers, this.stops, this.name] = [kind, numbers, [], `g${gradients++}`];
    }
    addColorStop(offset, color) {
      const [fill, opacity] = paint(color);
      this.stops.push(`<stop offset="${offset}" stop-color="${fill}" stop-opacity="${opacity}"/>`);
    }
    get svg() {
      const [a, b, c, d, e, f] = this.numbers.map(shape);
      const place = this.kind === "linear" ? `x1="${a}" y1="${b}" x2="${c}" y2="${d}"` : `fx="${a}" fy="${b}" fr="${c}" cx="${d}" cy="${e}" r="${f}"`;
      return `<${this.kind}Gradient id="${this.name}" gradientUnits="userSpaceOnUse" ${place}>${this.stops.join("")}</${this.kind}Gradient>`;
    }
  }

  class Recorder {
    constructor(canvas, measure) {
      Object.assign(this, { canvas, measure, fillStyle: "#000000", strokeStyle: "#000000", lineWidth: 1, lineCap: "butt", globalAlpha: 1 });
      Object.assign(this, { font: "12px sans-serif", textAlign: "left", textBaseline: "alphabetic", dash: [], path: "", svg: [], stack: [], move: "", mask: "" });
    }
    setTransform() {}
    clearRect() {
      this.svg = [];
    }
    save() {
      this.stack.push([this.move, this.mask]);
    }
    restore() {
      [this.move, this.mask] = this.stack.pop();
    }
    translate(x, y) {
      this.move += `translate(${shape(x)} ${shape(y)})`;
    }
    scale(x, y) {
      this.move += `scale(${x.toFixed(4)} ${y.toFixed(4)})`;
    }
    beginPath() {
      this.path = "";
    }
    moveTo(x, y) {
      this.path += `M${shape(x)} ${shape(y)}`;
    }
    lineTo(x, y) {
      this.path += `${this.path === "" ? "M" : "L"}${shape(x)} ${shape(y)}`;
    }
    closePath() {
      this.path += "Z";
    }
    rect(x, y, width, height) {
      this.path += `M${shape(x)} ${shape(y)}h${shape(width)}v${shape(height)}h${shape(-width)}Z`;
    }
    roundRect(x, y, width, height) {
      this.rect(x, y, width, height);
    }
    arc(x, y, radius) {
      // The page's drawings go once round.
      const [r, d] = [shape(radius), shape(2 * radius)];
      this.path += `M${shape(x - radius)} ${shape(y)}a${r} ${r} 0 1 0 ${d} 0a${r} ${r} 0 1 0 -${d} 0`;
    }
    clip() {
      const name = `c${gradients++}`;
      this.svg.push(`<clipPath id="${name}"><path d="${this.path}"/></clipPath>`);
      this.mask = ` clip-path="url(#${name})"`;
    }
    where() {
      return this.mask + (this.move ? ` transform="${this.move}"` : "");
    }
    color(style) {
      if (style instanceof Gradient) {
        this.svg.push(style.svg);
        return [`url(#${style.name})`, this.globalAlpha];
      }
      const [color, opacity] = paint(style);
      return [color, opacity * this.globalAlpha];
    }
    fill() {
      const [color, opacity] = this.color(this.fillStyle);
      this.svg.push(`<path d="${this.path}" fill="${color}" fill-opacity="${opacity.toFixed(2)}"${this.where()}/>`);
    }
    stroke() {
      const [color, opacity] = this.color(this.strokeStyle);
      const dash = this.dash.length > 0 ? ` stroke-dasharray="${this.dash.join(" ")}" stroke-linecap="${this.lineCap}"` : "";
      this.svg.push(`<path d="${this.path}" fill="none" stroke="${color}" stroke-opacity="${opacity.toFixed(2)}" stroke-width="${shape(this.lineWidth)}"${dash}${this.where()}/>`);
    }
    fillRect(x, y, width, height) {
      const kept = this.path;
      this.path = "";
      this.rect(x, y, width, height);
      this.fill();
      this.path = kept;
    }
    setLineDash(dash) {
      this.dash = dash;
    }
    measureText(text) {
      this.measure.font = this.font;
      return this.measure.measureText(text);
    }
    createRadialGradient(...numbers) {
      return new Gradient("radial", numbers);
    }
    createLinearGradient(...numbers) {
      return new Gradient("linear", numbers);
    }
    fillText(text, x, y) {
      const [color] = this.color(this.fillStyle);
      const anchor = { center: "middle", right: "end" }[this.textAlign] ?? "start";
      const [, weight, size] = /(\d{3})? *([\d.]+)px/.exec(this.font);
      const low = this.textBaseline === "middle" ? 0.35 * Number(size) : 0;
      this.svg.push(`<text x="${shape(x)}" y="${shape(y + low)}" text-anchor="${anchor}" font-size="${size}" font-weight="${weight ?? 400}" fill="${color}">${text}</text>`);
    }
  }

  const original = HTMLCanvasElement.prototype.getContext;
  const recorders = new Map();
  HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {
    if (kind !== "2d") return null;
    let found = recorders.get(this);
    if (!found) {
      const measure = original.call(document.createElement("canvas"), "2d", ...rest);
      recorders.set(this, (found = new Recorder(this, measure)));
    }
    return found;
  };
  window.recorded = (canvas) => recorders.get(canvas)?.svg.join("") ?? "";
})();
