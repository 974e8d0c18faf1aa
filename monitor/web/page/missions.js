// SPDX-License-Identifier: GPL-3.0-or-later
// Missions: where to go by a click in the picture, along which path by clicks
// or a drag, or by centimetres; what is under way.

import { takesKeys } from "./driving.js";
import { news } from "./journal.js";
import { number, t } from "./words.js";

const MOST = 64;                   // points of a path
const SLOP = 6;                    // CSS pixels; a drag is longer
const APART = 3;                   // CSS pixels between two points of a drag
const CLOSE = 2;                   // CSS pixels that a drawn line may lose

const TRIES = 3;                   // of a mission while another is ending
const ENDING = 1000;               // ms for a mission to end

const NUMBER = /^-?\d{1,6}([.,]\d{1,6})?$/;

const pause = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

const at = (id) => document.getElementById(id);

// The distance of p from the straight line between a and b
function distance([px, py], [ax, ay], [bx, by]) {
  const length = Math.hypot(bx - ax, by - ay);
  if (length === 0) return Math.hypot(px - ax, py - ay);
  return Math.abs((bx - ax) * (py - ay) - (by - ay) * (px - ax)) / length;
}

// The points of a line without those that are nearer than the tolerance to
// what is left (Ramer, Douglas and Peucker)
function simplified(line, tolerance) {
  const last = line.length - 1;
  let farthest = 0;
  let most = tolerance;
  for (let n = 1; n < last; n += 1) {
    const far = distance(line[n], line[0], line[last]);
    if (far > most) {
      farthest = n;
      most = far;
    }
  }
  if (farthest === 0) return [line[0], line[last]];
  return [...simplified(line.slice(0, farthest + 1), tolerance).slice(0, -1),
    ...simplified(line.slice(farthest), tolerance)];
}

// Centimetres as typed, "20 30; 60 30.5": the points up to the first that is
// wrong, its text, and the key of the reason
export function readPoints(text) {
  const points = [];
  for (const part of text.split(";")) {
    const bad = part.trim();
    const words = bad.split(/\s+/);
    if (words.length % 2 !== 0 || !words.every((word) => NUMBER.test(word)))
      return { points, bad, wrong: "points_wrong" };
    // In "20,30 60,30" a comma may be within a number or between two
    const commas = words.filter((word) => word.includes(",")).length;
    if (commas > 1 || (commas === 1 && words.length > 2))
      return { points, bad, wrong: "points_ambiguous" };
    const numbers = words.map((word) => Number(word.replace(",", ".")));
    for (let n = 0; n < numbers.length; n += 2) {
      if (points.length === MOST) return { points, bad, wrong: "path_full" };
      points.push(numbers.slice(n, n + 2));
    }
  }
  return { points };
}

export class Missions {
  // page: order (label, points), report (label, points, answer), mayDrive (),
  // whyNot (), say (text key)
  constructor(picture, page) {
    this.picture = picture;
    this.page = page;
    this.path = false;             // clicks add points to the path
    this.strokes = [];             // of the path, not sent yet: the points of each
    this.stroke = undefined;       // { pointer, from, line, long }
    this.mission = null;           // under way
    this.wanted = undefined;       // the points of the one that is to begin
    this.target = [];              // a point clicked, until its mission is under way
    this.bad = [];                 // one that was refused
  }

  get points() { return this.strokes.flat(); }

  // ------------------------------------------------- where the user points

  listen() {
    const canvas = this.picture.picture;
    canvas.addEventListener("pointerdown", (event) => {
      if (event.button !== 0 || !event.isPrimary) return;
      if (takesKeys(document.activeElement)) {
        document.activeElement.blur();
        news(() => t("field_left"));
        return;
      }
      try { canvas.setPointerCapture(event.pointerId); } catch { /* is gone */ }
      this.stroke = { pointer: event.pointerId, from: [event.clientX, event.clientY],
        line: [], long: false };
      this.add(event);
    });
    canvas.addEventListener("pointermove", (event) => {
      if (event.pointerId !== this.stroke?.pointer) return;
      const [x, y] = this.stroke.from;
      const gone = Math.hypot(event.clientX - x, event.clientY - y);
      if (gone < (this.stroke.long ? APART : SLOP)) return;
      this.stroke.long = true;
      this.stroke.from = [event.clientX, event.clientY];
      this.add(event);
      if (this.page.mayDrive()) this.draw();
    });
    canvas.addEventListener("pointerup", (event) => {
      if (event.pointerId === this.stroke?.pointer) this.end();
    });
    for (const lost of ["pointercancel", "lostpointercapture"])
      canvas.addEventListener(lost, (event) => {
        if (event.pointerId !== this.stroke?.pointer) return;
        this.stroke = undefined;
        this.draw();
      });
    at("path-go").addEventListener("click", () => this.follow());
    at("path-undo").addEventListener("click", () => {
      this.strokes.pop();
      this.draw();
    });
    at("path-clear").addEventListener("click", () => {
      this.strokes = [];
      this.draw();
    });
  }

