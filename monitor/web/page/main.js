// SPDX-License-Identifier: GPL-3.0-or-later
// The page: shows the gateway's messages, sends the user's orders.

import { Driving, writes } from "./driving.js";
import * as journal from "./journal.js";
import { Link } from "./link.js";
import { pose } from "./ground.js";
import { Missions, readPoints } from "./missions.js";
import { Picture } from "./picture.js";
import { Battery, Latency, makePlot } from "./plots.js";
import { Recordings } from "./recordings.js";
import { Starter } from "./start.js";
import { number, onLanguage, start as startWords, stored, t } from "./words.js";

const at = (id) => document.getElementById(id);
const root = document.documentElement;

const OLD = 1500;                  // ms without an image: the picture is old
const BACK = 20000;                // ms after which a wheel is not taken back
const BACK_WAIT = 2500;            // ms for our former connection to be gone
const RATE_OVER = 3000;            // ms over which images a second are counted
const HINT_AGAIN = 10000;          // ms
const ASK_AFTER = 2;               // failures; then the gateway may have refused it
const SESSION_OVER = 4001;         // code of the gateway

const ROBOT_ORDERS = ["RSWW", "RSOW", "RRST", "ROPN", "RCLS", "RPIN", "RGST", "RGBT", "RVER", "RPOF"];
const CAMERA_ORDERS = ["COPN", "CCLS", "CPCO", "CPST", "CASA", "CACO", "CAIN"];
const DRIVING = new Set(["RGFW", "RGBW", "RGLF", "RGRI", "RSTP", "RMOV", "RTRN"]);
const LEVEL = { closed: "off", open: "warn", started: "ok", off: "bad", lost: "bad",
  connecting: "warn", connected: "ok", refused: "bad" };

const state = {
  supervisor: "connecting", robot: "closed", watchdog: false, camera: false,
  positions: false, arena: "none", battery: -1, version: "", driver: null, asking: [], offered: null,
  viewers: [], recording: null, mission: null, ground: null,
};
let me = null;
let role = "viewer";
let recorded = false;
let welcomedAt = 0;
let wheelBack = false;             // ours before the connection went: wanted back
let searching = false;
let lastImage = 0;
let refusal = "";                  // why the gateway does not take this page, if it says so
let aborted;                       // the event of the last mission's end
const imageTimes = [];

const mine = () => me !== null && state.driver === me;
// Whether this page has asked for the wheel, and may take it now
const waitingFor = () => state.driver === null && state.asking.includes(me);
const viewer = (id) => state.viewers.find((one) => one.id === id);
const nameOf = (id) => viewer(id)?.name ?? "?";

// The gateway accepts only printable names of at most 30 characters
const clean = (name) => name.replace(/[\p{C}\p{Z}]+/gu, " ").trim().slice(0, 30);

// ---------------------------------------------------------------- the wheel

// Whether the wheel was ours: survives a reload, not the tab
const remembered = {
  get() {
    try {
      const since = Number(sessionStorage.getItem("destijl.wheel"));
      return since > 0 && Date.now() - since < BACK;
    } catch { return false; }
  },
  set(yes) {
    try {
      if (yes) sessionStorage.setItem("destijl.wheel", String(Date.now()));
      else sessionStorage.removeItem("destijl.wheel");
    } catch { /* not taken back then */ }
  },
};

const wheel = (what, to) => link.send(to === undefined
  ? { type: "wheel", do: what } : { type: "wheel", do: what, to });

function takeBack() {
  if (!wheelBack || document.hidden) return;
  if (state.driver === null && state.asking.length === 0) wheel("take");
  if (mine() || performance.now() - welcomedAt > BACK_WAIT || state.asking.length > 0)
    wheelBack = false;
}

// ------------------------------------------------------------------- orders

async function order(label, value) {
  if (label === "CASA") searching = true;
  if (DRIVING.has(label)) missions.withdraw();
  const result = await link.order(label, value);
  if (label === "CASA") {
    searching = false;
    show();
  }
  if (DRIVING.has(label) && result.answer === "AACK") {
    latency.add(result.total);
    tileLatency();
  }
  return result;
}

// An order of the user: reports a refusal, with advice, unless quiet applies
async function wish(label, value, quiet = () => false) {
  const result = await order(label, value);
  // The loss of the connection has been reported
  if (result.answer !== "LOST" && (!quiet() || result.answer === "ATIM"))
    report(label, value, result.answer);
  return result;
}

