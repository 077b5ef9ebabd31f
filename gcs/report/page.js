// Draws the figures of a session's report from the model and the packed series that the page carries; nothing is loaded.
(async () => {
  "use strict";
  const root = document.documentElement;
  const model = JSON.parse(document.getElementById("model").textContent);
  const chosen = new Set(model.chosen);
  const vehicleOf = new Map(model.vehicles.map((vehicle) => [vehicle.id, vehicle]));
  // Only these buttons: by default there is one that would send the figure to a server.
  const BUTTONS = { flat: [["toImage"], ["zoom2d", "pan2d"], ["zoomIn2d", "zoomOut2d", "resetScale2d"]], space: [["toImage"], ["resetCameraDefault3d"]] };
  const config = (div) => ({
    responsive: false, displaylogo: false, displayModeBar: narrow(div) ? false : "hover", modeBarButtons: div.dataset.view === "space" && webgl ? BUTTONS.space : BUTTONS.flat,
    toImageButtonOptions: { format: "svg" },
  });
  const PRINTED = { whole: 680, half: 332, height: 0.82 }; // A4 within its margins, in CSS pixels
  const STAGES = ["on the way", "in formation", "transfer"];
  let printing = false;
  let range = null; // the zoom that all figures over time share

  // what the page carries

  async function unpack(id) {
    const text = atob(document.getElementById(id).textContent.trim());
    const bytes = new Uint8Array(text.length);
    for (let i = 0; i < text.length; i += 1) bytes[i] = text.charCodeAt(i);
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
    return new Response(stream).arrayBuffer();
  }

  function scaled(at, n, low, high) {
    const raw = new Uint16Array(series, at, n);
    const values = new Float64Array(n);
    const unit = (high - low) / 65534;
    for (let i = 0; i < n; i += 1) values[i] = raw[i] === 65535 ? NaN : low + unit * raw[i];
    return values;
  }
  const line = (r) => ({ x: scaled(r.at, r.n, 0, model.end_s), y: scaled(r.at + 2 * r.n, r.n, r.low, r.high) });
  const path = (axes) => axes.map((r) => scaled(r.at, r.n, r.low, r.high));

  // colours: told apart by colour-blind readers too, dark on light and light on dark; then by dashes

  const LIGHT = ["#0072b2", "#d55e00", "#007a5a", "#aa3377", "#8a6d00", "#4b3fb5", "#0f7c8c", "#5c5c5c"];
  const DARK = ["#56b4e9", "#ff8c42", "#2fc79f", "#ee8fc6", "#e8c547", "#a79bff", "#6fd9e6", "#c4c4c4"];
  const DASHES = ["solid", "dash", "dot", "dashdot"];
  const darkly = matchMedia("(prefers-color-scheme: dark)");
  function look() {
    const dark = darkly.matches && !printing;
    return dark
      ? { ink: "#e6e9ed", soft: "#a3adb8", grid: "#2b323a", paper: "#12161b", solid: "#7d8894", colours: DARK,
          band: "rgba(86,180,233,.25)", crowd: "rgba(163,173,184,.35)", stages: ["#56606b", "#56b4e9", "#ff8c42"] }
      : { ink: "#1b1f24", soft: "#57606a", grid: "#e3e7eb", paper: "#ffffff", solid: "#6b7682", colours: LIGHT,
          band: "rgba(0,114,178,.18)", crowd: "rgba(87,96,106,.3)", stages: ["#b9c2cb", "#0072b2", "#d55e00"] };
  }
  function rank(id) {
    const among = model.many ? [...chosen].sort((a, b) => a - b) : model.vehicles.map((v) => v.id);
    return Math.max(among.indexOf(id), 0);
  }
  function pen(id) {
    const { colours, ink } = look();
    const role = vehicleOf.get(id)?.role;
    if (role === "target" && !model.many) return { color: ink, dash: "dot", width: 2 };
    const n = rank(id);
    const dash = role === "tanker" ? "dash" : DASHES[Math.floor(n / colours.length) % DASHES.length];
    return { color: colours[n % colours.length], dash, width: 1.6 };
  }
  const label = (id) => vehicleOf.get(id)?.label ?? String(id);
  const shown = (lines) => lines.filter((one) => chosen.has(one.id));

  // figures

  const widthOf = (div) => (printing ? PRINTED[div.closest(".pair") ? "half" : "whole"] : div.clientWidth);
  const narrow = (div) => widthOf(div) < 560;
  function frame(div, height) {
    const { ink, soft, paper } = look();
    return {
      width: widthOf(div), height: printing ? PRINTED.height * height : height, autosize: false, paper_bgcolor: paper, plot_bgcolor: paper,
      font: { family: "system-ui, Segoe UI, Roboto, DejaVu Sans, sans-serif", size: printing ? 10 : 12, color: ink },
      margin: { l: 52, r: 12, t: 26, b: 40 }, showlegend: false, hovermode: "closest",
      hoverlabel: { namelength: -1 }, dragmode: narrow(div) && !printing ? false : "zoom", uirevision: "keep",
      legend: { orientation: "h", traceorder: "normal", x: 0, y: 1.02, yanchor: "bottom", font: { color: soft } },
    };
  }
  const axis = (more) => {
    const { grid, soft } = look();
    return { gridcolor: grid, zerolinecolor: grid, linecolor: grid, tickfont: { color: soft }, ...more };
  };
  const heading = (text, y) => ({
    text, x: 0, xref: "paper", xanchor: "left", y, yref: "paper", yanchor: "bottom", showarrow: false, font: { size: 13 },
  });

  function overTime(figure, div) {
    const { soft, ink, band, colours } = look();
    const count = figure.panels.length;
    const each = count === 1 ? 240 : count === 2 ? 190 : 150;
    const gap = count > 1 ? 42 / (each * count + 42 * (count - 1)) : 0;
    const part = (1 - gap * (count - 1)) / count;
    const layout = { ...frame(div, each * count + 42 * (count - 1) + 66), shapes: [], annotations: [] };
    layout.xaxis = axis({
      title: { text: "session time (s)", standoff: 6 }, range: range ?? [0, model.end_s], anchor: count > 1 ? `y${count}` : "y",
    });
    const data = [];
    figure.panels.forEach((panel, k) => {
      const top = 1 - k * (part + gap);
      const name = k ? `yaxis${k + 1}` : "yaxis";
      const short = k ? `y${k + 1}` : "y";
      layout[name] = axis({ domain: [Math.max(top - part, 0), top], rangemode: panel.zero ? "tozero" : "normal", anchor: "x", ...(panel.range && { range: panel.range }) });
      layout.annotations.push(heading(`<b>${panel.title}</b>${panel.unit ? ` (${panel.unit})` : ""}`, top));
      const tell = `%{y:.${panel.digits}f} ${panel.unit} at %{x:.1f} s`;
      const own = { type: "scatter", mode: "lines", yaxis: short, hovertemplate: tell };
      if (panel.band) {
        const quiet = { ...own, line: { width: 0 }, hoverinfo: "skip", hovertemplate: null };
        data.push({ ...quiet, ...line(panel.band.least) }, { ...quiet, ...line(panel.band.greatest), fill: "tonexty", fillcolor: band });
        data.push({ ...own, ...line(panel.band.median), line: { color: soft, width: 1.4, dash: "dot" }, name: `median of ${panel.band.count}` });
      }
      for (const one of shown(panel.lines)) data.push({ ...own, ...line(one), line: pen(one.id), name: label(one.id) });
      for (const one of panel.own) data.push({ ...own, ...line(one), line: { color: colours[0], width: 1.6 }, name: one.label });
      for (const limit of panel.limits) {
        layout.shapes.push({ type: "line", xref: "paper", x0: 0, x1: 1, yref: short, y0: limit.y, y1: limit.y, line: { color: ink, width: 1, dash: "dash" } });
        layout.annotations.push({ text: limit.label, x: 1, xref: "paper", xanchor: "right", y: limit.y, yref: short, yanchor: "bottom", showarrow: false, font: { size: 11, color: soft } });
      }
    });
    let labelled = -Infinity;
    for (const mark of figure.marks) {
      layout.shapes.push({ type: "line", x0: mark.t_s, x1: mark.t_s, yref: "paper", y0: 0, y1: 1, line: { color: soft, width: 1, dash: "dot" } });
      if ((mark.t_s - labelled) / model.end_s < 32 / widthOf(div)) continue; // the dots' hover names every one
      labelled = mark.t_s;
      layout.annotations.push({ text: mark.label, x: mark.t_s, xanchor: "left", y: 1 - part / 2, yref: "paper", showarrow: false, font: { size: 12, color: chosen.has(mark.id) ? pen(mark.id).color : soft } });
    }
    if (figure.marks.length) {
      data.push({
        type: "scatter", mode: "markers", x: figure.marks.map((m) => m.t_s), y: figure.marks.map(() => 1), name: "decided",
        marker: { size: 6, color: soft }, text: figure.marks.map((m) => m.text ?? `${label(m.id)} is next`), hovertemplate: "%{text}, %{x:.1f} s",
      });
    }
    for (const span of figure.spans) {
      if (!chosen.has(span.id)) continue;
      layout.shapes.push({ type: "rect", layer: "below", x0: span.from, x1: span.to, yref: "paper", y0: 0, y1: 1, fillcolor: pen(span.id).color, opacity: 0.13, line: { width: 0 } });
    }
    return { data, layout };
  }

  // The flight from above (x east, y north), in space (z up), or in space as a drawing on paper.
  const VIEWS = {
    plan: { kind: "scatter", at: (n, e) => ({ x: e, y: n }) },
    space: { kind: "scatter3d", at: (n, e, d) => ({ x: e, y: n, z: d.map((v) => -v) }) },
    drawn: {
      kind: "scatter",
      at: (n, e, d) => ({
        x: e.map((v, i) => 0.866 * (v + n[i])), y: n.map((v, i) => 0.45 * (v - e[i]) - d[i]),
      }),
    },
  };
  function flight(figure, div, view) {
    const { solid, soft, crowd, ink, grid, paper } = look();
    const { kind, at } = VIEWS[view];
    const data = [];
    const columns = (points) => [0, 1, 2].map((k) => points.map((point) => point[k]));
    const base = { type: kind, mode: "lines", hoverinfo: "name" };
    // All solids are one trace: a hundred meshes would take seconds.
    if (figure.solids.length && view === "space") {
      const corners = [];
      const faces = [];
      for (const one of figure.solids) {
        for (const face of one.triangles) faces.push(face.map((corner) => corner + corners.length));
        corners.push(...one.vertices);
      }
      const [i, j, k] = columns(faces);
      data.push({ type: "mesh3d", ...at(...columns(corners)), i, j, k, color: solid, opacity: 0.55, flatshading: true, hoverinfo: "skip" });
    } else if (figure.solids.length) {
      const rings = [];
      for (const one of figure.solids) {
        const heights = view === "plan" ? [0] : [...new Set(one.vertices.map((v) => v[2]))];
        for (const d of heights) {
          const ring = view === "plan" ? one.outline.map((p) => [...p, 0]) : one.vertices.filter((v) => v[2] === d);
          rings.push(...ring, ring[0], [NaN, NaN, NaN]);
        }
      }
      data.push({ ...base, ...at(...columns(rings)), fill: "toself", fillcolor: crowd, line: { color: solid, width: 1 }, hoverinfo: "skip" });
    }
    for (const route of figure.planned) {
      data.push({ ...base, ...at(...columns(route)), line: { color: soft, width: 1, dash: "dash" }, name: "target's path, as planned", opacity: 0.7 });
    }
    for (const one of figure.traffic) data.push({ ...base, ...at(...path(one.p).map((a) => [...a])), line: { color: soft, width: 3, dash: view === "space" ? "solid" : "dot" }, name: `traffic ${one.label}` });
    const known = figure.paths.map((one) => ({ id: one.id, axes: path(one.p).map((a) => [...a]) })).filter((one) => one.axes[0].length);
    if (model.many) {
      const all = [[], [], []];
      for (const one of known) all.forEach((column, k) => column.push(...one.axes[k], NaN));
      data.push({ ...base, ...at(...all), line: view === "space" ? { color: solid, width: 1 } : { color: crowd, width: 1 }, name: "everyone", hoverinfo: "skip" });
    }
    const ends = [];
    for (const one of shown(known)) {
      const { color, dash, width } = pen(one.id);
      data.push({ ...base, ...at(...one.axes), line: view === "space" ? { color, width: 4 } : { color, dash, width }, name: label(one.id) });
      const last = one.axes[0].findLastIndex((v) => !Number.isNaN(v));
      ends.push({ point: one.axes.map((a) => a[last]), color, text: String(one.id) });
    }
    const spot = { type: kind, mode: "markers", hovertemplate: "%{text}<extra></extra>" };
    if (figure.points.length) {
      data.push({ ...spot, ...at(...columns(figure.points)), marker: { symbol: view === "space" ? "square" : "x", size: view === "space" ? 4 : 8, color: solid }, text: figure.points.map((p) => `obstacle, ${(-p[2]).toFixed(1)} m high`) });
    }
    if (figure.meets.length) {
      data.push({ ...spot, ...at(...columns(figure.meets.map((m) => m.p))), marker: { symbol: "diamond-open", size: view === "space" ? 5 : 10, color: ink, line: { width: 1.5, color: ink } }, text: figure.meets.map((m) => `transfer ${m.text}`) });
    }
    if (ends.length) {
      data.push({ ...spot, mode: "markers+text", ...at(...columns(ends.map((one) => one.point))), marker: { symbol: "circle", size: view === "space" ? 5 : 9, color: ends.map((one) => one.color) }, text: ends.map((one) => one.text), textposition: "top center", hovertemplate: "%{text} at the end<extra></extra>" });
    }
    const layout = { ...frame(div, narrow(div) ? 380 : 500), dragmode: view === "space" ? "turntable" : narrow(div) && !printing ? false : "pan" };
    if (view === "space") {
      const direction = (title, part) => ({ title: { text: title }, nticks: Math.ceil(8 * part), gridcolor: grid, color: ink, backgroundcolor: paper, zerolinecolor: grid });
      const spans = ["x", "y", "z"].map((k) => {
        let [low, high] = [Infinity, -Infinity];
        for (const one of data) for (const v of one[k]) { if (v < low) low = v; if (v > high) high = v; }
        return Math.max(high - low, 1e-3);
      });
      const [x, y, z] = spans.map((span) => (1.2 * span) / Math.max(...spans)); // one scale in all directions, all in view
      layout.scene = {
        xaxis: direction("east (m)", x), yaxis: direction("north (m)", y), zaxis: direction("height (m)", z), aspectmode: "manual", aspectratio: { x, y, z },
        camera: { eye: { x: -1.0, y: -1.6, z: 0.95 }, center: { x: 0, y: 0, z: -0.08 } },
      };
      layout.margin = { l: 0, r: 0, t: 0, b: 0 };
    } else if (view === "plan") {
      layout.xaxis = axis({ title: { text: "east (m)", standoff: 6 }, constrain: "domain" });
      layout.yaxis = axis({ title: { text: "north (m)", standoff: 4 }, scaleanchor: "x" });
    } else {
      layout.xaxis = axis({ visible: false });
      layout.yaxis = axis({ visible: false, scaleanchor: "x" });
      layout.annotations = [heading("seen from the south-east, half from above", 0)];
    }
    return { data, layout };
  }

  function timeline(figure, div) {
    const { stages } = look();
    const layout = frame(div, Math.min(90 + 30 * figure.rows.length, 900));
    const rows = [...figure.rows].reverse();
    Object.assign(layout, { barmode: "overlay", showlegend: true, bargap: 0.35, margin: { ...layout.margin, l: narrow(div) ? 76 : 110 } });
    layout.xaxis = axis({ title: { text: "session time (s)", standoff: 6 }, range: range ?? [0, model.end_s] });
    layout.yaxis = axis({ type: "category", categoryorder: "array", categoryarray: rows, automargin: false });
    const data = STAGES.map((stage, k) => {
      const bars = figure.bars.filter((bar) => bar.stage === k);
      return {
        type: "bar", orientation: "h", name: stage, y: bars.map((b) => b.row), base: bars.map((b) => b.from), x: bars.map((b) => b.to - b.from),
        marker: { color: stages[k] }, customdata: bars.map((b) => [b.from, b.to, b.text]),
        hovertemplate: `${stage} %{customdata[0]:.1f} to %{customdata[1]:.1f} s<br>%{customdata[2]}<extra>%{y}</extra>`,
      };
    });
    return { data, layout };
  }

  function ledger(figure, div) {
    const { colours, stages } = look();
    const rows = figure.rows.filter((row) => chosen.has(row.id)).reverse();
    const layout = frame(div, 110 + 46 * Math.max(rows.length, 1));
    Object.assign(layout, { barmode: "stack", showlegend: true, bargap: 0.25, margin: { ...layout.margin, l: narrow(div) ? 116 : 170 } });
    layout.xaxis = axis({ title: { text: "energy (kJ)", standoff: 6 } });
    layout.yaxis = axis({ automargin: false });
    const names = rows.flatMap((row) => [label(row.id), label(row.id)]);
    const sides = rows.flatMap(() => ["went", "came"]);
    const made = [
      ["initial", "initial_j", 1, stages[0]], ["received", "received_j", 1, colours[2]], ["drawn", "drawn_j", 0, colours[3]],
      ["given", "given_j", 0, colours[1]], ["remaining", "remaining_j", 0, colours[0]],
    ];
    const data = made.map(([name, key, side, color]) => ({
      type: "bar", orientation: "h", name, y: [names, sides], marker: { color },
      x: rows.flatMap((row) => (side ? [0, row[key] / 1e3] : [row[key] / 1e3, 0])),
      hovertemplate: `${name} %{x:.1f} kJ<extra>%{y}</extra>`,
    }));
    return { data, layout };
  }

  function drawing(div) {
    const figure = model.figures[div.dataset.figure];
    const view = div.dataset.view;
    if (figure.kind === "plan") return flight(figure, div, view === "space" && !webgl ? "drawn" : view);
    return { time: overTime, timeline, ledger }[figure.kind](figure, div);
  }
  const webgl = (() => {
    const canvas = document.createElement("canvas");
    return Boolean(canvas.getContext("webgl2") ?? canvas.getContext("webgl"));
  })();

  const plots = [...document.querySelectorAll(".plot")].filter((div) => model.figures[div.dataset.figure]);
  const onPaper = (div) => div.dataset.view === "drawn";
  const drawn = new Set();
  function draw(div) {
    const { data, layout } = drawing(div);
    if (drawn.has(div)) return void Plotly.react(div, data, layout, config(div));
    div.replaceChildren();
    div.style.minHeight = "0";
    Plotly.newPlot(div, data, layout, config(div));
    drawn.add(div);
    if (["time", "timeline"].includes(model.figures[div.dataset.figure].kind)) div.on("plotly_relayout", zoom);
  }
  function redraw() {
    for (const div of drawn) if (onPaper(div) === printing || !printing) draw(div);
  }
  let zooming = false;
  function zoom(change) {
    if (zooming) return;
    const from = change["xaxis.range[0]"] ?? change["xaxis.range"]?.[0];
    const to = change["xaxis.range[1]"] ?? change["xaxis.range"]?.[1];
    if (from === undefined && !change["xaxis.autorange"]) return;
    range = from === undefined ? null : [from, to];
    zooming = true;
    for (const div of drawn) {
      if (["time", "timeline"].includes(model.figures[div.dataset.figure].kind)) Plotly.relayout(div, { "xaxis.range": range ?? [0, model.end_s] });
    }
    zooming = false;
  }

  // who is shown

  const picker = document.querySelector(".picker");
  function swatch(id) {
    const { color, dash, width } = pen(id);
    const dashes = { solid: "", dash: "6 4", dot: "2 3", dashdot: "6 3 2 3" }[dash];
    return `<svg viewBox="0 0 24 10" aria-hidden="true"><line x1="0" y1="5" x2="24" y2="5" stroke="${color}" stroke-width="${width + 1}" stroke-dasharray="${dashes}"/></svg>`;
  }
  function fillPicker() {
    picker.querySelectorAll("button, select").forEach((old) => old.remove());
    const listed = model.many ? [...chosen].sort((a, b) => a - b) : model.vehicles.map((v) => v.id);
    for (const id of listed) {
      const button = document.createElement("button");
      button.type = "button";
      button.setAttribute("aria-pressed", String(chosen.has(id)));
      button.innerHTML = swatch(id);
      button.append(label(id));
      button.addEventListener("click", () => change(id));
      picker.append(button);
    }
    if (!model.many) return;
    const select = document.createElement("select");
    select.setAttribute("aria-label", "show one more vehicle");
    select.append(new Option("show one more …", ""));
    for (const vehicle of model.vehicles) if (!chosen.has(vehicle.id)) select.append(new Option(vehicle.label, vehicle.id));
    select.addEventListener("change", () => select.value && change(Number(select.value)));
    picker.append(select);
  }
  function change(id) {
    if (!chosen.delete(id)) chosen.add(id);
    fillPicker();
    redraw();
  }

  // tables that sort

  for (const table of document.querySelectorAll("table.sorts")) {
    const heads = [...table.tHead.rows[0].cells];
    heads.forEach((head, column) => {
      const button = document.createElement("button");
      button.type = "button";
      button.textContent = head.textContent;
      head.replaceChildren(button);
      button.addEventListener("click", () => {
        const up = head.getAttribute("aria-sort") !== "ascending";
        heads.forEach((other) => other.removeAttribute("aria-sort"));
        head.setAttribute("aria-sort", up ? "ascending" : "descending");
        const key = (row) => row.cells[column].textContent;
        const rows = [...table.tBodies[0].rows].sort((a, b) => key(a).localeCompare(key(b), undefined, { numeric: true }));
        table.tBodies[0].append(...(up ? rows : rows.reverse()));
      });
    });
  }

  // begin

  fillPicker();
  let series;
  try {
    const [packed, code] = await Promise.all([unpack("series"), unpack("plotly")]);
    series = packed;
    const script = document.createElement("script");
    script.textContent = new TextDecoder().decode(code);
    document.head.append(script);
  } catch (problem) {
    document.querySelectorAll(".waiting").forEach((one) => { one.textContent = `This browser cannot draw the figures (${problem.message}).`; });
    return;
  }
  // When each stage was reached, in ms since the page was asked for: tests and `make bench` read it.
  const mark = (stage) => { root.dataset[stage] = String(Math.round(performance.now())); };
  mark("unpacked");
  // What is costly comes last.
  const costly = (div) => Number(div.dataset.view === "space");
  for (const div of plots.filter((one) => !onPaper(one)).sort((a, b) => costly(a) - costly(b))) {
    draw(div);
    if (root.dataset.first === undefined) mark("first");
    if (!costly(div)) mark("flat");
    await new Promise((resolve) => { setTimeout(resolve); }); // the reader may scroll meanwhile
  }
  requestAnimationFrame(() => requestAnimationFrame(() => mark("all"))); // in the second frame, the first is on the screen

  darkly.addEventListener("change", () => { fillPicker(); redraw(); });
  let resized = 0;
  let width = document.body.clientWidth;
  window.addEventListener("resize", () => {
    clearTimeout(resized);
    resized = setTimeout(() => {
      if (printing || document.body.clientWidth === width) return;
      width = document.body.clientWidth;
      redraw();
    }, 150);
  });
  window.addEventListener("beforeprint", () => {
    printing = true;
    fillPicker();
    for (const div of plots) if (div.dataset.view !== "space") draw(div);
  });
  window.addEventListener("afterprint", () => {
    printing = false;
    fillPicker();
    redraw();
  });
})();
