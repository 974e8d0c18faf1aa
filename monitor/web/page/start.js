// SPDX-License-Identifier: GPL-3.0-or-later
// The start button: control, robot, watchdog, camera, positions. A failure of
// the robot does not prevent the camera from opening, nor vice versa.

import { t } from "./words.js";

const STEPS = ["wheel", "robot", "watchdog", "camera", "positions"];
const WHEEL = 2000;                // ms to get a free wheel
const TRIES = 12;                  // of a start while the robot is starting up
const BETWEEN = 300;               // ms

const pause = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

const sentence = (words) => words.charAt(0).toUpperCase() + words.slice(1);

export class Starter {
  // page: order (label), state (), drives (), takeWheel ()
  constructor(page) {
    this.page = page;
    this.box = document.getElementById("start-progress");
    this.list = document.getElementById("start-steps");
    this.result = document.getElementById("start-result");
    this.steps = new Map();        // step: { result, why }
    this.running = false;
    this.outcome = "";
    document.getElementById("start-close").onclick = () => {
      this.clear();
      document.getElementById("start").focus();
    };
  }

  mark(step, result, why = "") {
    this.steps.set(step, { result, why });
    this.show();
  }

  show() {
    this.box.hidden = this.steps.size === 0;
    if (this.steps.size === 0) this.list.replaceChildren();
    for (const [step, { result, why }] of this.steps) {
      const item = this.list.querySelector(`[data-step="${step}"]`) ?? this.item(step);
      const [words, state, reason] = item.children;
      item.dataset.result = result;
      words.textContent = t("step_" + step);
      state.textContent = t("step_" + result);
      reason.textContent = why ? sentence(why()) : "";
    }
    this.result.hidden = this.outcome === "";
    document.getElementById("start-close").hidden = this.running;
    this.result.textContent = this.outcome && t(this.outcome);
  }

  item(step) {
    const item = document.createElement("li");
    item.dataset.step = step;
    // A screen reader announces the step with its result
    item.setAttribute("aria-atomic", "true");
    for (const name of ["span", "small", "p"]) item.append(document.createElement(name));
    this.list.append(item);
    return item;
  }

  clear() {
    this.steps.clear();
    this.outcome = "";
    this.show();
  }

  async run() {
    if (this.running) return;
    this.running = true;
    this.outcome = "";
    this.steps.clear();
    for (const step of STEPS) this.mark(step, "waiting");
    try {
      if (await this.wheel()) await this.both();
      else for (const step of STEPS.slice(1)) this.mark(step, "skipped");
    } finally {
      this.running = false;
      this.show();
    }
  }

  async wheel() {
    this.mark("wheel", "doing");
    if (!this.page.drives()) {
      if (this.page.state().driver === null) this.page.takeWheel();
      const end = performance.now() + WHEEL;
      while (!this.page.drives() && performance.now() < end &&
             this.page.state().driver === null) await pause(20);
    }
    const mine = this.page.drives();
    const driver = this.page.driverName();
    if (mine) this.mark("wheel", "done");
    else this.mark("wheel", "failed", () => driver
      ? t("wheel_first_ask", { name: driver }) : t("do_LOST"));
    return mine;
  }

  async both() {
    const first = await this.openAndStart();
    // The robot's start-up leaves time for the camera
    const [robot, camera] = await Promise.all([
      first === "ACRJ" ? this.startAgain() : first === "AACK",
      this.camera(),
    ]);
    this.outcome = robot && camera ? "start_ready" : robot ? "start_no_camera"
      : camera ? "start_no_robot" : "start_nothing";
  }

  fail(step, label, answer) {
    this.mark(step, "failed", () => this.page.refusal(label, answer));
    return answer;
  }

  // The answer to the first start
  async openAndStart() {
    const { robot } = this.page.state();
    this.mark("robot", "doing");
    if (robot === "closed" || robot === "lost") {
      const { answer } = await this.page.order("ROPN");
      if (answer !== "AACK") {
        this.mark("watchdog", "skipped");
        return this.fail("robot", "ROPN", answer) && "";
      }
    }
    this.mark("robot", "done");
    this.mark("watchdog", "doing");
    if (robot === "started") {
      this.mark("watchdog", this.page.state().watchdog ? "done" : "skipped",
        this.page.state().watchdog ? "" : () => t("watchdog_off"));
      return "AACK";
    }
    return this.started(await this.page.order("RSWW"));
  }

  started({ answer }) {
    if (answer === "AACK") this.mark("watchdog", "done");
    else if (answer === "ACRJ") this.mark("watchdog", "booting");
    else this.fail("watchdog", "RSWW", answer);
    return answer;
  }

  async startAgain() {
    for (let n = 1; n < TRIES && this.page.drives(); n += 1) {
      await pause(BETWEEN);
      const answer = this.started(await this.page.order("RSWW"));
      if (answer !== "ACRJ") return answer === "AACK";
    }
    this.fail("watchdog", "RSWW", "ACRJ");
    return false;
  }

  async camera() {
    this.mark("camera", "doing");
    if (!this.page.state().camera) {
      const { answer } = await this.page.order("COPN");
      if (answer !== "AACK") {
        this.mark("positions", "skipped");
        this.fail("camera", "COPN", answer);
        return false;
      }
    }
    this.mark("camera", "done");
    this.mark("positions", "doing");
    if (!this.page.state().positions) {
      const { answer } = await this.page.order("CPCO");
      if (answer !== "AACK") {
        this.fail("positions", "CPCO", answer);
        return false;
      }
    }
    this.mark("positions", "done");
    return true;
  }
}