function report(label, value, answer) {
  // Why a mission is not possible comes as an event
  if (answer === "ANAK" && Array.isArray(value)) return;
  if (!journal.succeeded(answer))
    journal.alarm(() => t("order_answer", {
      order: journal.orderWords(label, value), answer: journal.refusal(label, answer),
    }));
  else if (!DRIVING.has(label))
    journal.news(() => t("order_answer", {
      order: journal.orderWords(label, value), answer: journal.answerWords(answer, label),
    }));
}

function whyNot() {
  if (!link.usable) journal.alarm(() => t("link_connecting"));
  else if (state.driver === null) journal.news(() => t("wheel_first_take"));
  else {
    const name = nameOf(state.driver);
    journal.news(() => t("wheel_first_ask", { name }));
  }
}

// For a user who presses a driving key while nobody drives
let hinted = -Infinity;

function hint() {
  if (state.driver !== null || performance.now() - hinted < HINT_AGAIN) return;
  hinted = performance.now();
  whyNot();
}

const driving = new Driving({
  order: wish, mayDrive: () => link.usable && mine(), whyNot, hint,
  mission: () => state.mission !== null, stopped,
});

// The user wants to stop the robot: whoever drives, in any state
async function stopped() {
  const button = at("stop");
  button.classList.add("pressed");
  setTimeout(() => button.classList.remove("pressed"), 250);
  if (!link.usable) {
    driving.letGo();
    journal.alarm(() => t("link_offline_stop"));
    return;
  }
  const { answer, total } = await driving.stop();
  if (answer === "AACK")
    journal.alarm(() => t("order_ms", { order: t("RSTP"), answer: t("AACK"), ms: Math.round(total) }));
}

// --------------------------------------------------------------- connection

const link = new Link({ message: receive, image: receiveImage, change: linkChanged });

function linkChanged(now, before, { reason = "", code = 0 }) {
  root.dataset.link = now;
  if (now === "open") {
    refusal = "";
    if (before === "lost" || before === "slow") journal.news(() => t("link_back"));
  } else if (now === "slow") {
    if (mine()) {
      journal.alarm(() => t("link_slow"));
      driving.stop();
    } else journal.news(() => t("link_slow_watch"));
  } else if (now === "lost") {
    driving.letGo();
    driving.moving = false;
    if (before === "open" || before === "slow")
      journal.alarm(() => reason ? t("link_refused", { reason }) : t("link_lost"));
    if (code === SESSION_OVER) location.reload();
    // If it rejected our name, do not send that again
    if (code === 1008) stored.set("destijl.name", "");
    if (mine()) remembered.set(true);
    me = null;
    if (link.failures >= ASK_AFTER) askWhy();
  }
  show();
}

async function askWhy() {
  try {
    const answer = await fetch("/ws", { cache: "no-store" });
    if (answer.status === 401) location.reload();     // to the form for the token
    const said = await answer.text();
    refusal = link.usable || answer.status !== 503 ? ""
      : said.includes("of this session") ? "full_session"
      : said.includes("too many viewers") ? "full" : "";
  } catch {
    refusal = "";                  // not there: the link tries again
  }
  show();
}

function receive(message) {
  switch (message.type) {
    case "welcome":
      welcome(message);
      break;
    case "state":
      takeState(message);
      break;
    case "position":
      if (state.positions) {
        picture.add(message, performance.now());
        tilePosition();
      }
      break;
    case "event":
      // Another viewer has stopped the robot: the driver must press again
      if (message.code === "stopped_by" && mine()) {
        driving.letGo();
        missions.withdraw();
      }
      journal.happened(message, nameOf(me), mine() && (message.code === "order" ||
        message.code === "stopped_by" && message.args.name === nameOf(me)));
      takeEnd(message);
      if (message.code === "order" && !mine() && DRIVING.has(message.args.label) &&
          message.args.answer === "AACK") {
        latency.add(message.args.ms);
        tileLatency();
      }
      break;
  }
}

// A mission's end is of interest until another begins, or somebody drives
function takeEnd(event) {
  const { label, answer } = event.args;
  if (event.code === "mission_aborted" && !missions.wanted) aborted = event;
  else if (DRIVING.has(label) && label !== "RSTP" && answer === "AACK") aborted = undefined;
  showAlarms();
}

