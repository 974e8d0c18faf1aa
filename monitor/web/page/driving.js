// SPDX-License-Identifier: GPL-3.0-or-later
// Driving and stopping: keys, the pad, gamepads, and all events that end a movement. A
// held key or button drives; when the last one is released the robot stops.

const KEYS = {
  ArrowUp: "RGFW", ArrowDown: "RGBW", ArrowLeft: "RGLF", ArrowRight: "RGRI",
  KeyW: "RGFW", KeyS: "RGBW", KeyA: "RGLF", KeyD: "RGRI",
};

// A click of a screen reader cannot be held: it moves a short distance
const STEPS = {
  RGFW: ["RMOV", 50], RGBW: ["RMOV", -50], RGLF: ["RTRN", 15], RGRI: ["RTRN", -15],
};

// Of a gamepad: the buttons of its cross, and how far its stick is to be moved
const CROSS = { 12: "RGFW", 13: "RGBW", 14: "RGLF", 15: "RGRI" };
const STICK = 0.5;

// By eighths of a turn, from the right, y downwards. The robot cannot drive a
// curve: on a diagonal it drives and turns, each for an ALTERNATE
const EIGHTHS = ["RGRI", "RGBW RGRI", "RGBW", "RGBW RGLF", "RGLF", "RGFW RGLF",
  "RGFW", "RGFW RGRI"];
const ALTERNATE = 250;             // ms
const SLOP = 20;                   // CSS pixels that a finger slides at least

const direction = (x, y) => EIGHTHS[Math.round(Math.atan2(y, x) / Math.PI * 4 + 8) % 8];

function gamepadOrder({ axes: [x = 0, y = 0], buttons }) {
  const pressed = Object.keys(CROSS).find((n) => buttons[n]?.pressed);
  if (pressed) return CROSS[pressed];
  return Math.hypot(x, y) < STICK ? "" : direction(x, y);
}

const TEXT = new Set(["text", "search", "password", "email", "url", "tel"]);

export const writes = (element) => element?.tagName === "TEXTAREA" ||
  element?.isContentEditable ||
  (element?.tagName === "INPUT" && TEXT.has(element.type));

// Elements that use arrows and letters themselves
export const takesKeys = (element) => writes(element) ||
  element?.tagName === "SELECT" ||
  (element?.tagName === "INPUT" && ["number", "range"].includes(element.type));

export class Driving {
  // page: order (label, value, quiet), mayDrive (), whyNot (), hint (),
  // mission (), stopped ()
  constructor(page) {
    this.page = page;
    this.letters = true;           // they drive as the arrows do
    this.held = new Map();         // what is held: its order, the oldest first
    this.moving = false;           // a movement was ordered and no stop since
    this.refused = false;          // the last movement was
    this.gamepad = { order: "", stops: false };
  }

  get current() { return [...this.held.values()].pop() ?? ""; }

  press(source, label) {
    if (!this.page.mayDrive()) {
      this.page.whyNot();
      return;
    }
    const before = this.current;
    this.held.delete(source);
    this.held.set(source, label);
    this.follow(before);
  }

  release(source) {
    const before = this.current;
    if (!this.held.delete(source)) return;
    this.follow(before);
  }

  follow(before) {
    const { current } = this;
    if (current === before) return;
    this.show();
    // The reason for the refused movement is more useful than that of its stop
    if (current === "") this.order("RSTP", undefined, () => this.refused);
    else this.drive(current);
  }

  // What is held, as long as it is
  async drive(current) {
    const turn = Symbol(current);
    this.turn = turn;
    const labels = current.split(" ");
    for (let n = 0; this.turn === turn && this.current === current; n = 1 - n) {
      await this.order(labels[n]);
      if (labels.length === 1) break;
      await new Promise((resolve) => setTimeout(resolve, ALTERNATE));
    }
  }

  async order(label, value, quiet) {
    const stops = label === "RSTP";
    if (!stops) this.moving = true;
    const result = await this.page.order(label, value, quiet);
    if (!stops) this.refused = ["ACRJ", "ANAK", "NOLINK"].includes(result.answer);
    else if (result.answer === "AACK" && this.held.size === 0) this.moving = false;
    return result;
  }

  // Releases everything; keys still pressed count when pressed again
  letGo() {
    this.held.clear();
    this.show();
  }

  show() {
    const { current } = this;
    document.documentElement.dataset.held = current;
    for (const button of document.querySelectorAll("[data-order]"))
      button.classList.toggle("held", current.split(" ").includes(button.dataset.order));
  }

