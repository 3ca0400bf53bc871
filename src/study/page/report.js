// The viewer of two pictures under a divider. All pictures lie on the stage, one above the other;
// draw() shows the two that are chosen and cuts the left one off at the divider.

const byId = (id) => document.getElementById(id);
const viewer = byId("viewer");
const stage = byId("stage");
const divider = byId("divider");
const pictures = [...stage.querySelectorAll(".picture")].map((figure) => ({
  figure,
  colour: figure.querySelector(".colour"),
  error: figure.querySelector(".error"),
  caption: figure.querySelector("figcaption"),
  label: figure.querySelector("b").textContent,
}));
// Decoded beforehand, so that a flip does not flicker.
await Promise.allSettled([...stage.querySelectorAll("img")].map((image) => image.decode()));
const width = pictures[0].colour.naturalWidth || 1;
const height = pictures[0].colour.naturalHeight || 1;
const levels = [1, 2, 3, 4, 6, 8, 12, 16, 24, 32];

const state = {
  left: 0,
  right: Math.min(1, pictures.length - 1),
  split: 0.5, // of the visible part of the picture
  whole: "", // "left" or "right" while that one is shown in full
  errors: false,
  zoom: 1, // pixels of the screen for one of the picture
  x: 0, // where the picture begins on the stage
  y: 0,
};

// Pixels of the page for one of the picture.
const scale = () => state.zoom / window.devicePixelRatio;

// All of the picture; at a whole number of pixels where it can be.
function fitZoom() {
  const room = Math.min(stage.clientWidth / width, (0.88 * window.innerHeight) / height);
  const zoom = room * window.devicePixelRatio;
  return zoom < 1 ? zoom : Math.min(Math.floor(zoom), levels.at(-1));
}

function visiblePart() {
  const begin = Math.max(0, state.x);
  return { begin, length: Math.min(stage.clientWidth, state.x + width * scale()) - begin };
}

// Centred when all of it has room; else without a gap at either side.
function place(offset, length, room) {
  const free = room - length;
  const snapped = Math.round(offset * window.devicePixelRatio) / window.devicePixelRatio;
  return free >= 0 ? free / 2 : Math.min(0, Math.max(free, snapped));
}

function drawPictures(cut) {
  const { left, right, whole } = state;
  pictures.forEach((picture, i) => {
    const style = picture.figure.style;
    const shown = (i === left && whole !== "right") || (i === right && whole !== "left");
    style.visibility = shown ? "visible" : "hidden";
    style.zIndex = i === left ? 1 : 0;
    style.clipPath = i === left && left !== right && !whole ? `inset(0 ${cut}px 0 0)` : "none";
    style.left = `${state.x}px`;
    style.top = `${state.y}px`;
    style.width = `${width * scale()}px`;
    style.height = `${height * scale()}px`;
    picture.colour.hidden = state.errors && picture.error !== null;
    if (picture.error) picture.error.hidden = !state.errors;
  });
}

function drawCaption(element, index, shown) {
  const { caption, error } = pictures[index];
  const note = state.errors ? (error ? " (error map)" : " (no error map)") : "";
  element.hidden = !shown;
  if (element.dataset.shown === index + note) return; // nothing new to read out
  element.dataset.shown = index + note;
  element.replaceChildren(...caption.cloneNode(true).childNodes, note);
}

function drawDivider(position) {
  const percent = Math.round(100 * state.split);
  const labels = [pictures[state.left].label, pictures[state.right].label];
  divider.hidden = state.left === state.right;
  divider.style.left = `${position}px`;
  divider.setAttribute("aria-valuenow", percent);
  divider.setAttribute("aria-valuetext",
    state.whole ? `all ${pictures[state[state.whole]].label}`
      : `${percent} % ${labels[0]}, ${100 - percent} % ${labels[1]}`);
}

function draw() {
  state.x = place(state.x, width * scale(), stage.clientWidth);
  state.y = place(state.y, height * scale(), stage.clientHeight);
  const part = visiblePart();
  const position = part.begin + state.split * part.length;
  drawPictures(state.x + width * scale() - position);
  drawDivider(position);
  drawCaption(byId("left-caption"), state.left, state.whole !== "right");
  drawCaption(byId("right-caption"), state.right, state.whole !== "left");
  stage.classList.toggle("reduced", state.zoom < 1);
  stage.classList.toggle("movable", width * scale() > stage.clientWidth + 0.5 ||
    height * scale() > stage.clientHeight + 0.5);
  stage.classList.toggle("flipped", state.whole !== "");
  byId("left").selectedIndex = state.left;
  byId("right").selectedIndex = state.right;
  byId("errors").setAttribute("aria-pressed", state.errors);
  byId("zoom-level").value = `${Number(state.zoom.toFixed(2))} \u00d7`;
}

function change(values) {
  Object.assign(state, values);
  draw();
}

const moveSplit = (split) => change({ split: Math.min(1, Math.max(0, split)), whole: "" });
const flip = () => change({ whole: state.whole === "left" ? "right" : "left" });
const toggleErrors = () => change({ errors: !state.errors });

let fitted = { width: 0, zoom: 0 };
function fit() {
  fitted = { width: stage.clientWidth, zoom: fitZoom() };
  state.zoom = fitted.zoom;
  stage.style.height = `${height * scale()}px`;
  draw();
}