function welcome(message) {
  aborted = undefined;
  me = message.you;
  role = message.role;
  recorded = message.recordings;
  at("join-with").hidden = !message.pupils;
  welcomedAt = performance.now();
  lastImage = 0;
  unseen = 0;
  waiting = undefined;
  driving.letGo();
  picture.clear();
  wheelBack = remembered.get();
  Object.assign(state, message.state);
  showGround();
  journal.restore(message.events);
  battery.set(message.battery);
  const name = stored.get("destijl.name");
  if (name && name !== nameOf(me)) link.send({ type: "name", name });
  if (document.activeElement !== at("name")) at("name").value = name || nameOf(me);
  changed();
}

function takeState({ type, ...fields }) {
  const before = { ...state };
  Object.assign(state, fields);
  if ("battery" in fields) battery.add(Date.now(), state.battery);
  if (before.driver === me && state.driver !== me) {
    driving.letGo();
    driving.moving = false;
    remembered.set(false);
  }
  if (before.driver !== me && mine()) journal.news(() => t("wheel_now"));
  if (before.driver !== null && waitingFor()) journal.alarm(() => t("wheel_free"));
  if (!before.mission && state.mission || state.robot === "closed") aborted = undefined;
  if (!state.positions || !state.camera) picture.clear();
  if ("ground" in fields) showGround();
  changed();
}

function showGround() {
  picture.ground = state.ground;
  picture.draw();
}

function changed() {
  const drives = mine();
  link.drives = drives;
  if (drives) {
    remembered.set(true);
    wheelBack = false;
  }
  takeBack();
  show();
}

// ------------------------------------------------------------------- images

const picture = new Picture(at("picture"), at("overlay"));
const missions = new Missions(picture, {
  order,
  report,
  mayDrive: () => link.usable && mine(),
  whyNot,
  say: (key) => journal.alarm(() => t(key)),
});
let waiting;                       // the newest image that is not drawn yet
let unseen = 0;                    // images since the last that was drawn
let drawing = false;

function receiveImage(blob) {
  waiting = blob;
  unseen += 1;
  drawImages();
}

async function drawImages() {
  // A hidden page shows nothing: the gateway delays the next
  if (drawing) return;
  drawing = true;
  while (waiting && !document.hidden) {
    const blob = waiting;
    const count = unseen;
    waiting = undefined;
    unseen = 0;
    try {
      await picture.show(blob);
      lastImage = performance.now();
      imageTimes.push(lastImage);
      at("picture").dataset.images = Number(at("picture").dataset.images) + 1;
      if (at("picture").hidden) {
        at("picture").hidden = false;
        showPictureNote();
      }
    } catch { /* damaged: the next one comes */ }
    link.seen(count);
  }
  drawing = false;
}

function showPictureNote() {
  const blank = at("picture").hidden;
  const age = performance.now() - lastImage;
  at("picture-none").hidden = !blank;
  let title = "";
  let text = "";
  let old = false;
  if (blank) {
    title = t(link.usable ? "picture_none" : "link_connecting");
    text = !link.usable ? "" : t(state.driver === null || mine()
      ? "picture_hint_start" : "picture_hint_watch");
  } else if (!link.usable) {
    title = t("picture_lost");
    old = true;
  } else if (!state.camera) {
    title = t("picture_closed");
    old = true;
  } else if (lastImage > 0 && age > OLD && state.arena !== "found" && !searching) {
    title = t("picture_old", { seconds: number(Math.floor(age / 1000)) });
    old = true;
  } else if (searching) {
    title = t("arena_searching");
  } else if (state.arena === "found" && !mine()) {
    title = t("arena_watch");
  }
  write("picture-note-title", title);
  write("picture-note-text", text);
  at("picture-note").hidden = !title && !text;
  at("arena").classList.toggle("old", old);
}

// -------------------------------------------------------------------- state

// Writes only differences: a screen reader announces changes
function write(id, text) {
  const element = at(id);
  if (element.textContent !== text) element.textContent = text;
}

function tile(name, level, text, more) {
  // Their values are old, once the connection is lost
  at("tile-" + name).dataset.level = link.usable || name === "supervisor" ? level : "off";
  write("tile-" + name + "-text", text);
  if (more !== undefined) write("tile-" + name + "-more", more);
}

