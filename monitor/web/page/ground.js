// SPDX-License-Identifier: GPL-3.0-or-later
// The ground of a confirmed arena, as in the gateway's state: from pixels of
// the image to centimetres, origin in the lower left corner, y up, and back.

function mapped(rows, [px, py]) {
  const [x, y, whole] = rows.map(([a, b, c]) => a * px + b * py + c);
  return [x / whole, y / whole];
}

// The adjoint: the same map as the inverse
function inverse([a, b, c]) {
  const cross = (p, q) => [p[1] * q[2] - p[2] * q[1],
    p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]];
  const columns = [cross(b, c), cross(c, a), cross(a, b)];
  return [0, 1, 2].map((row) => columns.map((column) => column[row]));
}

export function inImage(ground, points) {
  const back = inverse(ground.map);
  return points.map((point) => mapped(back, point));
}

// Where a mission's points may be
export function permitted({ size: [width, height], margin }) {
  const [right, top] = [width - margin, height - margin];
  return [[margin, margin], [right, margin], [right, top], [margin, top]];
}

// Centimetres, and the heading in degrees from the x axis to the left
export function pose(ground, { x, y, dx, dy }) {
  const centre = mapped(ground.map, [x, y]);
  const ahead = mapped(ground.map, [dx, dy]);
  const turn = Math.atan2(ahead[1] - centre[1], ahead[0] - centre[0]);
  return { x: centre[0], y: centre[1], angle: turn * 180 / Math.PI };
}
