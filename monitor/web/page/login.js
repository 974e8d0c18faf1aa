// SPDX-License-Identifier: GPL-3.0-or-later
// The words of the form for the token.

import { onLanguage, start, t } from "./words.js";

function show() {
  document.title = t("login_title");
  const refused = new URLSearchParams(location.search).has("refused");
  document.getElementById("refused").textContent =
    refused ? t("login_refused") : "";
}

start();
onLanguage(show);
show();