function makeTiles() {
  for (const name of ["supervisor", "robot", "watchdog", "camera", "position",
    "battery", "driver", "latency", "images"]) {
    const box = document.createElement("div");
    box.className = "tile";
    box.id = "tile-" + name;
    const title = document.createElement("dt");
    title.dataset.t = "st_" + name;
    const value = document.createElement("dd");
    const text = document.createElement("span");
    text.id = box.id + "-text";
    text.className = "value";
    const more = document.createElement("small");
    more.id = box.id + "-more";
    value.append(text, more);
    box.append(title, value);
    at("tiles").append(box);
  }
  for (const [name, plot] of [["battery", batteryPlot], ["latency", latencyPlot]])
    at("tile-" + name).lastElementChild.append(plot);
}

const batteryPlot = makePlot("battery-plot");
const latencyPlot = makePlot("latency-plot");
const battery = new Battery(batteryPlot);
const latency = new Latency(latencyPlot);

function tileLatency() {
  const { last } = latency;
  if (last === undefined) {
    tile("latency", "off", t("latency_none"), "");
    return;
  }
  tile("latency", last < 100 ? "ok" : "warn", t("latency_ms", { ms: number(last, last < 10 ? 1 : 0) }),
    t("latency_stats", {
      median: number(latency.quantile(0.5), 1), p99: number(latency.quantile(0.99), 1),
    }));
}

function tilePosition() {
  const { last } = picture;
  const overlay = at("overlay");
  if (!state.positions || !last) {
    tile("position", "off", t("position_off"), "");
    picture.picture.setAttribute("aria-label", t("picture_label"));
    for (const key of ["x", "y", "angle", "id"]) delete overlay.dataset[key];
    return;
  }
  Object.assign(overlay.dataset, { x: last.x, y: last.y, angle: last.angle, id: last.id });
  if (last.id < 0) {
    tile("position", "warn", t("position_none"), t("do_position"));
    return;
  }
  const { text, angle } = shownPosition(last);
  tile("position", "ok", text, t("position_angle", { angle, id: last.id }));
}

// In centimetres where an arena is confirmed, otherwise in pixels
function shownPosition(last) {
  const { x, y, angle } = state.ground ? pose(state.ground, last) : last;
  return { text: t(state.ground ? "position_cm" : "position_px", { x: number(x), y: number(y) }),
    angle: number(angle) };
}

function describePicture() {
  const { last } = picture;
  const label = !last ? t("picture_label") : last.id < 0 ? t("picture_label_none")
    : t("picture_label_robot", { id: last.id, ...shownPosition(last) });
  if (at("picture").getAttribute("aria-label") !== label)
    at("picture").setAttribute("aria-label", label);
}

function tileImages() {
  const now = performance.now();
  while (imageTimes.length > 0 && imageTimes[0] < now - RATE_OVER) imageTimes.shift();
  const rate = imageTimes.length / (RATE_OVER / 1000);
  tile("images", rate > 0 ? "ok" : state.camera ? "warn" : "off",
    rate > 0 ? number(rate, rate < 9.5 ? 1 : 0) : t("rate_none"),
    state.recording ? t("recording_on") : "");
  const silent = state.camera && lastImage > 0 && now - lastImage > 3 * OLD &&
    state.arena !== "found";
  tile("camera", !state.camera ? "off" : silent ? "warn" : "ok",
    t(!state.camera ? "camera_off" : silent ? "camera_silent" : "camera_on"),
    state.camera ? t("arena_" + state.arena) : "");
  tile("supervisor", link.usable ? LEVEL[state.supervisor] : "bad",
    link.usable ? t("supervisor_" + state.supervisor) : t("gateway_lost"),
    link.usable && link.rtt !== null ? t("gateway_ms", { ms: number(link.rtt, link.rtt < 10 ? 1 : 0) }) : "");
}

// ------------------------------------------------------------------ display

function usable(button, yes) {
  if (yes) button.removeAttribute("aria-disabled");
  else button.setAttribute("aria-disabled", "true");
}

// Rebuilds a list and keeps the focus
function fill(list, items) {
  const key = list.contains(document.activeElement)
    ? document.activeElement.dataset.key : undefined;
  list.replaceChildren(...items);
  if (key) list.querySelector(`[data-key="${CSS.escape(key)}"]`)?.focus();
}

