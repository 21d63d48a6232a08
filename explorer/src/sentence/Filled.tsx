/** A sentence of the dictionary with controls and numbers in its holes. */

import { cloneElement, Fragment, isValidElement, type ComponentChildren, type JSX, type VNode } from "preact";

interface Props {
  readonly text: string;
  readonly holes: Readonly<Record<string, ComponentChildren>>;
}

/** Whether a hole holds a phrase, which may break, and not one control or number. */
const phrase = (hole: ComponentChildren): hole is VNode<Props> => isValidElement(hole) && hole.type === Filled;

export function Filled({ text, holes }: Props): JSX.Element {
  return (
    <>
      {text.split(/(\{\w+\}[.,:]?)/).map((part, index) => (
        <Fragment key={index}>{filled(part, holes)}</Fragment>
      ))}
    </>
  );
}

function filled(part: string, holes: Props["holes"]): ComponentChildren {
  const [, name = "", mark = ""] = /^\{(\w+)\}([.,:]?)$/.exec(part) ?? [];
  if (name === "") return part;
  const hole = holes[name];
  if (mark === "") return hole;
  // The mark after a phrase becomes its last sign; one after a number or a control stays on its line.
  if (phrase(hole)) return cloneElement(hole, { text: `${hole.props.text}${mark}` });
  return (
    <span style={{ whiteSpace: "nowrap" }}>
      {hole}
      {mark}
    </span>
  );
}
