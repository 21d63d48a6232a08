/** A state as a job file, and its motion as a table. */

import { writeJobFile } from "../job";
import type { Live } from "../state/live";
import { averaging, duration, preset } from "../state/page";
import { fill, words } from "../words/language";

/** Rows of the table. */
const ROWS = 2001;

export function jobOf(now: Live): string {
  const file = `kugelpendel-${preset.value ?? "own"}.toml`;
  return `# ${fill(words.value.share.jobNote, { file })}\n\n${writeJobFile(now.given, duration.value)}`;
}

/**
 * The motion that is shown, from its start to the end of the timeline: the bob's place, or the mean
 * ellipse where that is what is drawn. Numbers have a decimal point in both languages.
 */
export function csvOf(now: Live): string {
  const say = words.value.csv;
  const times = Float64Array.from({ length: ROWS }, (_, index) => (duration.value * index) / (ROWS - 1));
  const rows: string[] = [];
  if (averaging.value && now.averaged) {
    const motion = now.averaged;
    while (!motion.reach(duration.value) && !motion.ended);
    rows.push([say.time, say.a, say.b, say.azimuth].join(","));
    const azimuths = motion.azimuths(times);
    times.forEach((time, index) => {
      const ellipse = motion.ellipse(time);
      if (ellipse) rows.push([time, ellipse.a, ellipse.b, ((azimuths[index] ?? 0) * 180) / Math.PI].join(","));
    });
  } else {
    const { motion } = now.main;
    while (!motion.reach(duration.value) && !motion.ended);
    rows.push([say.time, say.x, say.y, say.z].join(","));
    const places = motion.positions(times);
    times.forEach((time, index) => {
      const place = places.subarray(3 * index, 3 * index + 3);
      if (!Number.isNaN(place[0])) rows.push([time, ...place].join(","));
    });
  }
  return `${rows.join("\n")}\n`;
}