function smallButton(text, label, key, action) {
  const made = document.createElement("button");
  made.type = "button";
  made.className = "small";
  made.textContent = text;
  made.setAttribute("aria-label", label);
  made.dataset.key = key;
  made.onclick = action;
  return made;
}

function giveButton(id) {
  const made = smallButton(t("wheel_give"), t("wheel_give_label", { name: nameOf(id) }),
    "give " + id, () => wheel("give", id));
  made.dataset.give = id;
  return made;
}

// Pressed again, the offer is withdrawn
function offerButton(id) {
  const offered = state.offered === id;
  const made = smallButton(t("wheel_offer"), t("wheel_offer_label", { name: nameOf(id) }),
    "offer " + id, () => offered ? wheel("withdraw") : wheel("offer", id));
  made.setAttribute("aria-pressed", String(offered));
  made.dataset.offer = id;
  return made;
}

function muteButton({ id, muted = false }) {
  const made = smallButton(t("people_mute"), t("people_mute_label", { name: nameOf(id) }),
    "mute " + id, () => link.send({ type: "pupil", do: muted ? "unmute" : "mute", to: id }));
  made.setAttribute("aria-pressed", String(muted));
  made.dataset.mute = id;
  return made;
}

let toExpel;

function expelButton({ id }) {
  const made = smallButton(t("people_expel"), t("people_expel_label", { name: nameOf(id) }),
    "expel " + id, () => {
      toExpel = id;
      at("expel-title").textContent = t("people_expel_title", { name: nameOf(id) });
      at("expel").showModal();
    });
  made.dataset.expel = id;
  return made;
}

// The address for the pupils, as a code and as text
async function showJoin() {
  const answer = await fetch("/join.svg" + (at("join-token").checked ? "?token" : ""));
  if (!answer.ok) return;
  const svg = new DOMParser().parseFromString(await answer.text(), "image/svg+xml");
  at("join-address").textContent = svg.querySelector("title").textContent;
  at("join-code").replaceChildren(svg.documentElement);
  if (!at("join").open) at("join").showModal();
}

let listed;                        // what the lists were made of

function showPeople() {
  const made = JSON.stringify([state.viewers, state.asking, state.offered, state.driver, me, root.lang]);
  if (made === listed) return;
  listed = made;
  at("people-count").textContent = t("people_count", { n: state.viewers.length });
  fill(at("viewers"), state.viewers.map((one) => {
    const { id, name, role: theirs, muted } = one;
    const item = document.createElement("li");
    item.dataset.viewer = id;
    const who = document.createElement("span");
    who.className = "person";
    who.textContent = name;
    item.append(who);
    for (const [is, word] of [[id === me, "people_you"], [id === state.driver, "people_drives"],
      [state.asking.includes(id), "people_asks"], [theirs === "teacher", "people_teacher"],
      [muted, "people_muted"]]) {
      if (!is) continue;
      const tag = document.createElement("small");
      tag.className = "tag " + word;
      tag.textContent = t(word);
      item.append(" ", tag);
    }
    const buttons = document.createElement("span");
    buttons.className = "buttons";
    if (mine() && id !== me && !state.asking.includes(id)) buttons.append(offerButton(id));
    if (role === "teacher" && theirs === "viewer") buttons.append(muteButton(one), expelButton(one));
    item.append(buttons);
    return item;
  }));
  const questions = mine() ? state.asking.map((id) => {
    const decline = smallButton(t("wheel_decline"), t("wheel_decline_label", { name: nameOf(id) }),
      "decline " + id, () => wheel("decline", id));
    decline.dataset.decline = id;
    return question(id, t("wheel_asks", { name: nameOf(id) }), giveButton(id), decline);
  }) : [];
  if (state.offered === me && me !== null) questions.push(offer());
  at("asking").hidden = questions.length === 0;
  fill(at("asking"), questions);
}

function question(id, text, ...buttons) {
  const item = document.createElement("li");
  item.dataset.viewer = id;
  const words = document.createElement("span");
  words.textContent = text;
  item.append(words, ...buttons);
  return item;
}

// To this page, by who drives
function offer() {
  const take = smallButton(t("wheel_take"), t("wheel_take"), "take", () => wheel("take"));
  take.dataset.take = "";
  const decline = smallButton(t("wheel_decline"), t("wheel_decline"), "unwanted", () => wheel("withdraw"));
  decline.dataset.decline = "";
  return question(state.driver, t("wheel_offers", { name: nameOf(state.driver) }), take, decline);
}

