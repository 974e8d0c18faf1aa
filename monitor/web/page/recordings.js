// SPDX-License-Identifier: GPL-3.0-or-later
// The list of recordings, their names and deletion, and the replay of one: its events are loaded
// completely, its images in parts of the file.

import { entry } from "./journal.js";
import { Picture } from "./picture.js";
import { day, number, onLanguage, t } from "./words.js";

const PIECE = 1 << 20;             // bytes of images fetched at once
const PIECES = 6;                  // kept
const TRAIL = 15000;               // ms
const TITLE = 60;                  // characters of a name
const EVENTS = 6;                  // said below the picture

const at = (id) => document.getElementById(id);
const address = (name, file) => `/recordings/${encodeURIComponent(name)}/${file}`;

async function get(url, options) {
  const response = await fetch(url, options);
  if (!response.ok) throw new Error(`${response.status} ${response.statusText}`);
  return response;
}

const time = (ms) => {
  const seconds = Math.floor(ms / 1000);
  return `${Math.floor(seconds / 60)}:${String(seconds % 60).padStart(2, "0")}`;
};

const size = (bytes) => bytes < 1e6 ? number(bytes / 1e3) + " kB"
  : number(bytes / 1e6, 1) + " MB";

// The index of the last element with t not after the time; -1: none
function until(list, moment) {
  let low = 0;
  let high = list.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (list[middle].t <= moment) low = middle + 1;
    else high = middle;
  }
  return low - 1;
}

// The images, cut from parts of the file
class Images {
  constructor(url, images) {
    this.url = url;
    this.images = images;
    this.pieces = new Map();       // first image of a piece: its promise
    this.starts = [];              // where a piece begins
    let bytes = Infinity;
    for (const [n, image] of images.entries()) {
      if (bytes + image.length > PIECE) {
        this.starts.push(n);
        bytes = 0;
      }
      bytes += image.length;
    }
  }

  piece(index) {
    const first = this.starts[index];
    if (first === undefined) return undefined;
    let piece = this.pieces.get(first);
    if (piece) {
      this.pieces.delete(first);   // becomes the latest used
    } else {
      const last = (this.starts[index + 1] ?? this.images.length) - 1;
      const from = this.images[first].offset;
      const to = this.images[last].offset + this.images[last].length - 1;
      piece = get(this.url, { headers: { Range: `bytes=${from}-${to}` } })
        .then(async (response) => {
          const data = await response.blob();
          return { data, from: response.status === 206 ? from : 0 };
        });
      piece.catch(() => this.pieces.delete(first));
    }
    this.pieces.set(first, piece);
    for (const key of this.pieces.keys()) {
      if (this.pieces.size <= PIECES) break;
      this.pieces.delete(key);
    }
    return piece;
  }

  async image(n) {
    let index = this.starts.length - 1;
    while (this.starts[index] > n) index -= 1;
    const { data, from } = await this.piece(index);
    this.piece(index + 1)?.catch(() => {});
    const { offset, length } = this.images[n];
    return data.slice(offset - from, offset - from + length, "image/jpeg");
  }
}

class Replay {
  constructor() {
    this.picture = new Picture(at("replay-picture"), at("replay-overlay"));
    this.playing = false;
    this.moment = 0;
    at("replay-play").onclick = () => this.play(!this.playing);
    at("replay-close").onclick = () => this.close();
    at("replay-slider").oninput = () => {
      this.play(false);
      this.go(Number(at("replay-slider").value));
    };
    onLanguage(() => this.words());
  }

  words() {
    at("replay-play").textContent = t(this.playing ? "rec_pause" : "rec_play");
    if (!this.name) return;
    at("replay-title").textContent = t("rec_replay_label", { begun: day(this.begun) });
    this.say();
    this.told = undefined;
    this.tell();
  }

