// SPDX-License-Identifier: GPL-3.0-or-later
// The page's texts in the chosen language: initially the browser's, then the
// stored choice.

import en from "./en.js";
import fr from "./fr.js";

const languages = { en, fr };
const listeners = [];

// Storage may be denied (private windows, policies): the page works without
export const stored = {
  get(key) {
    try { return localStorage.getItem(key); } catch { return null; }
  },
  set(key, value) {
    try { localStorage.setItem(key, value); } catch { /* not remembered */ }
  },
};

function first() {
  const chosen = stored.get("destijl.language");
  if (chosen in languages) return chosen;
  for (const wanted of navigator.languages ?? [navigator.language]) {
    const code = wanted.slice(0, 2).toLowerCase();
    if (code in languages) return code;
  }
  return "en";
}

let current = first();

export const language = () => current;

export const has = (key) => key in languages[current];

// Some texts are others for fingers: their keys end so
const fingers = matchMedia("(pointer: coarse)").matches ? "_touch" : "";

// The text of key, with {name} replaced by args.name
export function t(key, args = {}) {
  const words = languages[current][key + fingers] ?? languages[current][key] ?? en[key] ?? key;
  return words.replace(/\{(\w+)\}/g, (whole, name) =>
    args[name] === undefined ? whole : String(args[name]));
}

const attributes = [
  ["data-t-label", "aria-label"],
  ["data-t-title", "title"],
  ["data-t-placeholder", "placeholder"],
];

// Fills all elements with data-t (text) or data-t-label and the like
export function apply(root = document) {
  for (const element of root.querySelectorAll("[data-t]"))
    element.textContent = t(element.dataset.t);
  for (const [from, to] of attributes)
    for (const element of root.querySelectorAll("[" + from + "]"))
      element.setAttribute(to, t(element.getAttribute(from)));
}

export const onLanguage = (listener) => listeners.push(listener);

export function choose(code) {
  if (!(code in languages) || code === current) return;
  current = code;
  stored.set("destijl.language", code);
  start();
  for (const listener of listeners) listener();
}

// Also called once at start
export function start() {
  document.documentElement.lang = current;
  apply();
  for (const button of document.querySelectorAll("[data-language]")) {
    button.setAttribute("aria-pressed",
      String(button.dataset.language === current));
    button.onclick = () => choose(button.dataset.language);
  }
}

export const clock = (time) => new Date(time).toLocaleTimeString(current,
  { hour: "2-digit", minute: "2-digit", second: "2-digit", hour12: false });

export const day = (time) => new Date(time).toLocaleString(current,
  { dateStyle: "medium", timeStyle: "medium", hour12: false });

// Rounded, and never -0
export const number = (value, digits = 0) =>
  (Number(value.toFixed(digits)) + 0).toLocaleString(current,
    { minimumFractionDigits: digits, maximumFractionDigits: digits });