  add({ clientX, clientY }) {
    const pixel = this.picture.pixel(clientX, clientY);
    if (pixel) this.stroke.line.push(pixel);
  }

  end() {
    const { line, long } = this.stroke;
    this.stroke = undefined;
    if (line.length === 0) {
      this.draw();
    } else if (!this.page.mayDrive()) {
      this.page.whyNot();
    } else if (!long && !this.path) {
      this.send("MGTO", [line[0]]);
    } else {
      this.path = true;
      this.append(long ? line : [line[0]]);
    }
  }

  append(line) {
    const left = MOST - this.points.length;
    let added = line;
    let tolerance = CLOSE * this.picture.pixelSize;
    if (line.length > 1)
      do {
        added = simplified(line, tolerance);
        tolerance *= 1.5;
      } while (added.length > Math.max(left, 2));
    if (added.length > left) this.page.say("path_full");
    else this.strokes.push(added);
    this.draw();
  }

  // Path mode, by its button
  toggle() {
    this.path = !this.path;
    if (!this.path) this.strokes = [];
    this.draw();
  }

  // Nothing is left of what was not sent
  leave() {
    this.withdraw();
    if (this.path) this.toggle();
  }

  // A mission that has not begun does not begin
  withdraw() {
    this.wanted = undefined;
    this.target = [];
    this.bad = [];
    this.draw();
  }

  // In the place of the mission under way. Its answer, unless it was withdrawn
  async send(label, points) {
    this.wanted = points;
    this.target = label === "MGTO" ? points : [];
    this.bad = [];
    this.draw();
    let answer;
    for (let n = 0; n < TRIES && (n === 0 || answer === "ACRJ"); n += 1) {
      if (this.mission || answer) {
        await this.page.order("MABT");
        const end = performance.now() + ENDING;
        while (this.mission && performance.now() < end) await pause(20);
      }
      if (this.wanted !== points) return undefined;
      ({ answer } = await this.page.order(label, points));
    }
    if (this.wanted !== points) return answer;
    const { target } = this;
    if (answer === "AACK") this.wanted = undefined;
    else this.withdraw();
    if (answer === "ANAK") this.bad = target;
    this.draw();
    if (answer !== "LOST") this.page.report(label, points, answer);
    return answer;
  }

  async follow() {
    const { points, strokes } = this;
    if (points.length === 0) {
      this.page.say("path_empty");
      return;
    }
    const answer = await this.send("MPTH", points);
    // A path that was refused can be corrected
    if (answer === "AACK" && this.strokes === strokes && this.path) this.toggle();
  }

  // -------------------------------------------------------------- display

  // The mission under way, or null
  set(mission) {
    if (mission === this.mission) return;
    this.mission = mission;
    // Until ours is under way, it may be the one before
    if (mission && !this.wanted) this.target = [];
    this.draw();
    this.show();
  }

  draw() {
    const { picture } = this;
    const line = this.stroke?.long ? this.stroke.line : [];
    picture.plan = this.target.length > 0 ? { unit: "px", points: this.target, leg: 1 } : this.mission;
    picture.bad = this.bad;
    const { points } = this;
    picture.path = [...points, ...line];
    picture.draw();
    at("path").setAttribute("aria-pressed", String(this.path));
    at("path-tools").hidden = !this.path;
    at("path-go").textContent = t("path_go", { n: points.length });
    at("arena").classList.toggle("drawing", this.path);
  }

  show() {
    const { mission } = this;
    const box = at("mission");
    const focused = box.contains(document.activeElement);
    box.hidden = mission === null;
    if (focused && box.hidden) at("path").focus();
    Object.assign(box.dataset, { leg: mission?.leg ?? "", distance: mission?.distance ?? "" });
    if (mission === null) return;
    const { leg, of } = mission;
    at("mission-text").textContent = mission.distance === null
      ? t("mission_leg", { leg, of })
      : t("mission_distance", { leg, of, distance: number(mission.distance / 10) });
  }

  words() {
    this.draw();
    this.show();
  }
}
