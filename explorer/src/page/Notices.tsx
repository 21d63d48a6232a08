/** What the page has to say about itself, until it is closed. */

import { notice } from "../state/page";
import { asking } from "./kiosk";
import { fill, language, words } from "../words/language";
import { refusal } from "../words/sentences";

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
      {notice.value === "link" ? say.link : fill(say.refused, { sentence: refusal(notice.value, language.value) })}
      <button type="button" aria-label={say.close} onClick={() => (notice.value = null)}>
        ×
      </button>
    </div>
  );
}
