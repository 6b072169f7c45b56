"use strict";
(function () {
  document.querySelectorAll("button.copy").forEach(function (button) {
    button.hidden = false;
    const label = button.firstChild;
    button.addEventListener("click", function () {
      copy(button.dataset.copy).then(
        function () { say(label, document.body.dataset.copied); },
        function () { say(label, document.body.dataset.press); }
      );
    });
  });

  function copy(text) {
    if (navigator.clipboard && window.isSecureContext) {
      return navigator.clipboard.writeText(text).catch(function () { return copyBySelection(text); });
    }
    return copyBySelection(text);
  }

  function copyBySelection(text) {
    const field = document.createElement("textarea");
    field.value = text;
    document.body.append(field);
    field.select();
    const done = document.execCommand("copy");
    field.remove();
    return done ? Promise.resolve() : Promise.reject();
  }

  function say(label, word) {
    const before = label.data;
    label.data = word;
    setTimeout(function () { label.data = before; }, 1500);
  }

  // only what scrolls is worth a stop of the Tab key
  const scrollers = document.querySelectorAll(".display[tabindex], .wide[tabindex]");
  function markStops() {
    scrollers.forEach(function (box) { box.tabIndex = box.scrollWidth > box.clientWidth ? 0 : -1; });
  }
  markStops();
  window.addEventListener("resize", markStops);

  document.querySelectorAll("form.filter").forEach(function (form) {
    const scope = form.parentElement;
    const items = Array.from(scope.querySelectorAll("[data-state]"));
    const search = form.querySelector("input[type=search]");
    const boxes = Array.from(form.querySelectorAll("input[type=checkbox]"));
    const shown = form.querySelector(".shown");
    form.hidden = false;

    function fold(text) {
      return text.normalize("NFD").replace(/[\u0300-\u036f]/g, "").toLowerCase();
    }

    function update() {
      const wanted = fold(search.value).split(/\s+/).filter(Boolean);
      const states = new Set(boxes.filter((box) => box.checked).map((box) => box.value));
      const all = boxes.every((box) => box.checked);
      let count = 0;
      items.forEach(function (item) {
        const words = fold(item.dataset.words + " " + item.textContent);
        const visible = (all || item.dataset.state.split(" ").some((state) => states.has(state)))
          && wanted.every((word) => words.includes(word));
        item.hidden = !visible;
        count += visible;
      });
      scope.querySelectorAll(".group").forEach(function (group) {
        group.hidden = !group.querySelector("[data-state]:not([hidden])");
      });
      shown.textContent = count === items.length ? "" : (shown.dataset.template || "{shown} of {total} shown").replace("{shown}", count).replace("{total}", items.length);
    }

    search.addEventListener("input", update);
    boxes.forEach((box) => box.addEventListener("change", update));
    form.addEventListener("submit", (event) => event.preventDefault());
  });
})();