function showWheel() {
  const there = link.usable && me !== null;
  const drives = mine();
  const free = state.driver === null;
  const asked = state.asking.includes(me);
  root.dataset.wheel = drives ? "me" : free ? "free" : "other";
  write("wheel-who", !there ? t("gateway_lost") : drives ? t("wheel_you") : free ? t("wheel_nobody")
    : t("wheel_other", { name: nameOf(state.driver) }));
  const wanted = {
    "wheel-take": there && free,
    "wheel-ask": there && !free && !drives && !asked,
    "wheel-withdraw": there && !free && !drives && asked,
    "wheel-seize": there && !free && !drives && role === "teacher",
    "wheel-release": there && drives,
  };
  const focused = document.activeElement?.id;
  for (const [id, shown] of Object.entries(wanted)) at(id).hidden = !shown;
  // The button just used is gone: focus the one in its place
  if (focused in wanted && !wanted[focused]) {
    const next = Object.keys(wanted).find((id) => wanted[id]);
    if (next) at(next).focus();
  }
}

function showStart() {
  const all = mine() && state.robot === "started" && state.camera && state.positions;
  const blocked = !link.usable || state.supervisor !== "connected" ||
    (state.driver !== null && !mine());
  write("start-word", t(starter.running ? "start_busy" : all ? "start_running" : "start"));
  write("start-text", t(all ? "start_ready" : "start_text"));
  usable(at("start"), !blocked && !starter.running && !all);
  at("start").classList.toggle("running", all && !starter.running);
}

// What is wrong now, and what to do
function showAlarms() {
  const { robot } = state;
  const now = (!link.usable ? [[refusal, refusal]] : [
    ["robot_lost", robot === "lost"], ["robot_off", robot === "off"],
    ["camera", state.camera_failed], ["mission", aborted],
    ...[0, 1].map((level) => ["battery_" + level,
      state.battery === level && ["open", "started"].includes(robot)]),
  ]).filter(([, is]) => is).map(([key]) =>
    [key, key === "mission" ? journal.words(aborted) : t("alarm_" + key)]);
  const made = JSON.stringify(now);
  if (made === at("alarms").dataset.made) return;
  at("alarms").dataset.made = made;
  at("alarms").hidden = now.length === 0;
  at("alarms").replaceChildren(...now.map(([key, text]) => {
    const line = document.createElement("p");
    line.dataset.alarm = key;
    line.textContent = text;
    return line;
  }));
}

// The way to the first mission
function showNext(drives) {
  const step = !drives || state.robot !== "started" || !state.camera || state.mission ? ""
    : state.arena !== "confirmed" ? "next_" + state.arena
    : missions.path ? "next_path" : "next_confirmed";
  at("next").hidden = step === "";
  write("next", step && t(step));
}

function show() {
  const drives = link.usable && mine();
  root.dataset.robot = state.robot;
  root.dataset.arena = state.arena;
  for (const key of ["watchdog", "camera", "positions"]) root.dataset[key] = String(state[key]);
  document.title = (mine() ? t("wheel_you") + " · " : waitingFor() ? t("wheel_free") + " · " : "") + t("title");
  showWheel();
  showStart();
  showPeople();
  for (const one of document.querySelectorAll("[data-order], [data-single], #move, #turn, #points, #path, #arena-search"))
    usable(one, drives);
  if (!drives) missions.leave();
  missions.set(link.usable ? state.mission : null);
  at("arena-question").hidden = state.arena !== "found" || !drives;
  usable(at("arena-search"), drives && state.camera && state.arena !== "found" && !searching);
  tile("robot", LEVEL[state.robot], t("robot_" + state.robot) +
    (state.version && ["open", "started"].includes(state.robot)
      ? ", " + t("version", { version: state.version }) : ""));
  const running = state.robot === "started";
  tile("watchdog", !running ? "off" : state.watchdog ? "ok" : "warn",
    t(!running ? "watchdog_none" : state.watchdog ? "watchdog_on" : "watchdog_off"));
  tile("battery", ["bad", "warn", "ok"][state.battery] ?? "off",
    t(state.battery < 0 ? "battery_unknown" : "battery_" + state.battery));
  tile("driver", mine() ? "ok" : state.driver === null ? "off" : "ok",
    state.driver === null ? t("driver_nobody") : mine() ? t("driver_you") : nameOf(state.driver));
  tileLatency();
  tilePosition();
  tileImages();
  describePicture();
  showPictureNote();
  showAlarms();
  showNext(drives);
  at("logout").hidden = role === "open";
  at("join-open").hidden = role !== "teacher";
  recordings.set(recorded, state.recording, role !== "viewer");
}

