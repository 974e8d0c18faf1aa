// SPDX-License-Identifier: GPL-3.0-or-later
// The texts of the token form.

import { onLanguage, start, t } from "./words.js";

function show() {
  document.title = t("login_title");
  const failed = new URLSearchParams(location.search).get("failed");
  document.getElementById("refused").textContent = failed === null ? ""
    : t(["wait", "expelled"].includes(failed) ? "login_" + failed : "login_refused");
}

// A teacher's code has it; the address does not keep it
const token = new URLSearchParams(location.hash.slice(1)).get("token");
if (token) {
  history.replaceState(null, "", "/");
  document.getElementById("token").value = token;
  document.querySelector("form").submit();
}

start();
onLanguage(show);
show();
