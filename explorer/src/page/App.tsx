/** The page: one lit space, with text and instruments on it. */

import { Formulas } from "../instruments/Formulas";
import { Gallery } from "../instruments/Gallery";
import { PlanView } from "../instruments/PlanView";
import { TimeBar } from "../instruments/TimeBar";
import { Globe } from "../foucault/Globe";
import { NowSentence } from "../foucault/NowSentence";
import { PortraitView } from "../foucault/PortraitView";
import { SharesView } from "../foucault/SharesView";
import { Follows } from "../sentence/Follows";
import { Given } from "../sentence/Given";
import { Stage } from "../stage/Stage";
import { mode, preset, ruling } from "../state/page";
import { presetWords, words } from "../words/language";
import { Header } from "./Header";
import { LiveRegion } from "./LiveRegion";
import { Notices } from "./Notices";

export function App() {
  const shown = preset.value ? presetWords.value[preset.value] : null;
  const free = mode.value === "free";
  return (
    <div class="page" data-mode={mode.value}>
      <Header />
      <main class={ruling.value ? "text ruling" : "text"}>
        <h1 class="title">{shown?.title ?? words.value.gallery.own}</h1>
        {shown && <p class="preset-text">{shown.text}</p>}
        <Given />
        <section aria-label={words.value.follows.label}>{free ? <Follows /> : <NowSentence />}</section>
        {!free && <Globe />}
      </main>
      <Stage />
      <aside class="side">
        <PlanView />
        {free ? (
          <Formulas />
        ) : (
          mode.value === "foucault" && (
            <>
              <SharesView />
              <PortraitView />
            </>
          )
        )}
      </aside>
      <TimeBar />
      <Gallery />
      <Notices />
      <LiveRegion />
    </div>
  );
}
