/** What to look at in each example, in two sentences and two languages. */

export const PRESET_KEYS = [
  "rosette",
  "small",
  "straight",
  "cone",
  "over",
  "separatrix",
  "pantheon",
  "southpole",
  "equator",
  "short",
  "bravais",
  "guelph",
] as const;

export type PresetKey = (typeof PRESET_KEYS)[number];

export interface PresetWords {
  /** Under the drawing in the gallery. */
  readonly name: string;
  readonly title: string;
  readonly text: string;
}

export const presetsEn: Record<PresetKey, PresetWords> = {
  rosette: {
    name: "Rosette",
    title: "The ellipse that turns",
    text: "You expect an ellipse, but it never closes: each turning point lies a little further on. Many ellipses, all but alike, become a rosette.",
  },
  small: {
    name: "Small ellipse",
    title: "Small and patient",
    text: "The same motion, only smaller, and already the ellipse takes half an hour to turn once. Here the formulas can hardly be told from the truth.",
  },
  straight: {
    name: "Almost straight",
    title: "Straight is never quite straight",
    text: "Three metres long and a centimetre wide: to the eye, a line. And yet it turns, once round in 76 days.",
  },
  cone: {
    name: "Cone",
    title: "In a circle",
    text: "At 2.30 m/s the bob would run in a perfect circle. It has 4 % too much and nods on its way, each time at another place.",
  },
  over: {
    name: "Over the top",
    title: "Over the top",
    text: "Fast enough to fly over the support, but aimed just beside it. After each loop the path has turned back a little.",
  },
  separatrix: {
    name: "On the brink",
    title: "On the brink",
    text: "Almost straight above the support the bob all but stands still, then it falls. Up here every formula for small swings fails.",
  },
  pantheon: {
    name: "Panthéon 1851",
    title: "The floor is turning",
    text: "Three metres out on 67 m of wire, one swing in 16 s. In 32 hours the plane goes round once, because the floor turns below it.",
  },
  southpole: {
    name: "South Pole",
    title: "Once round a day",
    text: "At the pole the floor turns once below the pendulum in a day of the stars. In the south the plane goes counter-clockwise.",
  },
  equator: {
    name: "Equator",
    title: "Here nothing turns",
    text: "At the equator the floor does not turn about the vertical, and the plane stays where it is. Only a wide ellipse sets it moving.",
  },
  short: {
    name: "The one that stalls",
    title: "The plane stands still",
    text: "One metre of thread, and a little after two hours nothing turns any more. To blame is an ellipse narrower than an eye can see.",
  },
  bravais: {
    name: "Bravais",
    title: "Two circles",
    text: "Two bobs run in circles, one to the left, one to the right. The place where they meet moves as fast as Foucault’s plane.",
  },
  guelph: {
    name: "Guelph",
    title: "Hurrying and lagging",
    text: "On average as fast as the Earth, but every 8.7 hours the plane hurries and lags. A clamp uneven by 4 parts in 100,000 is enough.",
  },
};

export const presetsDe: Record<PresetKey, PresetWords> = {
  rosette: {
    name: "Rosette",
    title: "Die Ellipse, die sich dreht",
    text: "Man erwartet eine Ellipse, doch sie schließt sich nicht: Jeder Umkehrpunkt liegt ein Stück weiter. Aus lauter fast gleichen Ellipsen wird eine Rosette.",
  },
  small: {
    name: "Kleine Ellipse",
    title: "Klein und geduldig",
    text: "Dieselbe Bewegung, nur kleiner, und schon braucht die Ellipse eine halbe Stunde für eine Drehung. Die Formeln sind hier fast nicht mehr vom Wahren zu unterscheiden.",
  },
  straight: {
    name: "Fast gerade",
    title: "Gerade ist nie ganz gerade",
    text: "Drei Meter lang, ein Zentimeter breit: für das Auge ein Strich. Und doch dreht er sich, in 76 Tagen einmal herum.",
  },
  cone: {
    name: "Kegel",
    title: "Im Kreis",
    text: "Mit 2,30 m/s liefe die Kugel genau im Kreis. Sie hat 4 % zu viel und nickt dabei, jedes Mal an einer anderen Stelle.",
  },
  over: {
    name: "Über Kopf",
    title: "Über Kopf",
    text: "Schnell genug für den Flug über die Aufhängung, aber knapp daneben gezielt. Nach jedem Überschlag ist die Bahn ein Stück zurückgedreht.",
  },
  separatrix: {
    name: "Auf der Kippe",
    title: "Auf der Kippe",
    text: "Fast senkrecht über der Aufhängung steht die Kugel beinahe still, dann fällt sie. Hier oben versagt jede Formel für kleine Ausschläge.",
  },
  pantheon: {
    name: "Panthéon 1851",
    title: "Der Boden dreht sich",
    text: "Drei Meter Ausschlag an 67 m Draht, eine Schwingung in 16 s. In 32 Stunden geht die Ebene einmal herum, weil sich der Boden unter ihr dreht.",
  },
  southpole: {
    name: "Südpol",
    title: "Einmal am Tag herum",
    text: "Am Pol dreht sich der Boden an einem Sterntag einmal unter dem Pendel weg. Auf der Südhalbkugel geht die Ebene gegen den Uhrzeigersinn.",
  },
  equator: {
    name: "Äquator",
    title: "Hier dreht sich nichts",
    text: "Am Äquator dreht sich der Boden nicht um die Lotrechte, und die Ebene bleibt, wo sie ist. Erst eine breite Ellipse bringt sie in Bewegung.",
  },
  short: {
    name: "Bleibt stehen",
    title: "Die Ebene steht still",
    text: "Ein Meter Faden, und nach gut zwei Stunden dreht sich nichts mehr. Schuld ist eine Ellipse, schmaler, als ein Auge sieht.",
  },
  bravais: {
    name: "Bravais",
    title: "Zwei Kreise",
    text: "Zwei Kugeln laufen im Kreis, eine links herum, eine rechts herum. Wo sie einander begegnen, wandert so schnell wie Foucaults Ebene.",
  },
  guelph: {
    name: "Guelph",
    title: "Eilen und Zögern",
    text: "Im Mittel so schnell wie die Erde, aber alle 8,7 Stunden eilt die Ebene und zögert. Eine um 4 Hunderttausendstel ungleiche Aufhängung genügt dafür.",
  },
};
