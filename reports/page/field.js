// SPDX-License-Identifier: MIT
// The page field.html: errors of several evaluations side by side in 3D, only from the data inside the page.
'use strict';

(async () => {
const byId = (id) => document.getElementById(id);
const message = byId('message');

const bytesOf = (text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
const floatsOf = (text) => new Float32Array(bytesOf(text).buffer);
const wholeNumbersOf = (text) => new Uint32Array(bytesOf(text).buffer);

// The library is kept packed: a third of its text.
async function load() {
  const stream = new Blob([bytesOf(byId('vtk').textContent)]).stream().pipeThrough(new DecompressionStream('gzip'));
  const script = document.createElement('script');
  script.textContent = await new Response(stream).text();
  document.head.append(script);
}

const data = JSON.parse(byId('data').textContent);
const [low, high] = data.range;

function colourOf(t) {
  const place = Math.min(Math.max(t, 0), 1) * (data.palette.length - 1), i = Math.min(Math.floor(place), data.palette.length - 2);
  return data.palette[i].map((c, k) => c + (place - i) * (data.palette[i + 1][k] - c));
}

function drawLegend() {
  const css = data.palette.map((c) => `rgb(${c.map((x) => Math.round(255 * x)).join(' ')})`);
  byId('bar').style.background = `linear-gradient(to right, ${css.join(', ')})`;
  const step = Math.max(1, Math.ceil((high - low) / (innerWidth < 700 ? 5 : 9)));
  const decades = [];
  for (let decade = high; decade - low >= step / 2; decade -= step) decades.unshift(decade);
  for (const decade of [low, ...decades.filter((d) => d - low > step / 2)]) {
    const tick = document.createElement('span');
    tick.style.left = `${100 * (decade - low) / (high - low)}%`;
    tick.innerHTML = `10<sup>${decade}</sup>`;
    byId('ticks').append(tick);
  }
}

// Text of a value on the logarithmic scale.
function textOf(value) {
  if (Number.isNaN(value)) return 'no value';
  if (value > 300) return 'not finite';
  if (value <= low) return `${(10 ** low).toExponential(0)} or less`;
  return (10 ** value).toExponential(1);
}

drawLegend();
try {
  if (typeof DecompressionStream === 'undefined') throw new Error('this browser is too old to unpack what draws (DecompressionStream)');
  if (!document.createElement('canvas').getContext('webgl2')) throw new Error('this browser has no WebGL 2');
  await load();
  start();
  message.hidden = true;
} catch (error) {
  message.textContent = `Nothing is drawn: ${error.message}. The same field as a picture: ${data.picture}`;
  document.documentElement.dataset.state = 'failed';
}

function start() {
  const { Core } = vtk.Rendering;
  const scene = byId('scene');
  const image = data.image, compared = data.compared;
  const values = image.values.map(floatsOf);
  const [nx, ny, nz] = image.points;
  const sampleAt = (i, j, k) => i + nx * (j + ny * k);
  const corner = (i, j, k) => [image.origin[0] + image.spacing[0] * (i - 0.5), image.origin[1] + image.spacing[1] * (j - 0.5),
    image.origin[2] + image.spacing[2] * (k - 0.5)];
  const centre = (sample) => [image.origin[0] + image.spacing[0] * (sample % nx), image.origin[1] + image.spacing[1] * (Math.floor(sample / nx) % ny),
    image.origin[2] + image.spacing[2] * Math.floor(sample / (nx * ny))];

  const colours = Core.vtkColorTransferFunction.newInstance();
  data.palette.forEach((c, i) => colours.addRGBPoint(low + (high - low) * i / (data.palette.length - 1), ...c));
  colours.setNanColor([...data.masked, 1]);
  colours.setUseAboveRangeColor(true);
  colours.setAboveRangeColor([...data.infinite, 1]);
  colours.setMappingRange(low, high);
  colours.updateRange();

  const view = vtk.Rendering.Misc.vtkGenericRenderWindow.newInstance({ background: [1, 1, 1], listenWindowResize: false });
  view.setContainer(scene);
  const window_ = view.getRenderWindow();
  const renderers = compared.map((_, i) => (i === 0 ? view.getRenderer() : Core.vtkRenderer.newInstance({ background: [1, 1, 1] })));
  renderers.slice(1).forEach((renderer) => window_.addRenderer(renderer));
  const camera = renderers[0].getActiveCamera();
  renderers.forEach((renderer) => renderer.setActiveCamera(camera));

  const samplesOf = new WeakMap();  // which samples an actor's cells or points are
  function polyData({ points, verts, lines, polys }) {
    const poly = vtk.Common.DataModel.vtkPolyData.newInstance();
    poly.getPoints().setData(points, 3);
    if (verts) poly.getVerts().setData(verts);
    if (lines) poly.getLines().setData(lines);
    if (polys) poly.getPolys().setData(polys);
    return poly;
  }

  function actorOf(poly, scalars, onCells) {
    const mapper = Core.vtkMapper.newInstance();
    mapper.setInputData(poly);
    if (scalars) {
      const array = vtk.Common.Core.vtkDataArray.newInstance({ name: 'error', values: scalars, numberOfComponents: 1 });
      (onCells ? poly.getCellData() : poly.getPointData()).setScalars(array);
      mapper.setScalarMode(onCells ? 2 : 1);
      mapper.setLookupTable(colours);
      mapper.setUseLookupTableScalarRange(true);
    } else mapper.setScalarVisibility(false);
    const actor = Core.vtkActor.newInstance();
    actor.setMapper(mapper);
    actor.getProperty().setLighting(!scalars);
    return actor;
  }

  // One square a sample, so that what is seen is what was measured.
  function sliceActor(axis, at, v) {
    const [a, b] = [0, 1, 2].filter((c) => c !== axis), n = image.points;
    const points = [], polys = [], scalars = [], samples = [];
    for (let q = 0; q < n[b]; ++q)
      for (let p = 0; p < n[a]; ++p) {
        const first = points.length / 3;
        for (const [s, t] of [[0, 0], [1, 0], [1, 1], [0, 1]]) {
          const index = [0, 0, 0];
          index[a] = p + s, index[b] = q + t, index[axis] = at + 0.5;
          points.push(...corner(...index));
        }
        polys.push(4, first, first + 1, first + 2, first + 3);
        const index = [0, 0, 0];
        index[a] = p, index[b] = q, index[axis] = at;
        samples.push(sampleAt(...index));
        scalars.push(values[v][samples[samples.length - 1]]);
      }
    const actor = actorOf(polyData({ points: new Float32Array(points), polys: new Uint32Array(polys) }), new Float32Array(scalars), true);
    samplesOf.set(actor, { ids: samples, of: 'image' });
    return actor;
  }

  function pointsActor(points, kept, all, of, size) {
    const at = new Float32Array(3 * kept.length), verts = new Uint32Array(2 * kept.length), scalars = new Float32Array(kept.length);
    kept.forEach((id, i) => {
      at.set(points(id), 3 * i);
      verts.set([1, i], 2 * i);
      scalars[i] = all[id];
    });
    const actor = actorOf(polyData({ points: at, verts }), scalars, false);
    actor.getProperty().setPointSize(size);
    samplesOf.set(actor, { ids: kept, of });
    return actor;
  }

  const cagePoints = floatsOf(data.cage.vertices);
  const cageEdges = () => {
    const actor = actorOf(polyData({ points: cagePoints, lines: wholeNumbersOf(data.cage.edges) }));
    actor.getProperty().set({ color: [0.05, 0.05, 0.05], lineWidth: 2, lighting: false });
    actor.setPickable(false);
    return actor;
  };
  const cageFaces = () => {
    const actor = actorOf(polyData({ points: cagePoints, polys: wholeNumbersOf(data.cage.faces) }));
    actor.getProperty().set({ color: [0.45, 0.55, 0.7], opacity: 0.25 });
    actor.setPickable(false);
    return actor;
  };

  const mesh = data.mesh && { points: floatsOf(data.mesh.vertices), faces: wholeNumbersOf(data.mesh.faces), values: data.mesh.values.map(floatsOf) };
  function meshActors(v) {
    const all = mesh.values[v], measured = [];
    all.forEach((x, i) => { if (!Number.isNaN(x)) measured.push(i); });
    const place = (id) => mesh.points.subarray(3 * id, 3 * id + 3);
    // A surface takes its vertices' colours where most of them have one; else it is shown plain, with those as points.
    const dense = mesh.faces.length > 0 && 2 * measured.length > all.length;
    const actors = [];
    if (dense) {
      const surface = actorOf(polyData({ points: mesh.points, polys: mesh.faces }), all, false);
      surface.getMapper().setInterpolateScalarsBeforeMapping(true);
      samplesOf.set(surface, { ids: null, of: 'mesh' });
      actors.push(surface);
    } else {
      if (mesh.faces.length > 0) {
        const surface = actorOf(polyData({ points: mesh.points, polys: mesh.faces }));
        surface.getProperty().set({ color: [0.8, 0.8, 0.8] });
        surface.setPickable(false);
        actors.push(surface);
      }
      actors.push(pointsActor(place, measured, all, 'mesh', 7));
    }
    return actors;
  }

  const sliders = ['x', 'y', 'z'].map((name, axis) => {
    const label = document.createElement('label');
    label.innerHTML = `<input type="checkbox" checked aria-label="slice across ${name}"> ${name} <input type="range" min="0" aria-label="where the slice lies along ${name}">`;
    const [on, range] = label.querySelectorAll('input');
    range.max = image.points[axis] - 1;
    range.value = Math.floor(image.points[axis] / 2);
    label.hidden = image.points[axis] < 2 && image.points.filter((n) => n > 1).length > 1 ? false : image.points[axis] < 2;
    byId('slices').append(label);
    on.addEventListener('change', update);
    range.addEventListener('input', update);
    return { on, range };
  });
  if (image.points.includes(1)) sliders.forEach((s, axis) => { s.on.checked = image.points[axis] === 1; });

  const threshold = byId('threshold');
  threshold.min = low, threshold.max = high, threshold.value = Math.round((low + high) / 2);

  function update() {
    const what = byId('what').value, chosen = byId('shown').value;
    byId('slices').hidden = what !== 'slices';
    byId('threshold_label').hidden = what !== 'points';
    byId('threshold_text').textContent = `1e${threshold.value}`;
    renderers.forEach((renderer, v) => {
      renderer.removeAllViewProps();
      renderer.setDraw?.(chosen === 'all' || Number(chosen) === v);
      renderer.addActor(cageEdges());
      if (what === 'slices')
        sliders.forEach((s, axis) => { if (s.on.checked) renderer.addActor(sliceActor(axis, Number(s.range.value), v)); });
      else if (what === 'points') {
        const kept = [];
        values[v].forEach((x, i) => { if (x >= Number(threshold.value)) kept.push(i); });
        if (kept.length > 0) renderer.addActor(pointsActor(centre, kept, values[v], 'image', 6));
      } else meshActors(v).forEach((actor) => renderer.addActor(actor));
      if (byId('faces').checked) renderer.addActor(cageFaces());
    });
    arrange();
  }

  // Side by side, or one above the other where the window is taller than wide.
  function arrange() {
    const chosen = byId('shown').value, shown = compared.map((_, i) => i).filter((i) => chosen === 'all' || Number(chosen) === i);
    const { clientWidth: width, clientHeight: height } = scene, across = width >= height;
    const names = byId('names').children;
    renderers.forEach((renderer, i) => {
      const at = shown.indexOf(i), n = shown.length;
      names[i].hidden = at < 0;
      if (at < 0) renderer.setViewport(0, 0, 0.0001, 0.0001);
      else if (across) renderer.setViewport(at / n, 0, (at + 1) / n, 1);
      else renderer.setViewport(0, 1 - (at + 1) / n, 1, 1 - at / n);
      names[i].style.left = across ? `${100 * at / n}%` : '0';
      names[i].style.top = across ? '0' : `${100 * at / n}%`;
    });
    view.resize();
    renderers.forEach((renderer) => renderer.resetCameraClippingRange(bounds()));
    window_.render();
  }

  function bounds() {
    const box = [Infinity, -Infinity, Infinity, -Infinity, Infinity, -Infinity];
    const take = (p) => { for (let c = 0; c < 3; ++c) box[2 * c] = Math.min(box[2 * c], p[c]), box[2 * c + 1] = Math.max(box[2 * c + 1], p[c]); };
    take(corner(0, 0, 0));
    take(corner(nx, ny, nz));
    for (let i = 0; i < cagePoints.length; i += 3) take(cagePoints.subarray(i, i + 3));
    return box;
  }

  function reset() {
    const flat = image.points.indexOf(1);
    camera.setViewUp(...(flat === 1 ? [0, 0, 1] : [0, 1, 0]));
    camera.setFocalPoint(0, 0, 0);
    camera.setPosition(...(flat === 0 ? [1, 0, 0] : flat === 1 ? [0, -1, 0] : flat === 2 ? [0, 0, 1] : [0.75, 0.55, 1]));
    renderers[0].resetCamera(bounds());
    // The camera's angle is upwards: where a view is narrower than high, its width is what must hold the cage.
    const [x0, y0, x1, y1] = renderers[Math.max(0, Number(byId('shown').value) || 0)].getViewport();
    const aspect = (x1 - x0) * scene.clientWidth / ((y1 - y0) * scene.clientHeight);
    camera.dolly(1.2 * Math.min(1, aspect));
    renderers.forEach((renderer) => renderer.resetCameraClippingRange(bounds()));
    window_.render();
  }

  const picker = Core.vtkCellPicker.newInstance({ tolerance: 0.004 });
  let pressed = null;
  scene.addEventListener('pointerdown', (e) => { pressed = [e.clientX, e.clientY]; }, true);
  scene.addEventListener('pointerup', (e) => {
    if (pressed && Math.hypot(e.clientX - pressed[0], e.clientY - pressed[1]) < 4) read(e);
    pressed = null;
  }, true);

  // The value of the sample that was clicked, in every evaluation.
  function read(e) {
    const box = scene.getBoundingClientRect(), [width, height] = view.getApiSpecificRenderWindow().getSize();
    const x = (e.clientX - box.left) / box.width * width, y = (1 - (e.clientY - box.top) / box.height) * height;
    const renderer = renderers.find((r) => {
      const [x0, y0, x1, y1] = r.getViewport();
      return x / width >= x0 && x / width <= x1 && y / height >= y0 && y / height <= y1;
    });
    if (!renderer) return;
    picker.pick([x, y, 0], renderer);
    const found = picker.getActors().map((actor) => samplesOf.get(actor)).find(Boolean);
    if (!found) return;
    const id = found.ids ? found.ids[found.of === 'mesh' || byId('what').value === 'points' ? picker.getPointId() : picker.getCellId()] : picker.getPointId();
    if (id === undefined || id < 0) return;
    const at = found.of === 'mesh' ? [...mesh.points.subarray(3 * id, 3 * id + 3)] : centre(id);
    const all = found.of === 'mesh' ? mesh.values : values;
    byId('value').textContent = `At (${at.map((c) => c.toPrecision(4)).join(', ')}): ` +
      compared.map((name, v) => `${name} ${textOf(all[v][id])}`).join(', ');
  }

  scene.addEventListener('keydown', (e) => {
    const turn = { ArrowLeft: [8, 0], ArrowRight: [-8, 0], ArrowUp: [0, -8], ArrowDown: [0, 8] }[e.key];
    if (turn) camera.azimuth(turn[0]), camera.elevation(turn[1]), camera.orthogonalizeViewUp();
    else if (e.key === '+' || e.key === '=') camera.dolly(1.1);
    else if (e.key === '-') camera.dolly(1 / 1.1);
    else return;
    e.preventDefault();
    renderers.forEach((renderer) => renderer.resetCameraClippingRange(bounds()));
    window_.render();
  });
  for (const id of ['shown', 'what', 'faces']) byId(id).addEventListener('change', update);
  threshold.addEventListener('input', update);
  byId('reset').addEventListener('click', reset);
  addEventListener('resize', arrange);
  update();
  reset();
  document.documentElement.dataset.state = 'drawn';
  // For tests and scripts: how much of the canvas is drawn.
  window.cageproof = { view, renderers, camera, values };
}
})();
