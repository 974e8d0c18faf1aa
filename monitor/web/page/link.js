// SPDX-License-Identifier: GPL-3.0-or-later
// The WebSocket to the gateway: connects and reconnects, pings, detects a slow
// or dead connection, and matches answers to orders. monitor/web/README.md has
// the messages.

const TICK = 100;                  // ms between pings of who drives
const TICKS_WATCHING = 10;         // of who watches, in TICKs
const SLOW = { drives: 500, watches: 3000 };    // ms without a pong
const DEAD = { drives: 3000, watches: 8000 };
const OPENING = 5000;              // ms for the connection and its welcome
const BACKOFF = { first: 250, factor: 1.7, most: 5000 };
const SEEN_APART = 30;             // ms; the gateway bounds the messages a second
const ANSWER = 15000;              // ms until an order counts as unanswered

export class Link {
  // handlers: message (object), image (blob), change (state,
  // state before, event of the closing)
  constructor(handlers) {
    this.handlers = handlers;
    this.state = "connecting";     // open, slow, lost
    this.rtt = null;
    this.drives = false;
    this.failures = 0;
    this.orders = new Map();
    this.lastOrder = 0;
    this.lastPing = 0;
    this.ticks = 0;
    this.pings = new Map();
    this.seenAt = 0;
    this.ended = false;
  }

  start() {
    this.ended = false;
    this.timer ??= setInterval(() => this.tick(), TICK);
    this.connect();
  }

  // At the end of the page
  end() {
    this.ended = true;
    this.drop({}, false);
  }

  get usable() { return this.state === "open" || this.state === "slow"; }

  connect() {
    clearTimeout(this.retry);
    this.retry = undefined;
    if (this.ended) return;
    const scheme = location.protocol === "https:" ? "wss:" : "ws:";
    const socket = new WebSocket(scheme + "//" + location.host + "/ws");
    socket.binaryType = "blob";
    this.socket = socket;
    this.openedAt = performance.now();
    this.pings.clear();
    // Ignore a socket that was abandoned
    const mine = (action) => (event) => {
      if (this.socket === socket) action(event);
    };
    socket.onmessage = mine((event) => this.receive(event.data));
    socket.onclose = mine((event) => this.drop(event));
  }

  receive(data) {
    if (typeof data !== "string") {
      this.handlers.image(data);
      return;
    }
    const message = JSON.parse(data);
    if (message.type === "pong") {
      const sent = this.pings.get(message.n);
      if (sent === undefined) return;
      this.rtt = performance.now() - sent;
      // Earlier ones are answered too, or will never be
      for (const n of this.pings.keys()) if (n <= message.n) this.pings.delete(n);
      if (this.state === "slow") this.change("open");
    } else if (message.type === "answer") {
      this.settle(message.id, message.answer, message.ms);
    } else if (message.type === "welcome") {
      this.failures = 0;
      this.handlers.message(message);
      this.change("open");
    } else {
      this.handlers.message(message);
    }
  }

  // The connection is lost, or abandoned
  drop(close = {}, again = true) {
    const socket = this.socket;
    this.socket = undefined;
    if (socket) try { socket.close(); } catch { /* is closed already */ }
    this.rtt = null;
    this.pings.clear();
    for (const id of [...this.orders.keys()]) this.settle(id, "LOST");
    if (again) {
      const wait = Math.min(BACKOFF.most,
        BACKOFF.first * BACKOFF.factor ** this.failures) * (0.8 + 0.4 * Math.random());
      this.failures += 1;
      clearTimeout(this.retry);
      this.retry = setTimeout(() => this.connect(), wait);
    }
    this.change("lost", close);
  }

  // The network may be back
  hurry() {
    if (this.retry === undefined || this.ended) return;
    this.connect();
  }

  change(state, close = {}) {
    if (state === this.state && state !== "lost") return;
    const before = this.state;
    this.state = state;
    this.handlers.change(state, before, close);
  }

  tick() {
    const now = performance.now();
    if (!this.socket) return;
    if (!this.usable) {
      if (now - this.openedAt > OPENING) this.drop();
      return;
    }
    const kind = this.drives ? "drives" : "watches";
    const [oldest] = this.pings.values();
    if (oldest !== undefined && now - oldest > DEAD[kind]) {
      this.drop();
      return;
    }
    if (oldest !== undefined && now - oldest > SLOW[kind]) this.change("slow");
    this.ticks += 1;
    if (this.drives || this.ticks % TICKS_WATCHING === 0) this.ping();
  }

  ping() {
    if (!this.usable) return;
    this.lastPing += 1;
    this.pings.set(this.lastPing, performance.now());
    this.send({ type: "ping", n: this.lastPing, hidden: document.hidden });
  }

  send(message) {
    if (this.socket?.readyState !== WebSocket.OPEN) return false;
    this.socket.send(JSON.stringify(message));
    return true;
  }

  // count images were shown, or replaced by newer ones
  seen(count) {
    const socket = this.socket;
    const now = performance.now();
    for (let n = 0; n < count; n += 1) {
      this.seenAt = Math.max(now, this.seenAt + SEEN_APART);
      const send = () => {
        if (this.socket === socket) this.send({ type: "seen" });
      };
      if (this.seenAt > now) setTimeout(send, this.seenAt - now);
      else send();
    }
  }

  // Value: an integer, or a mission's points. Resolves to { answer, ms, total }:
  // ms measured by the gateway, total here
  order(label, value) {
    this.lastOrder += 1;
    const id = this.lastOrder;
    const message = { type: "order", id, label };
    if (Array.isArray(value)) message.points = value;
    else if (value !== undefined) message.value = value;
    const sent = performance.now();
    return new Promise((resolve) => {
      if (!this.usable || !this.send(message)) {
        resolve({ answer: "LOST" });
        return;
      }
      const timer = setTimeout(() => this.settle(id, "LATE"), ANSWER);
      this.orders.set(id, { resolve, sent, timer });
    });
  }

  settle(id, answer, ms) {
    const order = this.orders.get(id);
    if (!order) return;
    this.orders.delete(id);
    clearTimeout(order.timer);
    order.resolve({ answer, ms, total: performance.now() - order.sent });
  }
}
