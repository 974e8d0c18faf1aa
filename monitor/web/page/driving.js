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

function gamepadOrder({ axes: [x = 0, y = 0], buttons }) {
  const pressed = Object.keys(CROSS).find((n) => buttons[n]?.pressed);
  if (pressed) return CROSS[pressed];
  if (Math.max(Math.abs(x), Math.abs(y)) < STICK) return "";
  if (Math.abs(y) >= Math.abs(x)) return y < 0 ? "RGFW" : "RGBW";
  return x < 0 ? "RGLF" : "RGRI";
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
    else this.order(current);
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
      button.classList.toggle("held", button.dataset.order === current);
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
    button.addEventListener("pointerdown", (event) => {
      if (event.button !== 0) return;
      try { button.setPointerCapture(event.pointerId); } catch { /* is gone */ }
      this.press("pointer " + event.pointerId, label);
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
