"use strict";
// The 3D view of an arm is 2 MB: it is loaded when it is asked for. Without this script there is a link to it.
for (const view of document.querySelectorAll("details.view")) {
  view.addEventListener("toggle", () => {
    if (!view.open || view.querySelector("iframe")) return;
    const frame = document.createElement("iframe");
    frame.src = view.dataset.page;
    frame.title = view.dataset.title;
    frame.setAttribute("sandbox", "allow-scripts");
    view.append(frame);
  });
}
// On a phone the contents do not stand before the lesson.
const contents = document.querySelector("details.contents");
if (contents && matchMedia("(max-width: 64rem)").matches) contents.open = false;
