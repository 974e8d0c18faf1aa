// SPDX-License-Identifier: GPL-3.0-or-later
// Messages: the log of all events, and the last important one in a live
// region: politely, or at once for stops and losses.

import { clock, has, language, t } from "./words.js";

const MOST = 300;                  // entries of the log

const alertBox = document.getElementById("alert");
const newsBox = document.getElementById("news");
const list = document.getElementById("log");
const entries = [];
let said;

const URGENT = new Set(["supervisor_lost", "supervisor_refused", "robot_not_running",
  "wheel_lost", "wheel_seized", "stopped_by", "stopped_silent",
  "recording_failed", "mission_refused"]);

// Shown otherwise, as long as it is so
const STANDING = new Set(["robot_lost", "camera_silent", "camera_failed", "mission_aborted"]);

// Orders that are routine once done
const QUIET = new Set(["RGFW", "RGBW", "RGLF", "RGRI", "RSTP", "RMOV", "RTRN",
  "RPIN", "RGBT", "RVER", "RGST", "CPCO", "CPST", "CACO", "CAIN", "MABT"]);

const MISSIONS = new Set(["MGTO", "MPTH", "MGCM", "MPCM"]);

// Value: an integer, or a mission's points, or their number
export const orderWords = (label, value) =>
  t(label, { value: Array.isArray(value) ? value.length : value });

export function answerWords(answer, order = "") {
  if (!answer) return t("sent");
  if (MISSIONS.has(order) && has("mission_" + answer)) return t("mission_" + answer);
  const [label, n] = answer.split(":");
  if (label === "RBLV") return t("RBLV", { n: Number(n) < 0 ? t("battery_unknown") : t("battery_" + n) });
  if (label === "RVER") return t("version", { version: answer.slice(5) });
  if (label === "RCST") return t("RCST_" + n);
  return t(label);
}

export const succeeded = (answer) => ["AACK", "CIMG"].includes(answer) ||
  /^(RBLV|RVER|RCST):/.test(answer ?? "");

// Advice after a refusal
export function remedy(label, answer) {
  const kind = MISSIONS.has(label) ? "mission" : label === "MABT" ? "RSTP" : label;
  const key = ["do_" + kind + "_" + answer, "do_" + answer].find(has);
  return key ? t(key) : "";
}

export const refusal = (label, answer) =>
  `${answerWords(answer, label)}. ${remedy(label, answer)}`.trim();

export function words({ code, args = {} }) {
  if (code === "order") {
    const done = succeeded(args.answer);
    const sentence = t(typeof args.ms === "number" ? "ev_order_ms" : "ev_order", {
      name: args.name, order: orderWords(args.label, args.value),
      answer: answerWords(args.answer, args.label), ms: Math.round(args.ms),
    });
    return done || !args.answer ? sentence : `${sentence}. ${remedy(args.label, args.answer)}`;
  }
  if (code === "unanswered") return t("ev_unanswered", { order: orderWords(args.label, "") });
  if (code.startsWith("mission_") && args.reason) {
    // The supervisor's reasons are English, one with what it has measured
    const [, percent] = args.reason.match(/(\d+) %/) ?? [];
    const key = "reason_" + args.reason.replace(/\d+ %/, "percent").replace(/\W+/g, "_");
    return t("ev_" + code, { reason: has(key) ? t(key, { percent }) : args.reason });
  }
  if (args.count && has(`ev_${code}_count`)) return t(`ev_${code}_count`, args);
  if (!has("ev_" + code)) return t("ev_unknown", { code, args: JSON.stringify(args) });
  return t("ev_" + code, args);
}

export function entry(event, time = clock(event.time)) {
  const item = document.createElement("li");
  item.dataset.code = event.code;
  item.dataset.level = event.level;
  if (event.code === "order") {
    item.dataset.label = event.args.label;
    item.dataset.answer = event.args.answer ?? "";
  }
  const when = document.createElement("time");
  when.textContent = time;
  const level = document.createElement("span");
  level.className = "level";
  level.setAttribute("role", "img");
  level.setAttribute("aria-label", t("level_" + event.level));
  const what = document.createElement("span");
  what.className = "what";
  what.textContent = words(event);
  // The supervisor's texts are English
  if (event.code === "message" && language() !== "en") what.lang = "en";
  item.append(when, level, what);
  return item;
}

function put(event) {
  entries.push(event);
  list.prepend(entry(event));
  if (entries.length > MOST) {
    entries.shift();
    list.lastElementChild.remove();
  }
  document.getElementById("log-empty").hidden = true;
}

// All earlier events
export function restore(events) {
  entries.length = 0;
  list.replaceChildren();
  document.getElementById("log-empty").hidden = events.length > 0;
  for (const event of events) put(event);
}

export function renew() {
  restore([...entries]);
  if (said) show();
}

// me: the name of this viewer; mine: the event is about an order of this page,
// or its consequence, and was reported then
export function happened(event, me, mine) {
  // Once in the log, where it is repeated
  const before = event.args.count ? entries.map((one) =>
    one.code === event.code && one.args.name === event.args.name).lastIndexOf(true) : -1;
  if (before >= 0) {
    list.children[entries.length - 1 - before].remove();
    entries.splice(before, 1);
  }
  put(event);
  if (event.code === "order") {
    if (mine || (succeeded(event.args.answer) && QUIET.has(event.args.label))) return;
    news(() => words(event));
  } else if (STANDING.has(event.code)) {
    // Not said in passing
  } else if (["wheel_lost", "stopped_silent"].includes(event.code) && event.args.name === me) {
    alarm(() => t("wheel_lost_you"));
  } else if (event.code === "muted" && event.args.name === me) {
    alarm(() => t("muted_you"));
  } else if (event.level === "error" || URGENT.has(event.code)) {
    alarm(() => words(event));
  } else {
    news(() => words(event));
  }
}

function show() {
  const { box, text } = said;
  const other = box === alertBox ? newsBox : alertBox;
  other.textContent = "";
  // The same text is announced again only if it was cleared
  box.textContent = "";
  setTimeout(() => { if (said.box === box) box.textContent = said.text(); }, 30);
  document.getElementById("says").title = text();
}

// text is a function, so that it can be repeated in the other language
export function news(text) {
  said = { box: newsBox, text };
  show();
}

export function alarm(text) {
  said = { box: alertBox, text };
  show();
}

export function listen() {
  const all = document.getElementById("log-all");
  all.onclick = () => {
    const pressed = all.getAttribute("aria-pressed") !== "true";
    all.setAttribute("aria-pressed", String(pressed));
    list.classList.toggle("brief", !pressed);
  };
}
