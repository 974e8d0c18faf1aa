// SPDX-License-Identifier: GPL-3.0-or-later
// A picture of the arena with a canvas of the screen's resolution over it: the
// robot's position, heading and fading trail; where a mission's points may be,
// those of the mission, and those of a path that is being drawn.

import { inImage, permitted } from "./ground.js";

const TRAIL = 15000;               // ms until the trail has faded
const JUMP = 0.15;                 // of the width: no line is drawn so far
const CASING = "rgb(255 255 255 / 0.9)";
const INK = "#0b4ea2";
const NEXT = "#ffd500";
const BAD = "#c8102e";
const TRAIL_INK = [255, 213, 0];

export class Picture {
  constructor(picture, overlay) {
    this.picture = picture;
    this.overlay = overlay;
    this.points = [];              // { at, x, y, dx, dy, id, angle }, oldest first
    this.now = 0;
    this.trail = true;
    this.plan = null;              // a mission, as in the gateway's state
    this.ground = null;            // as there
    this.path = [];                // [x, y], not sent yet
    this.bad = [];                 // a point that was refused
    this.density = 1;
    const watcher = new ResizeObserver(([entry]) => {
      const exact = entry.devicePixelContentBoxSize?.[0];
      const width = entry.contentRect.width || 1;
      overlay.width = exact ? exact.inlineSize : Math.round(width * devicePixelRatio);
      overlay.height = exact ? exact.blockSize
        : Math.round(entry.contentRect.height * devicePixelRatio);
      this.density = overlay.width / width;
      this.draw();
    });
    try {
      watcher.observe(overlay, { box: "device-pixel-content-box" });
    } catch {
      watcher.observe(overlay);
    }
  }

  // Shows the JPEG; throws if it cannot be decoded
  async show(jpeg) {
    const bitmap = await createImageBitmap(jpeg);
    const { picture } = this;
    const resized = picture.width !== bitmap.width || picture.height !== bitmap.height;
    if (resized) {
      picture.width = bitmap.width;
      picture.height = bitmap.height;
    }
    picture.getContext("2d").drawImage(bitmap, 0, 0);
    bitmap.close();
    if (resized) this.draw();
  }

  // Adds a position (id -1: none) of the given time
  add(position, at) {
    this.points.push({ ...position, at });
    this.now = at;
    this.forget();
    this.draw();
  }

  forget() {
    let first = 0;
    while (first < this.points.length && this.points[first].at < this.now - TRAIL)
      first += 1;
    this.points.splice(0, first);
  }

  // The positions up to now, for a replay
  set(points, now) {
    this.points = points;
    this.now = now;
    this.draw();
  }

  clear() {
    this.points = [];
    this.draw();
  }

  // Pixels of the image per CSS pixel
  get pixelSize() {
    const { picture } = this;
    const box = picture.getBoundingClientRect();
    return 1 / Math.min(box.width / picture.width, box.height / picture.height);
  }

  // [x, y] of the image at this place of the window; undefined beside it
  pixel(clientX, clientY) {
    const { picture, pixelSize } = this;
    const box = picture.getBoundingClientRect();
    const x = picture.width / 2 + (clientX - (box.left + box.right) / 2) * pixelSize;
    const y = picture.height / 2 + (clientY - (box.top + box.bottom) / 2) * pixelSize;
    if (x < 0 || y < 0 || x > picture.width || y > picture.height) return undefined;
    return [Number(x.toFixed(1)), Number(y.toFixed(1))];
  }

  get last() { return this.points[this.points.length - 1]; }

