/** What the page has to say about itself, until it is closed. */

import { notice } from "../state/page";
import { asking } from "./kiosk";
import { words } from "../words/language";

export function Notices() {
  const say = words.value.notice;
  if (asking.value)
    return (
      <div class="still" role="alert">
        {words.value.kiosk.still}
      </div>
    );
  if (!notice.value) return null;
  return (
    <div class="notice" role="status">
      {say[notice.value]}
      <button type="button" aria-label={say.close} onClick={() => (notice.value = null)}>
        ×
      </button>
    </div>
  );
}
