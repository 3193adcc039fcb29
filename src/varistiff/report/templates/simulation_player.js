"use strict";
(function () {
  const root = document.getElementById("player");
  const scene = JSON.parse(document.getElementById("motion").textContent);
  const canvas = root.querySelector("canvas"), paper = canvas.getContext("2d");
  const play = root.querySelector("#play"), scrub = root.querySelector("#scrub");
  const speed = root.querySelector("#speed"), clock = root.querySelector("#clock"), again = root.querySelector("#again");
  const still = matchMedia("(prefers-reduced-motion: reduce)");
  const time = scene.time, first = time[0], last = time[time.length - 1];
  const [left, right, bottom, top] = scene.view;
  let now = first, running = false, before = 0;

  function absolute(differences) {
    const points = [];
    let x = 0, y = 0;
    for (let i = 0; i < differences.length; i++) {
      if (differences[i] === null) { points.push(null); continue; }
      x += differences[i];
      y += differences[++i];
      points.push([x / 100, y / 100]);
    }
    return points;
  }
  for (const part of scene.parts) part.lines = part.s ? [absolute(part.s)] : part.m.map(absolute);

  // frames before and after an instant, and how far it lies between them
  function between(instant) {
    let low = 0, high = time.length - 1;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (time[middle] <= instant) low = middle; else high = middle;
    }
    const span = time[high] - time[low];
    return [low, high, span > 0 ? Math.min(Math.max((instant - time[low]) / span, 0), 1) : 0];
  }
  function mixed(series, [low, high, part]) {
    if (typeof series === "number") return series;
    return series[low] + (series[high] - series[low]) * part;
  }
  function points(part, [low, high, share]) {
    if (part.lines.length === 1) return part.lines[0];
    const from = part.lines[low], to = part.lines[high];
    return from.map((point, i) => point === null || to[i] === null
      ? (share < 0.5 ? point : to[i])
      : [point[0] + (to[i][0] - point[0]) * share, point[1] + (to[i][1] - point[1]) * share]);
  }

  function draw() {
    const ratio = Math.max(window.devicePixelRatio || 1, 1), wide = canvas.clientWidth, high = canvas.clientHeight;
    if (canvas.width !== Math.round(wide * ratio) || canvas.height !== Math.round(high * ratio)) {
      canvas.width = Math.round(wide * ratio);
      canvas.height = Math.round(high * ratio);
    }
    const scale = Math.min(wide / (right - left), high / (top - bottom));
    const x0 = 0.5 * wide - 0.5 * (left + right) * scale, y0 = 0.5 * high + 0.5 * (bottom + top) * scale;
    paper.setTransform(ratio, 0, 0, ratio, 0, 0);
    paper.clearRect(0, 0, wide, high);
    paper.lineJoin = paper.lineCap = "round";
    const place = between(now);
    for (const part of scene.parts) {
      const body = scene.bodies[part.b];
      const bx = mixed(body[0], place) / 100, by = mixed(body[1], place) / 100, angle = mixed(body[2], place) / 1e5;
      const c = Math.cos(angle) * scale, s = Math.sin(angle) * scale;
      const ox = x0 + bx * scale, oy = y0 - by * scale;
      paper.beginPath();
      let lifted = true;
      for (const point of points(part, place)) {
        if (point === null) { lifted = true; continue; }
        const x = ox + point[0] * c - point[1] * s, y = oy - point[0] * s - point[1] * c;
        if (part.r) paper.arc(x, y, part.r * scale, 0, 2 * Math.PI);
        else if (lifted) paper.moveTo(x, y);
        else paper.lineTo(x, y);
        lifted = false;
      }
      if (part.c) paper.closePath();
      if (part.f) { paper.fillStyle = part.f; paper.fill(); }
      if (part.e) {
        paper.strokeStyle = part.e;
        paper.lineWidth = Math.max(part.p, (part.w || 0) * scale);
        paper.setLineDash(part.d ? [6, 4] : []);
        paper.stroke();
      }
    }
    if (scene.scaled) bar(scale, wide, high);
    tell(place);
  }
  // a bar of a round length in the lower right corner
  function bar(scale, wide, high) {
    const most = 0.22 * wide / scale, power = Math.pow(10, Math.floor(Math.log10(most)));
    const length = [5, 2, 1].map((step) => step * power).find((each) => each <= most);
    const x = wide - 12, y = high - 10;
    paper.setLineDash([]);
    paper.lineCap = "butt";
    paper.strokeStyle = paper.fillStyle = "#1b1f24";
    paper.lineWidth = 3;
    paper.beginPath();
    paper.moveTo(x - length * scale, y);
    paper.lineTo(x, y);
    paper.stroke();
    paper.font = "13px system-ui, sans-serif";
    paper.textAlign = "center";
    paper.fillText(String(Number(length.toPrecision(3))) + " mm", x - 0.5 * length * scale, y - 7);
  }

  const cells = scene.readouts.map((each, i) => root.querySelector("#readout-" + i));
  function tell(place) {
    scene.readouts.forEach((each, i) => {
      const a = each.values[place[0]], b = each.values[place[1]];
      const value = a === null || b === null ? null : a + (b - a) * place[2];
      cells[i].textContent = value === null ? "\u2014" : value.toFixed(each.digits).replace("-", "\u2212");
    });
    const text = shown(now);
    clock.textContent = text;
    scrub.setAttribute("aria-valuetext", text);
  }
  const unit = root.dataset.unit, factor = Number(root.dataset.factor);
  const places = Math.max(0, Math.min(6, 3 - Math.floor(Math.log10(Math.max((last - first) * factor, 1e-9)))));
  function shown(instant) { return (instant * factor).toFixed(places).replace("-", "\u2212") + " " + unit; }

  function set(instant) {
    now = Math.min(Math.max(instant, first), last);
    scrub.value = String(Math.round(1000 * (now - first) / (last - first || 1)));
    draw();
  }
  function run(wanted) {
    running = wanted;
    if (running && now >= last) now = first;
    play.textContent = running ? "Pause" : "Play";
    before = 0;
    if (running) requestAnimationFrame(step);
  }
  function step(stamp) {
    if (!running) return;
    if (before) {
      const next = now + 1e-3 * (stamp - before) * Number(speed.value);
      if (next >= last && again.checked) set(first);
      else if (next >= last) { set(last); run(false); return; }
      else set(next);
    }
    before = stamp;
    requestAnimationFrame(step);
  }

  play.addEventListener("click", () => run(!running));
  scrub.addEventListener("input", () => { run(false); set(first + (last - first) * Number(scrub.value) / 1000); });
  still.addEventListener("change", () => { if (still.matches) run(false); });
  for (const [instant, name] of scene.events) {
    const mark = root.querySelector(".marks").appendChild(document.createElement("i"));
    mark.style.left = 100 * (instant - first) / (last - first || 1) + "%";
    mark.title = name;
  }
  new ResizeObserver(draw).observe(canvas);
  document.documentElement.classList.add("moving");
  canvas.style.aspectRatio = String((right - left) / (top - bottom));
  const chosen = /^#at=([0-9.eE+-]+)$/.exec(location.hash);  // a link to an instant
  set(chosen ? Number(chosen[1]) : first);
  // plays by itself once, when it comes into view, for those who do not mind
  if (!still.matches && !chosen) {
    const seen = new IntersectionObserver((entries) => {
      if (!entries.some((entry) => entry.isIntersecting)) return;
      seen.disconnect();
      run(true);
    }, { threshold: 0.6 });
    seen.observe(canvas);
  }
})();