  stop() {
    this.letGo();
    return this.order("RSTP");
  }

  // When the page or the user's focus is lost
  stopIfMoving() {
    if (this.moving || this.held.size > 0) this.stop();
    else this.letGo();
  }

  listen() {
    addEventListener("keydown", (event) => this.keyDown(event), true);
    addEventListener("keyup", (event) => this.keyUp(event), true);
    addEventListener("gamepadconnected", () => {
      cancelAnimationFrame(this.looking);
      this.lookAtGamepads();
    });
    for (const button of document.querySelectorAll("[data-order]"))
      this.listenToPad(button);
  }

  keyDown(event) {
    if (event.isComposing) return;
    if (event.code === "Space" || event.key === " ") {
      // A blank of a text is written, too, and stops only the writer's own robot
      if (writes(event.target)) {
        if (!event.repeat && this.page.mayDrive() && (this.moving || this.page.mission()))
          this.page.stopped();
        return;
      }
      event.preventDefault();
      event.stopPropagation();
      if (!event.repeat) this.page.stopped();
      return;
    }
    if (event.key === "Escape") {
      if (!event.repeat) this.page.stopped();
      return;
    }
    // With one of these held, some systems do not report the other's release
    if (["Control", "Alt", "Meta"].includes(event.key)) {
      if (this.held.size > 0) this.stop();
      return;
    }
    const label = KEYS[event.code];
    if (!label || event.ctrlKey || event.altKey || event.metaKey) return;
    if (!this.letters && !event.code.startsWith("Arrow")) return;
    if (takesKeys(event.target) || document.querySelector("dialog[open]")) return;
    // For a viewer who does not drive, arrows scroll
    if (!this.page.mayDrive()) {
      if (!event.repeat) this.page.hint();
      return;
    }
    event.preventDefault();
    if (!event.repeat) this.press("key " + event.code, label);
  }

  // No event tells what is pressed. Only changes count, as with keys
  lookAtGamepads() {
    const there = navigator.getGamepads().filter(Boolean);
    const order = there.map(gamepadOrder).find(Boolean) ?? "";
    const stops = there.some(({ buttons }) => buttons.slice(0, 12).some((one) => one.pressed));
    const before = this.gamepad;
    this.gamepad = { order, stops };
    if (stops && !before.stops) this.page.stopped();
    else if (order && order !== before.order) this.press("gamepad", order);
    else if (!order) this.release("gamepad");
    if (there.length > 0) this.looking = requestAnimationFrame(() => this.lookAtGamepads());
  }

  keyUp(event) {
    // Firefox activates a button when space is released
    if ((event.code === "Space" || event.key === " ") && !writes(event.target))
      event.preventDefault();
    this.release("key " + event.code);
  }

  listenToPad(button) {
    const label = button.dataset.order;
    let from;                      // where a finger came down; nothing once it slides
    button.addEventListener("pointerdown", (event) => {
      if (event.button !== 0) return;
      from = [event.clientX, event.clientY];
      try { button.setPointerCapture(event.pointerId); } catch { /* is gone */ }
      this.press("pointer " + event.pointerId, label);
    });
    // A finger that slides on the pad drives as a stick would, from its middle
    button.addEventListener("pointermove", (event) => {
      const source = "pointer " + event.pointerId;
      if (event.pointerType === "mouse" || !this.held.has(source)) return;
      if (from && Math.hypot(event.clientX - from[0], event.clientY - from[1]) < SLOP) return;
      from = undefined;
      const pad = button.parentElement.getBoundingClientRect();
      const x = event.clientX - (pad.left + pad.right) / 2;
      const y = event.clientY - (pad.top + pad.bottom) / 2;
      if (Math.hypot(x, y) > pad.height / 8) this.press(source, direction(x, y));
    });
    for (const end of ["pointerup", "pointercancel", "lostpointercapture"])
      button.addEventListener(end, (event) => this.release("pointer " + event.pointerId));
    button.addEventListener("contextmenu", (event) => event.preventDefault());
    button.addEventListener("keydown", (event) => {
      if (event.key !== "Enter") return;
      event.preventDefault();
      if (!event.repeat) this.press("button " + label, label);
    });
    button.addEventListener("keyup", (event) => {
      if (event.key === "Enter") this.release("button " + label);
    });
    button.addEventListener("blur", () => this.release("button " + label));
    button.addEventListener("click", (event) => {
      if (event.detail !== 0) return;
      if (this.page.mayDrive()) this.order(...STEPS[label]);
      else this.page.whyNot();
    });
  }
}
