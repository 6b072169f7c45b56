// An arm that sliders move: the product of the exponentials of its joints, from its numbers at the zero pose.
const plus = (a, b, s = 1) => a.map((x, k) => x + s * b[k]);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const inner = (a, b) => a.reduce((sum, x, k) => sum + x * b[k], 0);
const turned = (R, v) => R.map(row => inner(row, v));
const transposed = A => A[0].map((_, k) => A.map(row => row[k]));
const product = (A, B) => A.map(row => transposed(B).map(column => inner(row, column)));

function rotation([x, y, z], angle) {
  const s = Math.sin(angle), K = [[0, -z, y], [z, 0, -x], [-y, x, 0]], K2 = product(K, K);
  return K.map((row, i) => row.map((entry, j) => (i === j) + s * entry + (1 - Math.cos(angle)) * K2[i][j]));
}

// The joints and the tool at joint values q, and the columns [v; ω] of the tool's Jacobian: z × p of a turn, z of a slide.
function kinematics(arm, q) {
  let R = [[1, 0, 0], [0, 1, 0], [0, 0, 1]], t = [0, 0, 0];
  const joints = arm.joints.map(({ kind, point, axis }, k) => {
    const start = plus(turned(R, point), t), z = turned(R, axis);
    if (kind === "prismatic") {
      t = plus(t, z, q[k]);
      return { kind, z, start, end: plus(start, z, q[k]) };
    }
    const N = rotation(axis, q[k]);
    t = plus(t, turned(R, plus(point, turned(N, point), -1)));
    R = product(R, N);
    return { kind, z, start, end: start };
  });
  const tool = plus(turned(R, arm.tool), t);
  const columns = joints.map(({ kind, z, start }) => kind === "prismatic" ? [...z, 0, 0, 0] : [...cross(z, plus(tool, start, -1)), ...z]);
  return { joints, tool, columns };
}

function determinant(A) {
  A = A.map(row => [...row]);
  let value = 1;
  for (let k = 0; k < A.length; k++) {
    const best = A.reduce((place, row, i) => i >= k && Math.abs(row[k]) > Math.abs(A[place][k]) ? i : place, k);
    if (best !== k) [A[k], A[best], value] = [A[best], A[k], -value];
    if (A[k][k] === 0) return 0;
    value *= A[k][k];
    for (let i = k + 1; i < A.length; i++) A[i] = plus(A[i], A[k], -A[i][k] / A[k][k]);
  }
  return value;
}

// det J where there is one, and w = √det(J Jᵀ).
function measures(arm, columns) {
  const J = arm.rows.map(row => arm.columns.map(k => columns[k][row]));
  const w = Math.sqrt(Math.max(determinant(product(J, transposed(J))), 0));
  return J.length === columns.length ? { "det J": determinant(J), w } : { w };
}

function handsOn(figure) {
  const arm = JSON.parse(figure.dataset.arm), svg = figure.querySelector("svg"), told = figure.querySelector(":scope > p output");
  const sliders = [...figure.querySelectorAll("input")], [low, high] = arm.window, wide = 330, tall = 250, lang = document.documentElement.lang;
  const scale = Math.min((wide - 40) / (high[0] - low[0]), (tall - 40) / (high[1] - low[1]));
  const text = (value, unit) => `${value.toLocaleString(lang, { maximumSignificantDigits: 3 }).replace("-", "−")}${unit === "°" ? "" : "\u00a0"}${unit}`.trim();
  const flat = point => arm.seen.map(way => inner(way, point));
  const onPage = ([x, y]) => [wide / 2 + scale * (x - (low[0] + high[0]) / 2), tall / 2 - scale * (y - (low[1] + high[1]) / 2)];
  const made = {};
  const draw = (name, tag, kind, values) => {
    if (!made[name]) svg.append(made[name] = document.createElementNS("http://www.w3.org/2000/svg", tag));
    made[name].setAttribute("class", kind);
    for (const [key, value] of Object.entries(values)) made[name].setAttribute(key, value);
  };
  const line = (name, kind, points) => draw(name, "polyline", kind, { points: points.map(point => onPage(point).map(x => x.toFixed(1)).join()).join(" ") });
  const show = () => {
    const q = sliders.map(slider => slider.value / slider.dataset.scale), { joints, tool, columns } = kinematics(arm, q);
    const B = columns.map(column => arm.seen.map(way => arm.size * inner(way, column.slice(arm.part, arm.part + 3))));
    const [a, b, c] = [[0, 0], [0, 1], [1, 1]].map(([i, j]) => inner(B.map(u => u[i]), B.map(u => u[j])));
    const turn = Math.atan2(2 * b, a - c) / 2, half = Math.hypot((a - c) / 2, b);
    const axes = [1, -1].map(sign => Math.sqrt(Math.max((a + c) / 2 + sign * half, 0)));
    const ring = Array.from({ length: 49 }, (_, k) => {
      const [u, v] = [axes[0] * Math.cos(k * Math.PI / 24), axes[1] * Math.sin(k * Math.PI / 24)];
      return plus(flat(tool), [u * Math.cos(turn) - v * Math.sin(turn), u * Math.sin(turn) + v * Math.cos(turn)]);
    });
    line("link", "link", [arm.base, ...joints.flatMap(joint => [joint.start, joint.end]), tool].map(flat));
    joints.forEach(({ kind, start, end }, k) => {
      const [x, y] = onPage(flat(start));
      if (kind === "prismatic") line(`rail ${k}`, "rail", [start, end].map(flat));
      if (kind === "prismatic") draw(`joint ${k}`, "rect", kind, { x: x - 5, y: y - 5, width: 10, height: 10 });
      else draw(`joint ${k}`, "circle", kind, { cx: x, cy: y, r: 5 });
    });
    line("ring", "true", ring);
    const [x, y] = onPage(flat(tool));
    draw("tool", "circle", "tool", { cx: x, cy: y, r: 3 });
    told.value = Object.entries(measures(arm, columns)).map(([name, value]) => `${name} = ${text(Math.abs(value) < 1e-9 ? 0 : value, figure.dataset.unit)}`).join("; ");
    for (const slider of sliders) {
      const value = text(Number(slider.value), slider.dataset.unit);
      slider.setAttribute("aria-valuetext", value);
      slider.nextElementSibling.value = value;
    }
  };
  sliders.forEach(slider => slider.addEventListener("input", show));
  figure.hidden = false;
  show();
}
document.querySelectorAll("figure.hands").forEach(handsOn);
