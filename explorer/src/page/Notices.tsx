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
        <svg class="ring" viewBox="0 0 36 36" aria-hidden="true" fill="none">
          <circle cx="18" cy="18" r="15" />
        </svg>
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
