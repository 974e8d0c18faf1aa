#  SPDX-License-Identifier: GPL-3.0-or-later
"""A monitor in the browser: the gateway between browsers and the supervisor."""
