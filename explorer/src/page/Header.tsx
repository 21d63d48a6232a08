/** Mark, modes, and what the page can be switched to. */

import { useRef, useState } from "preact/hooks";
import type { Language } from "../numbers/spell";
import { kiosk, theme } from "../state/page";
import { language, words } from "../words/language";
import { Book, Corners, Dots, HalfDisc, Link, Mark } from "./icons";
import { Popover } from "./Popover";
import { Languages, Modes } from "./Switches";
import { derivation } from "../sentence/ReadOut";
import { ShareItems } from "../share/ShareItems";

const THEMES = ["system", "light", "dark"] as const;

function nextTheme(): void {
  theme.value = THEMES[(THEMES.indexOf(theme.value) + 1) % THEMES.length] ?? "system";
}

function fullScreen(): void {
  if (document.fullscreenElement) void document.exitFullscreen();
  // A browser may refuse: then nothing changes.
  else void document.documentElement.requestFullscreen().catch(() => undefined);
}

export function Header() {
  const say = words.value;
  return (
    <header>
      <a class="skip" href="#given">
        {say.header.skip}
      </a>
      <div class="brand">
        <Mark />
        <span>{say.name}</span>
      </div>
      <Modes />
      {!kiosk.value && <Tools />}
      {kiosk.value ? (
        <div class="tools">
          <Languages inFull />
        </div>
      ) : null}
    </header>
  );
}

function Tools() {
  const say = words.value.header;
  const share = useRef<HTMLButtonElement>(null);
  const more = useRef<HTMLButtonElement>(null);
  const [open, setOpen] = useState<"share" | "more" | null>(null);
  const close = (): void => setOpen(null);
  const themeLabel = `${say.theme}: ${say.themeNow[theme.value]}`;
  const other: Language = language.value === "de" ? "en" : "de";
  return (
    <div class="tools">
      <a class="tool only-wide" href={derivation()} target="_blank" rel="noopener" aria-label={say.derivation}>
        <Book />
        <span aria-hidden="true">{say.derivation}</span>
      </a>
      <button ref={share} class="tool only-wide" type="button" aria-label={say.share} aria-haspopup="dialog" aria-expanded={open === "share"} onClick={() => setOpen(open === "share" ? null : "share")}>
        <Link />
        <span aria-hidden="true">{say.share}</span>
      </button>
      <button class="tool only-wide" type="button" aria-label={themeLabel} title={themeLabel} onClick={nextTheme}>
        <HalfDisc />
      </button>
      <button class="tool only-wide wide-screen" type="button" aria-label={say.fullScreen} title={say.fullScreen} onClick={fullScreen}>
        <Corners />
      </button>
      <Languages />
      <button class="tool only-narrow" type="button" lang={other} onClick={() => (language.value = other)}>
        {other.toUpperCase()}
        <span class="unseen"> {say.other}</span>
      </button>
      <button ref={more} class="tool only-narrow" type="button" aria-label={say.more} aria-haspopup="dialog" aria-expanded={open === "more"} onClick={() => setOpen(open === "more" ? null : "more")}>
        <Dots />
      </button>
      {open === "share" && share.current && (
        <Popover anchor={share.current} label={say.share} kind="menu" close={close}>
          <ShareItems />
        </Popover>
      )}
      {open === "more" && more.current && (
        <Popover anchor={more.current} label={say.more} kind="menu" close={close}>
          <a href={derivation()} target="_blank" rel="noopener">
            {say.derivation}
          </a>
          <ShareItems />
          <button type="button" onClick={nextTheme}>
            {themeLabel}
          </button>
        </Popover>
      )}
    </div>
  );
}
