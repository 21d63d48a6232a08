/** The few signs of the page, drawn with lines in the colour of the text. */

import type { JSX } from "preact";

const line = { fill: "none", stroke: "currentColor", "stroke-width": 1.8, "stroke-linecap": "round", "stroke-linejoin": "round" } as const;

const sign = (children: JSX.Element): JSX.Element => (
  <svg viewBox="0 0 24 24" aria-hidden="true" {...line}>
    {children}
  </svg>
);

export const Book = () => sign(<path d="M12 6v13M12 6C10 4.500 6.500 4.500 3 5v13c3.500-.5 7-.5 9 1 2-1.500 5.500-1.500 9-1V5c-3.500-.5-7-.5-9 1" />);
export const Link = () => sign(<path d="M9.500 14.500l5-5M11 6.500l1.500-1.500a4.200 4.200 0 016 6L17 12.500M13 17.500L11.500 19a4.200 4.200 0 01-6-6L7 11.500" />);
export const HalfDisc = () =>
  sign(
    <>
      <circle cx="12" cy="12" r="8.500" />
      <path d="M12 3.500a8.500 8.500 0 000 17z" fill="currentColor" />
    </>,
  );
export const Corners = () => sign(<path d="M4 9V4h5M15 4h5v5M20 15v5h-5M9 20H4v-5" />);
export const Dots = () =>
  sign(
    <>
      <circle cx="5" cy="12" r="1.600" fill="currentColor" />
      <circle cx="12" cy="12" r="1.600" fill="currentColor" />
      <circle cx="19" cy="12" r="1.600" fill="currentColor" />
    </>,
  );
export const Hand = () =>
  sign(<path d="M8.500 12V5.300a1.700 1.700 0 013.400 0V10l5 1.100a2.500 2.500 0 012 2.800l-.6 3.600A4.200 4.200 0 0114.100 21h-2.300a4.500 4.500 0 01-3.500-1.700L5 14.700a1.600 1.600 0 012.400-2.100l1.100 1" />);
export const PauseSign = () => (
  <svg viewBox="0 0 24 24" aria-hidden="true" fill="currentColor">
    <rect x="5.500" y="4" width="4.500" height="16" rx="1" />
    <rect x="14" y="4" width="4.500" height="16" rx="1" />
  </svg>
);
export const PlaySign = () => (
  <svg viewBox="0 0 24 24" aria-hidden="true" fill="currentColor">
    <path d="M7 4.200v15.600a1 1 0 001.500.8l12.200-7.800a1 1 0 000-1.600L8.500 3.400A1 1 0 007 4.200z" />
  </svg>
);
export const StepSign = () => (
  <svg viewBox="0 0 24 24" aria-hidden="true" fill="currentColor">
    <path d="M5 4.800v14.400a.8.8 0 001.300.7l9.200-7.200a.9.9 0 000-1.400L6.300 4.100A.8.800 0 005 4.800z" />
    <rect x="17" y="4" width="2.600" height="16" rx="0.800" />
  </svg>
);

/** The mark: a pendulum over its ellipse. */
export const Mark = () => (
  <svg viewBox="0 0 32 32" aria-hidden="true">
    <path d="M9 5h14M17 5l-4 18" fill="none" stroke="currentColor" stroke-width="2" />
    <ellipse cx="17" cy="24" rx="13" ry="4" transform="rotate(-6 17 24)" fill="none" stroke="var(--accent)" stroke-width="2" />
    <circle cx="12" cy="23" r="4.600" fill="var(--brass)" stroke="var(--brass-dark)" stroke-width="0.800" />
  </svg>
);