// ----------------------------------------------------------------- controls

const starter = new Starter({
  order,
  state: () => state,
  drives: () => link.usable && mine(),
  driverName: () => state.driver === null || mine() ? "" : nameOf(state.driver),
  takeWheel: () => wheel("take"),
  refusal: journal.refusal,
});

const recordings = new Recordings();

// A control that is aria-disabled reports the reason instead
function on(id, action) {
  at(id).addEventListener("click", () => {
    if (at(id).getAttribute("aria-disabled") === "true") {
      if (!link.usable || (!mine() && state.supervisor === "connected")) whyNot();
      else if (id === "start" && state.supervisor !== "connected") journal.news(() => t("do_NOLINK"));
      else if (id === "arena-search") journal.news(() => t("do_CPCO_ANAK"));
    } else action();
  });
}

async function startAll() {
  const running = starter.run();
  showStart();
  await running;
  show();
  const { outcome } = starter;
  if (outcome === "start_ready") {
    journal.news(() => t(outcome));
    setTimeout(() => { if (!starter.running && starter.outcome === outcome) starter.clear(); }, 2500);
  } else if (outcome) journal.alarm(() => t(outcome));
}

function amount(form, label) {
  at(form + "-form").addEventListener("submit", (event) => {
    event.preventDefault();
    const field = at(form + "-value");
    if (at(form).getAttribute("aria-disabled") === "true") {
      whyNot();
    } else if (!field.checkValidity()) {
      field.setAttribute("aria-invalid", "true");
      journal.alarm(() => t("range"));
      field.focus();
    } else {
      field.removeAttribute("aria-invalid");
      // In the field, the arrow keys would not drive
      at(form).focus();
      driving.order(label, Number(field.value));
    }
  });
}

function line(text, name = "") {
  const item = document.createElement("li");
  item.textContent = text;
  item.className = name;
  return item;
}

// How the typed points are read, before they are sent
function showPoints() {
  const { points, bad, wrong } = readPoints(at("points-value").value);
  const cm = (value) => number(value, Number.isInteger(value) ? 0 : 1);
  at("points-list").replaceChildren(
    ...points.map(([x, y]) => line(t("points_place", { x: cm(x), y: cm(y) }))),
    ...(bad ? [line(t(wrong, { bad }), "bad")] : []));
}

function makeOrders() {
  for (const [group, labels] of [["robot", ROBOT_ORDERS], ["camera", CAMERA_ORDERS]])
    for (const label of labels) {
      const made = document.createElement("button");
      made.type = "button";
      made.className = "small";
      made.id = "order-" + label;
      made.dataset.single = label;
      made.dataset.t = label;
      at("orders-" + group).append(made);
      on(made.id, () => {
        if (label === "RSOW") at("unguarded").showModal();
        else wish(label);
      });
    }
}

