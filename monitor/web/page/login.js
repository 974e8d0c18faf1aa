// SPDX-License-Identifier: GPL-3.0-or-later
// The texts of the token form.

import { onLanguage, start, t } from "./words.js";

function show() {
  document.title = t("login_title");
  const failed = new URLSearchParams(location.search).get("failed");
  document.getElementById("refused").textContent = failed === null ? ""
    : t(["wait", "expelled"].includes(failed) ? "login_" + failed : "login_refused");
}

start();
onLanguage(show);
show();
