// Opens and closes steps, opens them for print, shows what a link leads into, searches, copies LaTeX.
// The page reads, switches and prints without it.
const main = document.querySelector("main");
const folds = () => main.querySelectorAll("details");
for (const button of document.querySelectorAll("button[data-open]")) {
  button.hidden = false;
  button.addEventListener("click", () => {
    for (const fold of folds()) fold.open = button.dataset.open === "yes";
  });
}

let before = [];
window.addEventListener("beforeprint", () => {
  if (document.getElementById("length-short")?.checked) return;
  before = [...folds()].filter((fold) => fold.className !== "proof").map((fold) => [fold, fold.open]);
  for (const [fold] of before) fold.open = true;
});
window.addEventListener("afterprint", () => {
  for (const [fold, open] of before) fold.open = open;
  before = [];
});

function reveal() {
  const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
  if (!target) return;
  for (let fold = target.closest("details"); fold; fold = fold.parentElement.closest("details")) fold.open = true;
  target.scrollIntoView();
}
window.addEventListener("hashchange", reveal);
if (location.hash) reveal();
if (matchMedia("(max-width: 63.99rem)").matches) document.querySelector("nav details")?.removeAttribute("open");

// The search goes through numbers first, then through words and LaTeX.
const found = document.getElementById("found");
const field = document.getElementById("find");
const equations = [...main.querySelectorAll(".display")].map((display) => ({
  label: display.id.slice(3),
  id: display.id,
  said: display.querySelector("p").textContent.replace(/^\(\S+\)[‹›\s]*/, ""),
  latex: [...display.querySelectorAll("[data-latex]")].map((one) => one.dataset.latex).join(" "),
}));
field.form.hidden = false;
field.form.addEventListener("submit", (event) => {
  event.preventDefault();
  const first = found.querySelector("a");
  if (first) location.hash = first.hash;
});
field.addEventListener("input", () => {
  const sought = field.value.trim().toLowerCase();
  const number = sought.replace(/[()\s]/g, "");
  const bare = (text) => text.toLowerCase().replace(/\s/g, "");
  const rank = (one) => {
    if (one.label.toLowerCase() === number) return 0;
    if (one.label.toLowerCase().startsWith(number)) return 1;
    return one.said.toLowerCase().includes(sought) || bare(one.latex).includes(bare(sought)) ? 2 : 3;
  };
  const hits = sought ? equations.filter((one) => rank(one) < 3).sort((a, b) => rank(a) - rank(b)) : [];
  found.replaceChildren(...hits.slice(0, 12).map((one) => {
    const item = document.createElement("li");
    const link = document.createElement("a");
    const name = document.createElement("b");
    link.href = `#${one.id}`;
    name.textContent = `(${one.label}) `;
    link.append(name, one.said.length > 60 ? `${one.said.slice(0, 60)} …` : one.said);
    item.append(link);
    return item;
  }));
  if (sought && !hits.length) {
    const item = document.createElement("li");
    item.textContent = found.dataset.none;
    found.append(item);
  }
});

for (const formula of main.querySelectorAll("[data-latex]")) {
  const button = document.createElement("button");
  const label = formula.closest("[data-label]")?.dataset.label;
  button.type = "button";
  button.className = "copy";
  button.textContent = main.dataset.copy;
  button.setAttribute("aria-label", main.dataset.copyLong.replace("…", `(${label})`));
  button.addEventListener("click", async () => {
    try {
      await navigator.clipboard.writeText(formula.dataset.latex);
      button.textContent = main.dataset.copied;
      setTimeout(() => (button.textContent = main.dataset.copy), 1500);
    } catch {
      window.prompt(main.dataset.copy, formula.dataset.latex);
    }
  });
  formula.prepend(button);
}