// One level in (+1) or out (-1), about a point of the stage. False at the last level.
function zoomBy(step, x = stage.clientWidth / 2, y = stage.clientHeight / 2) {
  const all = [fitted.zoom, ...levels.filter((level) => level > fitted.zoom)];
  const zoom = step > 0 ? all.find((level) => level > state.zoom)
    : all.findLast((level) => level < state.zoom);
  if (!zoom) return false;
  const ratio = zoom / state.zoom;
  change({ zoom, x: x - (x - state.x) * ratio, y: y - (y - state.y) * ratio });
  return true;
}

// Calls move(event) while a pointer that went down on the element is held.
function onDrag(element, begin, move) {
  element.addEventListener("pointerdown", (event) => {
    if (event.button !== 0 || !begin(event)) return;
    element.setPointerCapture(event.pointerId);
    element.addEventListener("pointermove", move);
    const end = () => element.removeEventListener("pointermove", move);
    element.addEventListener("lostpointercapture", end, { once: true });
  });
}

let grip = { x: 0, y: 0 }; // from the pointer to what it drags
onDrag(divider, (event) => {
  const box = divider.getBoundingClientRect();
  grip = { x: box.left + box.width / 2 - event.clientX, y: 0 };
  event.stopPropagation();
  return true;
}, (event) => {
  const part = visiblePart();
  const x = event.clientX + grip.x - stage.getBoundingClientRect().left;
  moveSplit((x - part.begin) / part.length);
});
onDrag(stage, (event) => {
  grip = { x: state.x - event.clientX, y: state.y - event.clientY };
  return stage.classList.contains("movable");
}, (event) => change({ x: event.clientX + grip.x, y: event.clientY + grip.y }));

let wheel = 0; // since the last level, in pixels; touch pads send many small parts
stage.addEventListener("wheel", (event) => {
  if (event.ctrlKey) return; // the browser's own zoom
  const step = event.deltaY < 0 ? 1 : -1;
  const before = state.zoom;
  wheel = Math.sign(wheel) === -step ? wheel : 0;
  wheel += event.deltaMode === 0 ? event.deltaY : 40 * event.deltaY;
  const box = stage.getBoundingClientRect();
  if (Math.abs(wheel) >= 50) {
    wheel = 0;
    zoomBy(step, event.clientX - box.left, event.clientY - box.top);
  }
  // At the first and the last level the wheel scrolls the page.
  const canZoom = step > 0 ? before < levels.at(-1) : before > fitted.zoom;
  if (canZoom) event.preventDefault();
}, { passive: false });

// A digit chooses the picture on the left, or the one that is shown in full; with Shift the right.
function choose(event, index) {
  if (index >= pictures.length) return false;
  change({ [event.shiftKey ? "right" : state.whole || "left"]: index });
  return true;
}

const directions = { ArrowLeft: [1, 0], ArrowRight: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

function onKey(event) {
  const onDivider = event.target === divider;
  const step = 0.02;
  const direction = event.shiftKey && directions[event.key];
  if (direction) {
    const pan = 0.1 * stage.clientWidth;
    return change({ x: state.x + pan * direction[0], y: state.y + pan * direction[1] }), true;
  }
  const digit = /^(?:Digit|Numpad)([1-9])$/.exec(event.code);
  if (digit) return choose(event, digit[1] - 1);
  switch (event.key) {
    case "ArrowLeft": return moveSplit(state.split - step), true;
    case "ArrowRight": return moveSplit(state.split + step), true;
    case "f": case "F": return flip(), true;
    case "e": case "E": return toggleErrors(), true;
    case "Escape": return change({ whole: "" }), true;
    case "+": case "=": return zoomBy(1), true;
    case "-": return zoomBy(-1), true;
    case "0": return fit(), true;
  }
  if (!onDivider && event.target !== document.body) return false;
  if (event.key === " ") return flip(), true;
  if (!onDivider) return false; // the page scrolls with the keys below
  switch (event.key) {
    case "ArrowDown": return moveSplit(state.split - step), true;
    case "ArrowUp": return moveSplit(state.split + step), true;
    case "PageDown": return moveSplit(state.split - 0.1), true;
    case "PageUp": return moveSplit(state.split + 0.1), true;
    case "Home": return moveSplit(0), true;
    case "End": return moveSplit(1), true;
  }
  return false;
}
document.addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.altKey || event.metaKey) return;
  if (event.target.closest("select, .scroll")) return; // these have their own keys
  if (onKey(event)) event.preventDefault();
});

byId("left").addEventListener("change", (event) => change({ left: event.target.selectedIndex }));
byId("right").addEventListener("change", (event) => change({ right: event.target.selectedIndex }));
byId("flip").addEventListener("click", flip);
byId("errors").addEventListener("click", toggleErrors);
byId("errors").hidden = pictures.every((picture) => !picture.error);
byId("zoom-in").addEventListener("click", () => zoomBy(1));
byId("zoom-out").addEventListener("click", () => zoomBy(-1));
byId("fit").addEventListener("click", fit);
// Not for a new height alone: the bars of a phone's browser come and go while the page scrolls.
window.addEventListener("resize", () => stage.clientWidth !== fitted.width && fit());

byId("controls").hidden = byId("help").hidden = false;
viewer.classList.add("live");
fit();