  async open({ name, start }) {
    this.play(false);
    this.name = name;
    this.begun = start;
    this.images = undefined;
    at("replay").hidden = false;
    at("replay-note").textContent = t("rec_loading");
    this.words();
    at("replay-title").focus();
    try {
      const text = await (await get(address(name, "events.jsonl"))).text();
      if (this.name !== name) return;
      this.take(text);
    } catch (error) {
      at("replay-note").textContent = t("rec_broken", { reason: error.message });
      return;
    }
    at("replay-note").textContent = this.frames.length === 0 ? t("rec_empty") : "";
    this.go(this.first);
    this.play(this.frames.length > 0);
  }

  take(text) {
    const all = [];
    for (const row of text.split("\n")) {
      // The last line of an active recording may be incomplete
      try { if (row) all.push(JSON.parse(row)); } catch { /* left out */ }
    }
    this.frames = all.filter(({ type }) => type === "image");
    this.positions = all.filter(({ type }) => type === "position")
      .map((position) => ({ ...position, at: position.t }));
    this.events = all.filter(({ type }) => type === "event");
    this.missions = all.filter(({ mission }) => mission !== undefined);
    this.grounds = all.filter(({ ground }) => ground !== undefined);
    // A recording need not repeat orders as events
    if (!this.events.some(({ code }) => code === "order")) {
      const answers = all.filter(({ type }) => type === "answer");
      this.events = this.events.concat(answers.map(({ t: when, label, answer, ms }) => {
        const order = all.findLast((one) => one.type === "order" &&
          one.label === label && one.t <= when);
        return { t: when, type: "event", level: "info", code: "order",
          args: { name: order?.name ?? "", label, value: order?.value ?? "", answer, ms } };
      })).sort((a, b) => a.t - b.t);
    }
    this.images = new Images(address(this.name, "images.mjpeg"), this.frames);
    // The session may have started long before the camera was opened
    this.first = this.frames[0]?.t ?? 0;
    this.length = all.reduce((most, { t: when }) => Math.max(most, when), 0);
    at("replay-slider").max = this.length;
  }

  play(playing) {
    if (playing && this.moment >= this.length) this.go(this.first);
    this.playing = playing;
    this.words();
    if (!playing) return;
    let before = performance.now();
    const step = (now) => {
      if (!this.playing) return;
      // Time is paused while an image is being fetched
      if (!this.showing)
        this.go(this.moment + (now - before) * Number(at("replay-speed").value));
      before = now;
      if (this.moment >= this.length) this.play(false);
      else requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
  }

  go(moment) {
    if (!this.images) return;
    this.moment = Math.min(this.length, moment);
    at("replay-slider").value = this.moment;
    this.say();
    const last = until(this.positions, this.moment);
    const first = until(this.positions, this.moment - TRAIL) + 1;
    this.picture.plan = this.missions[until(this.missions, this.moment)]?.mission ?? null;
    this.picture.ground = this.grounds[until(this.grounds, this.moment)]?.ground ?? null;
    this.picture.set(this.positions.slice(first, last + 1), this.moment);
    this.tell();
    this.draw();
  }

  say() {
    if (this.length === undefined) return;
    const text = t("rec_time", { at: time(this.moment), all: time(this.length) });
    at("replay-time").textContent = text;
    at("replay-slider").setAttribute("aria-valuetext", text);
  }

  tell() {
    if (!this.events) return;
    const last = until(this.events, this.moment);
    if (last === this.told) return;
    this.told = last;
    at("replay-events").replaceChildren(...this.events
      .slice(Math.max(0, last - EVENTS + 1), last + 1).reverse()
      .map((event) => entry(event, time(event.t))));
  }

  // One image after the other; late ones are skipped
  async draw() {
    if (this.showing || this.frames.length === 0) return;
    const { images, name } = this;
    this.showing = true;
    try {
      for (;;) {
        const wanted = Math.max(0, until(this.frames, this.moment));
        if (this.images !== images || at("replay-picture").dataset.index === String(wanted)) break;
        const image = await images.image(wanted);
        if (this.images !== images) break;
        await this.picture.show(image);
        at("replay-picture").dataset.index = wanted;
        at("replay-note").textContent = "";
      }
    } catch (error) {
      this.play(false);
      if (this.name === name)
        at("replay-note").textContent = t("rec_broken", { reason: error.message });
    } finally {
      this.showing = false;
    }
  }

  close() {
    this.play(false);
    this.name = undefined;
    this.images = undefined;
    delete at("replay-picture").dataset.index;
    at("replay").hidden = true;
    at("recordings-refresh").focus();
  }
}

export class Recordings {
  constructor() {
    this.list = [];
    this.writing = null;
    at("recordings-refresh").onclick = () => this.read();
    at("delete-no").onclick = () => at("delete").close();
    at("delete-yes").onclick = () => {
      at("delete").close();
      const { name } = this.doomed;
      if (this.replay?.name === name) this.replay.close();
      this.change(`/recordings/${name}`, { method: "DELETE" });
    };
    onLanguage(() => this.show());
  }

