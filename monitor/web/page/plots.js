// SPDX-License-Identifier: GPL-3.0-or-later
// The two small plots: the battery's last ten minutes, the last hundred
// orders. SVG, to be sharp and to use the colours of style.css.

import { number, t } from "./words.js";

const SVG = "http://www.w3.org/2000/svg";
const WIDTH = 120;
const HEIGHT = 28;
const HISTORY = 600000;            // ms
const ORDERS = 100;

function shape(name, attributes) {
  const element = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes))
    element.setAttribute(key, value);
  return element;
}

export function makePlot(id) {
  const svg = shape("svg", {
    id, class: "plot", role: "img", viewBox: `0 0 ${WIDTH} ${HEIGHT}`,
    preserveAspectRatio: "none",
  });
  return svg;
}

const line = (y, name) => shape("line", {
  class: name, x1: 0, x2: WIDTH, y1: y, y2: y,
});

export class Battery {
  constructor(svg) {
    this.svg = svg;
    this.levels = [];
  }

  set(levels) {
    this.levels = [...levels];
    this.draw();
  }

  add(time, level) {
    const last = this.levels[this.levels.length - 1];
    if (last && last[1] === level) return;
    this.levels.push([time, level]);
    this.draw();
  }

  draw() {
    const now = Date.now();
    const begin = now - HISTORY;
    // The last level before the ten minutes is valid at their beginning
    while (this.levels.length > 1 && this.levels[1][0] < begin) this.levels.shift();
    const x = (time) => Math.max(0, (time - begin) / HISTORY * WIDTH);
    const y = (level) => HEIGHT - 4 - level * (HEIGHT - 8) / 2;
    let path = "";
    let up = false;
    for (const [n, [time, level]] of this.levels.entries()) {
      const until = this.levels[n + 1]?.[0] ?? now;
      if (level < 0) {
        up = false;
        continue;
      }
      path += `${up ? "L" : "M"}${x(time).toFixed(1)} ${y(level)}L${x(until).toFixed(1)} ${y(level)}`;
      up = true;
    }
    this.svg.replaceChildren(line(y(0), "grid"), line(y(1), "grid"), line(y(2), "grid"),
      shape("path", { class: "curve", d: path }));
    const seen = this.levels.filter(([, level]) => level >= 0).slice(-5)
      .map(([time, level]) => t("battery_" + level) + " " +
        number(Math.round((now - Math.max(time, begin)) / 60000)) + " min");
    this.svg.setAttribute("aria-label", seen.length > 0
      ? t("battery_plot", { list: seen.join(", ") }) : t("battery_plot_none"));
  }
}

export class Latency {
  constructor(svg) {
    this.svg = svg;
    this.times = [];
    this.draw();
  }

  add(ms) {
    this.times.push(ms);
    if (this.times.length > ORDERS) this.times.shift();
    this.draw();
  }

  get last() { return this.times[this.times.length - 1]; }

  // The time that the given share of the orders does not exceed
  quantile(part) {
    const sorted = [...this.times].sort((a, b) => a - b);
    return sorted[Math.max(0, Math.ceil(part * sorted.length) - 1)];
  }

  draw() {
    const count = this.times.length;
    if (count === 0) {
      this.svg.replaceChildren(line(HEIGHT - 1, "grid"));
      this.svg.setAttribute("aria-label", t("latency_none"));
      return;
    }
    const median = this.quantile(0.5);
    const p99 = this.quantile(0.99);
    const most = Math.max(20, ...this.times);
    const y = (ms) => HEIGHT - 1 - ms / most * (HEIGHT - 3);
    const wide = WIDTH / ORDERS;
    const bars = this.times.map((ms, n) => shape("rect", {
      class: "bar", x: (ORDERS - count + n) * wide, width: wide * 0.8,
      y: y(ms), height: HEIGHT - y(ms),
    }));
    this.svg.replaceChildren(...bars, line(y(p99), "p99"), line(y(median), "median"));
    this.svg.setAttribute("aria-label", t("latency_plot", {
      n: count, median: number(median, 1), p99: number(p99, 1),
    }));
  }
}