function listen() {
  driving.listen();
  journal.listen();
  for (const one of document.querySelectorAll(".stop")) {
    // A stop does not wait for the release of the finger
    let pressed = -Infinity;
    one.addEventListener("pointerdown", (event) => {
      if (event.button !== 0) return;
      pressed = event.timeStamp;
      stopped();
    });
    one.addEventListener("click", (event) => {
      if (event.timeStamp - pressed > 1000) stopped();
      pressed = -Infinity;
    });
  }
  on("start", startAll);
  on("wheel-take", () => wheel("take"));
  on("wheel-ask", () => wheel("ask"));
  on("wheel-withdraw", () => wheel("withdraw"));
  on("wheel-seize", () => wheel("seize"));
  on("wheel-release", () => {
    driving.letGo();
    remembered.set(false);
    wheel("release");
  });
  on("arena-search", () => {
    if (!starter.running) starter.clear();
    wish("CASA");
  });
  on("arena-confirm", () => wish("CACO"));
  on("arena-reject", () => wish("CAIN"));
  amount("move", "RMOV");
  amount("turn", "RTRN");
  missions.listen();
  on("path", () => {
    missions.toggle();
    show();
  });
  at("mission-end").addEventListener("click", () => {
    missions.withdraw();
    if (link.usable) wish("MABT");
    else stopped();
  });
  at("points-form").addEventListener("submit", (event) => {
    event.preventDefault();
    const { points, bad, wrong } = readPoints(at("points-value").value);
    if (at("points").getAttribute("aria-disabled") === "true") {
      whyNot();
    } else if (wrong) {
      at("points-value").setAttribute("aria-invalid", "true");
      journal.alarm(() => t(wrong, { bad }));
      at("points-value").focus();
    } else {
      at("points").focus();
      missions.send(points.length === 1 ? "MGCM" : "MPCM", points);
    }
  });
  at("points-value").addEventListener("input", () => {
    at("points-value").removeAttribute("aria-invalid");
    showPoints();
  });
  const dialog = at("unguarded");
  for (const [id, label] of [["unguarded-yes", "RSOW"], ["unguarded-with", "RSWW"], ["unguarded-cancel", ""]])
    at(id).onclick = () => {
      dialog.close();
      if (label) wish(label);
    };
  at("expel-no").onclick = () => at("expel").close();
  at("expel-yes").onclick = () => {
    at("expel").close();
    link.send({ type: "pupil", do: "expel", to: toExpel });
  };
  at("join-open").onclick = showJoin;
  at("join-token").onchange = showJoin;
  at("join-close").onclick = () => at("join").close();
  at("projector").onclick = () => {
    location.hash = location.hash === "#projector" ? "" : "#projector";
  };
  addEventListener("hashchange", showView);
  const showHelp = () => { if (!document.querySelector("dialog[open]")) at("help").showModal(); };
  at("help-open").onclick = showHelp;
  at("help-close").onclick = () => at("help").close();
  addEventListener("keydown", (event) => { if (event.key === "?" && !writes(event.target)) showHelp(); });
  const letters = at("letters");
  const setLetters = (yes) => {
    driving.letters = yes;
    letters.setAttribute("aria-pressed", String(yes));
  };
  setLetters(stored.get("destijl.letters") !== "no");
  letters.onclick = () => {
    setLetters(!driving.letters);
    stored.set("destijl.letters", driving.letters ? "yes" : "no");
  };
  at("trail").onclick = () => {
    picture.trail = !picture.trail;
    at("trail").setAttribute("aria-pressed", String(picture.trail));
    picture.draw();
  };
  at("name-form").addEventListener("submit", (event) => {
    event.preventDefault();
    const name = clean(at("name").value);
    if (!name) return;
    at("name").value = name;
    stored.set("destijl.name", name);
    link.send({ type: "name", name });
  });

  addEventListener("blur", () => { if (mine()) driving.stopIfMoving(); });
  document.addEventListener("visibilitychange", () => {
    if (document.hidden) leave();
    else {
      link.ping();
      link.hurry();
      drawImages();
    }
  });
  addEventListener("pagehide", () => {
    if (mine()) driving.stop();
    link.end();
  });
  addEventListener("pageshow", (event) => { if (event.persisted) link.start(); });
  addEventListener("online", () => link.hurry());
}

// A hidden page must not drive
function leave() {
  if (mine()) {
    driving.stop();
    wheel("release");
    journal.alarm(() => t("link_hidden"));
  }
  link.ping();
}

// The picture and the state alone, for a projector
function showView() {
  if (location.hash.startsWith("#token=")) history.replaceState(null, "", "/");
  const alone = location.hash === "#projector";
  root.classList.toggle("projector", alone);
  at("projector").setAttribute("aria-pressed", String(alone));
}

function everySecond() {
  if (document.hidden) return;
  if (mine() && link.usable) remembered.set(true);
  takeBack();
  tileImages();
  describePicture();
  showPictureNote();
}

makeTiles();
makeOrders();
startWords();
onLanguage(() => {
  journal.renew();
  starter.show();
  missions.words();
  showPoints();
  battery.draw();
  latency.draw();
  show();
});
listen();
showView();
show();
setInterval(everySecond, 500);
setInterval(() => { if (!document.hidden) battery.draw(); }, 10000);
link.start();