  // there: the gateway records; writing: the active recording; may: name and
  // delete them
  set(there, writing, may) {
    this.may = may;
    at("recordings").hidden = !there;
    if (there && (this.there !== there || this.writing !== writing)) this.read();
    this.there = there;
    this.writing = writing;
  }

  async read() {
    try {
      this.list = await (await get("/recordings")).json();
      this.failure = undefined;
    } catch (error) {
      this.list = [];
      this.failure = error.message;
    }
    this.show();
  }

  async change(url, options) {
    try {
      await get(url, options);
      await this.read();
    } catch (error) {
      at("recordings-note").textContent = t("rec_change_failed", { reason: error.message });
    }
    at("recordings-refresh").focus();
  }

  show() {
    at("recordings-note").textContent = this.failure
      ? t("rec_failed", { reason: this.failure })
      : this.list.length === 0 ? t("rec_none") : "";
    at("recordings-table").hidden = this.list.length === 0;
    at("recordings-list").replaceChildren(...this.list.map((one) => this.row(one)));
  }

  row(one) {
    const begun = (one.number ? `${one.number} · ` : "") + day(one.start);
    const row = document.createElement("tr");
    row.dataset.recording = one.name;
    for (const text of [begun, time(one.duration), number(one.images), size(one.bytes)]) {
      const cell = document.createElement("td");
      cell.textContent = text;
      row.append(cell);
    }
    if (one.name === this.writing) {
      const now = document.createElement("small");
      now.className = "tag";
      now.textContent = t("rec_now");
      row.firstElementChild.append(" ", now);
    }
    if (one.title) {
      const title = document.createElement("strong");
      title.textContent = one.title;
      row.firstElementChild.prepend(title, " ");
    }
    const replay = this.button("replay", begun, () => {
      this.replay ??= new Replay();
      this.replay.open(one);
    });
    const positions = document.createElement("a");
    positions.href = address(one.name, "positions.csv");
    positions.download = one.name + ".csv";
    positions.textContent = t("rec_csv");
    positions.setAttribute("aria-label", t("rec_csv_label", { begun }));
    const cell = document.createElement("td");
    cell.className = "actions";
    cell.append(replay, positions);
    if (this.may) cell.append(this.button("name", begun, () => this.ask(one, row.firstElementChild)));
    if (this.may && one.name !== this.writing)
      cell.append(this.button("delete", begun, () => {
        this.doomed = one;
        at("delete-text").textContent = t("rec_delete_text", { what: one.title || begun });
        at("delete").showModal();
      }));
    row.append(cell);
    return row;
  }

  button(what, begun, action) {
    const made = document.createElement("button");
    made.type = "button";
    made.className = "small";
    made.dataset.do = what;
    made.textContent = t("rec_" + what);
    made.setAttribute("aria-label", t(`rec_${what}_label`, { begun }));
    made.onclick = action;
    return made;
  }

  // A field for the name, in the cell of the recording's row
  ask(one, cell) {
    const form = document.createElement("form");
    const field = document.createElement("input");
    field.type = "text";
    field.maxLength = TITLE;
    field.value = one.title;
    field.setAttribute("aria-label", t("rec_name_label", { begun: day(one.start) }));
    form.append(field);
    form.onsubmit = (event) => {
      event.preventDefault();
      this.change(`/recordings/${one.name}/title`, { method: "PUT", body: field.value });
    };
    cell.replaceChildren(form);
    field.focus();
  }
}
