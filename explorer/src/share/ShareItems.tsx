/** What can be taken away: the link, the job file, the numbers, and the picture with numbers. */

import { useState } from "preact/hooks";
import { shared } from "../state/address";
import { live, preset } from "../state/page";
import { words } from "../words/language";
import { csvOf, jobOf } from "./files";
import { picture } from "./picture";

/** How long "Copied" is said, ms. */
const SAID = 2000;

function save(content: BlobPart, type: string, ending: string): void {
  const address = URL.createObjectURL(new Blob([content], { type }));
  const link = document.createElement("a");
  link.href = address;
  link.download = `kugelpendel-${preset.value ?? "own"}.${ending}`;
  link.click();
  // The browser has taken it by then.
  setTimeout(() => URL.revokeObjectURL(address), 60_000);
}

export function ShareItems() {
  const [said, setSaid] = useState<"copied" | "failed" | null>(null);
  const say = words.value.share;
  const now = live.value;
  const copy = async (): Promise<void> => {
    try {
      await navigator.clipboard.writeText(shared());
      setSaid("copied");
    } catch {
      // Without a secure address or without leave there is no clipboard.
      setSaid("failed");
    }
    setTimeout(() => setSaid(null), SAID);
  };
  const savePicture = async (): Promise<void> => {
    const blob = await picture();
    if (blob) save(blob, "image/png", "png");
  };
  return (
    <>
      <button type="button" onClick={() => void copy()}>
        {said ? say[said] : say.link}
      </button>
      <span class="unseen" role="status">
        {said ? say[said] : ""}
      </span>
      <button type="button" disabled={!now} onClick={() => now && save(jobOf(now), "application/toml", "toml")}>
        {say.job}
      </button>
      <button type="button" disabled={!now} onClick={() => now && save(csvOf(now), "text/csv", "csv")}>
        {say.csv}
      </button>
      <button type="button" disabled={!now} onClick={() => void savePicture()}>
        {say.png}
      </button>
    </>
  );
}