  draw() {
    const { overlay, picture } = this;
    const context = overlay.getContext("2d");
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, overlay.width, overlay.height);
    const scale = Math.min(overlay.width / picture.width, overlay.height / picture.height);
    const left = (overlay.width - picture.width * scale) / 2;
    const top = (overlay.height - picture.height * scale) / 2;
    const place = (x, y) => [left + x * scale, top + y * scale];
    // Unit of drawing: a CSS pixel, more on a large picture
    const unit = Math.max(this.density, overlay.width / 900);
    // Overlapping segments would be visible at their joints
    context.lineCap = "butt";
    context.lineJoin = "round";
    const { ground } = this;
    const area = ground ? inImage(ground, permitted(ground)) : [];
    let plan = this.plan?.points ?? [];
    if (this.plan?.unit === "cm") plan = ground ? inImage(ground, plan) : [];
    overlay.dataset.plan = plan.flat().join(";");
    overlay.dataset.permitted = area.flat().join(";");
    overlay.dataset.path = this.path.flat().join(";");
    overlay.dataset.bad = this.bad.flat().join(";");
    if (area.length > 0)
      this.drawLine(context, [...area, area[0]].map((point) => place(...point)), unit / 2, true);
    if (plan.length > 0) this.drawPlan(context, place, unit, plan);
    if (this.trail) this.drawTrail(context, place, unit);
    const { last } = this;
    if (last?.id >= 0) this.drawRobot(context, place, unit, scale, last);
    this.drawLine(context, this.path.map((point) => place(...point)), unit, true);
    this.drawPoints(context, this.path.map((point) => place(...point)), unit, 1);
    for (const point of this.bad) this.drawCross(context, place(...point), unit);
  }

  drawCross(context, [x, y], unit) {
    const arm = 10 * unit;
    const cross = new Path2D();
    for (const [dx, dy] of [[arm, arm], [arm, -arm]]) {
      cross.moveTo(x - dx, y - dy);
      cross.lineTo(x + dx, y + dy);
    }
    for (const [width, colour] of [[8, CASING], [4, BAD]]) {
      context.lineWidth = width * unit;
      context.strokeStyle = colour;
      context.stroke(cross);
    }
  }

  // The way that is left, from the robot on; dashed: the plan of what is done
  drawPlan(context, place, unit, points) {
    const { leg } = this.plan;
    const places = points.map((point) => place(...point));
    const { last } = this;
    const robot = last?.id >= 0 ? [place(last.x, last.y)] : [];
    this.drawLine(context, places.slice(0, leg), unit, true);
    this.drawLine(context, [...robot, ...places.slice(leg - 1)], unit, false);
    this.drawPoints(context, places, unit, leg);
  }

  drawLine(context, places, unit, dashed) {
    if (places.length < 2) return;
    context.setLineDash(dashed ? [9 * unit, 6 * unit] : []);
    for (const [width, colour] of [[5, CASING], [2.5, INK]]) {
      context.lineWidth = width * unit;
      context.strokeStyle = colour;
      context.beginPath();
      for (const one of places) context.lineTo(...one);
      context.stroke();
    }
    context.setLineDash([]);
  }

  // Point number leg is the next one; those before it are done
  drawPoints(context, places, unit, leg) {
    for (const [n, one] of places.entries()) {
      const dot = new Path2D();
      dot.arc(...one, (n === leg - 1 ? 8 : 6) * unit, 0, 2 * Math.PI);
      context.fillStyle = n < leg - 1 ? "#fff" : n === leg - 1 ? NEXT : INK;
      context.fill(dot);
      context.lineWidth = 2.5 * unit;
      context.strokeStyle = n < leg ? INK : "#fff";
      context.stroke(dot);
    }
  }

  drawTrail(context, place, unit) {
    const jump = this.picture.width * JUMP;
    for (const pass of [
      { width: 5, colour: "0, 0, 0", most: 0.45 },
      { width: 3, colour: TRAIL_INK.join(", "), most: 1 },
    ]) {
      context.lineWidth = pass.width * unit;
      for (let n = 1; n < this.points.length; n += 1) {
        const from = this.points[n - 1];
        const to = this.points[n];
        if (from.id < 0 || from.id !== to.id) continue;
        if (Math.hypot(to.x - from.x, to.y - from.y) > jump) continue;
        const age = (this.now - to.at) / TRAIL;
        context.strokeStyle = `rgba(${pass.colour}, ${(pass.most * Math.max(0, 1 - age)).toFixed(3)})`;
        context.beginPath();
        context.moveTo(...place(from.x, from.y));
        context.lineTo(...place(to.x, to.y));
        context.stroke();
      }
    }
  }

  drawRobot(context, place, unit, scale, { x, y, dx, dy }) {
    const [cx, cy] = place(x, y);
    const heading = Math.atan2(dy - y, dx - x);
    const radius = Math.max(14 * unit, Math.hypot(dx - x, dy - y) * scale * 2);
    const tip = radius + 22 * unit;
    const arrow = new Path2D();
    for (const [n, [along, across]] of [
      [tip, 0], [radius + 2 * unit, 8 * unit], [radius + 2 * unit, -8 * unit],
    ].entries()) {
      const px = cx + along * Math.cos(heading) - across * Math.sin(heading);
      const py = cy + along * Math.sin(heading) + across * Math.cos(heading);
      if (n === 0) arrow.moveTo(px, py); else arrow.lineTo(px, py);
    }
    arrow.closePath();
    const ring = new Path2D();
    ring.arc(cx, cy, radius, 0, 2 * Math.PI);
    // No trail over the marker
    context.globalCompositeOperation = "destination-out";
    context.fill(ring);
    context.globalCompositeOperation = "source-over";
    for (const [width, colour] of [[6, CASING], [3, INK]]) {
      context.lineWidth = width * unit;
      context.strokeStyle = colour;
      context.stroke(ring);
      if (colour === CASING) context.stroke(arrow);
    }
    context.fillStyle = INK;
    context.fill(arrow);
  }
}
