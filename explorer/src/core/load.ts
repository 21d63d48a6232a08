/** The core, fetched and started. */
import type {
  Core, EllipseNow, Law, Measured, Motion, PlaneSettled, Portrait, Regime, Settled, StateLaunch, Summary, Verdict,
} from "./core";
import type { Given, Vector } from "./given";
import { Machine } from "./machine";
import { CoreMotion, LAWS } from "./motions";
import { portraitOf, VERDICTS } from "./portrait";
import { slots } from "./receive";

const REGIMES: readonly Regime[] = ["rest", "balance", "separatrix", "plane", "rotation", "cone", "ellipse", "above"];

/** Fetches the core and starts it; rejects where it cannot be had and where the browser cannot run it. */
export async function loadCore(): Promise<Core> {
  const response = await fetch(new URL("./kugelpendel.wasm", import.meta.url));
  if (!response.ok) throw new Error(`The core could not be fetched: ${response.status}.`);
  // Not while it streams: hosts that do not know its type could not serve it then.
  return startCore(await response.arrayBuffer());
}

/** Starts the core from its file's content. */
export async function startCore(content: BufferSource): Promise<Core> {
  const { instance } = await WebAssembly.instantiate(content);
  return new LoadedCore(new Machine(instance));
}

/** Numbers for which there is room from the start, 4 MB: traces and walks fit in, and views of the memory stay what they are. */
const RESERVED = 500_000;

class LoadedCore implements Core {
  private readonly machine: Machine;

  constructor(machine: Machine) {
    this.machine = machine;
    machine.call.release(machine.call.allocate(RESERVED), RESERVED);
  }

  get memory(): WebAssembly.Memory {
    return this.machine.call.memory;
  }

  get refusalKinds(): readonly string[] {
    return this.machine.refusalKinds();
  }

  motion(given: Given, law: Law): Motion {
    this.machine.put(slots(given));
    return new CoreMotion(this.machine, law);
  }

  summary(given: Given): Summary {
    const told = this.ask(given, () => this.machine.call.summary());
    const orNull = (value: number) => (Number.isNaN(value) ? null : value);
    return {
      regime: REGIMES[told(0)] ?? "rest",
      sense: told(1),
      frequency: told(2),
      precession: told(3),
      swingPeriod: told(4),
      radialPeriod: told(5),
      apsidalAngle: told(6),
      turning: told(7),
      wholeTurns: told(8) === 1,
      fullTurn: told(9),
      onceRound: told(10),
      largestAngle: told(11),
      formula25: orNull(told(12)),
      frequency26: orNull(told(13)),
      error25: orNull(told(14)),
      periodError26: orNull(told(15)),
      outer: told(16),
      inner: told(17),
      high: told(18),
      low: told(19),
      tension: [told(20), told(21)],
      slackTime: told(22),
      fastest: told(23),
    };
  }

  settled(given: Given): Settled {
    const told = this.ask(given, () => this.machine.call.settled());
    return {
      length: told(0),
      gravity: told(1),
      effectiveGravity: told(2),
      mass: told(3),
      angularFrequency: told(4),
      smallPeriod: told(5),
      speed: told(6),
      earth: told(7),
      earthTurn: told(8),
      acts: told(9) === 1,
      drag: { linear: told(10), quadratic: told(11) },
      anisotropy: told(12),
      dampingAnisotropy: told(13),
      halfLife: told(14),
      sustaining: told(15) > 0 ? { push: told(15), phase: told(16) } : null,
    };
  }

  measured(given: Given, law: Law): Measured {
    const told = this.ask(given, () => this.machine.call.measured(LAWS.indexOf(law)));
    const [frequency, precession, periodError, precessionError] = [0, 1, 2, 3].map((slot) => {
      const value = told(slot);
      return Number.isNaN(value) ? null : value;
    }) as [number | null, number | null, number | null, number | null];
    return { frequency, precession, periodError, precessionError };
  }

  nearestPlace(length: number, eye: Vector, direction: Vector): Vector {
    this.machine.put([length, ...eye, ...direction]);
    this.machine.call.nearest_place();
    return this.machine.vector(0);
  }

  nearestState(length: number, position: Vector, velocity: Vector): StateLaunch {
    this.machine.put([length, ...position, ...velocity]);
    this.machine.call.nearest_launch();
    return { kind: "state", position: this.machine.vector(0), velocity: this.machine.vector(3) };
  }

  portrait(given: Given, ellipse: EllipseNow): Portrait {
    const { a, b, azimuth } = ellipse;
    this.ask(given, () => this.machine.call.portrait(a, b, azimuth));
    return portraitOf(this.machine);
  }

  settles(given: Given): PlaneSettled | null {
    let known = false;
    const told = this.ask(given, () => {
      const answer = this.machine.call.settles();
      known = answer === 1;
      return answer;
    });
    if (!known) return null;
    return {
      verdict: VERDICTS[told(0)] as Verdict,
      from: told(1),
      until: told(2),
      turned: told(3),
      azimuths: [told(4), told(5)],
      widest: told(6),
      amplitude: told(7),
      dies: told(8) === 1,
    };
  }

  /** Gives, calls, and hands out what is told; throws what is refused. */
  private ask(given: Given, call: () => number): (slot: number) => number {
    this.machine.put(slots(given));
    if (call() === 0) throw this.machine.refusal();
    return (slot) => this.machine.at(slot);
  }
}
