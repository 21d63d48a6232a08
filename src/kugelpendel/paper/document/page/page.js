// Opens and closes all steps; opens everything for print and whatever a link leads into.
const folds = () => document.querySelectorAll("main details");
for (const button of document.querySelectorAll("button[data-open]")) {
  button.addEventListener("click", () => {
    for (const fold of folds()) fold.open = button.dataset.open === "yes";
  });
}
let before = [];
window.addEventListener("beforeprint", () => {
  before = [...folds()].map((fold) => [fold, fold.open]);
  for (const [fold] of before) fold.open = true;
});
window.addEventListener("afterprint", () => {
  for (const [fold, open] of before) fold.open = open;
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
