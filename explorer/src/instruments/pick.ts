/** Another example, as it is picked by hand. */

import { redraw } from "../state/loop";
import { playing, reducedMotion } from "../state/page";
import { travelTo } from "../stage/travel";
import type { PresetKey } from "../words/presets";

export function pick(key: PresetKey): void {
  travelTo(key);
  playing.value = !reducedMotion.value;
  redraw();
}
