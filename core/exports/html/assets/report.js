// The turning view of a report: the points of the element "data" in WebGL, turned by mouse, fingers and keys; a pick tells a cell's numbers.
(function () {
  'use strict';
  var data = JSON.parse(document.getElementById('data').textContent);
  var canvas = document.getElementById('view'), told = document.getElementById('pick');
  // The words of the view are texts of the page, so that a translated page has translated ones.
  var words = [].map.call(document.querySelectorAll('#viewwords span'), function (s) { return s.textContent; }), names = words.slice(5);
  function filled(text, values) { return text.replace(/%([1-9])/g, function (all, n) { return values[n - 1]; }); }

  function bytesOf(text) {
    var raw = atob(text), bytes = new Uint8Array(raw.length);
    for (var i = 0; i < raw.length; i++) bytes[i] = raw.charCodeAt(i);
    return bytes;
  }
  var count = data.count;
  var positions = new Float32Array(bytesOf(data.positions).buffer), ranges = new Float32Array(bytesOf(data.ranges).buffer);
  var cells = new Uint32Array(bytesOf(data.cells).buffer), classes = bytesOf(data.classes), levels = bytesOf(data.levels);

  var rocks = data.rocks ? new Uint16Array(bytesOf(data.rocks).buffer) : null, rocksOn = rocks !== null;

  // ---- vectors ----
  function minus(a, b) { return [a[0] - b[0], a[1] - b[1], a[2] - b[2]]; }
  function plus(a, b, t) { return [a[0] + b[0] * t, a[1] + b[1] * t, a[2] + b[2] * t]; }
  function dot(a, b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
  function cross(a, b) { return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]; }
  function unit(a) { var n = Math.sqrt(dot(a, a)) || 1; return [a[0] / n, a[1] / n, a[2] / n]; }

  // ---- where one looks from: an orbit about the cloud's middle, first from the scanner's side ----
  var middle = [0, 0, 0], i;
  for (i = 0; i < count * 3; i++) middle[i % 3] += positions[i] / Math.max(1, count);
  var ahead = minus(middle, data.sensor), far = Math.max(0.1, Math.sqrt(dot(ahead, ahead)));
  ahead = unit(ahead);
  var pole = Math.abs(ahead[2]) < 0.9 ? [0, 0, 1] : [0, 1, 0];
  var east = unit(cross(ahead, pole)), north = cross(east, ahead);
  var start = { yaw: 0.3, pitch: 0.15, distance: far * 2, target: middle.slice() };
  var now = copy(start), picked = -1, turning = false, pointSize = 2, edgesOnly = false;
  function copy(s) { return { yaw: s.yaw, pitch: s.pitch, distance: s.distance, target: s.target.slice() }; }
  function camera() {
    var back = plus([0, 0, 0], ahead, -Math.cos(now.pitch) * Math.cos(now.yaw));
    back = plus(back, east, Math.cos(now.pitch) * Math.sin(now.yaw));
    back = plus(back, north, Math.sin(now.pitch));
    var forward = plus([0, 0, 0], back, -1);
    var sideways = plus(plus([0, 0, 0], ahead, Math.sin(now.yaw)), east, Math.cos(now.yaw));
    var right = unit(sideways), up = cross(right, forward);
    return { eye: plus(now.target, back, now.distance), right: right, up: up, forward: forward };
  }
  var focal = 1.3; // of half the height

  // ---- drawing ----
  var gl = canvas.getContext('webgl', { antialias: true, preserveDrawingBuffer: true });
  var program, where = {};
  function shader(kind, text) {
    var s = gl.createShader(kind);
    gl.shaderSource(s, text);
    gl.compileShader(s);
    return s;
  }
  // Faces of rocks, uncertain ones striped; else edges.
  function colourOf(k) {
    var level = 60 + levels[k] * 0.6;
    if (!rocksOn) return classes[k] ? data.colours[classes[k] - 1] : [level, level, level];
    var face = rocks[k] ? data.faces.rocks[rocks[k] - 1] : null;
    if (!face) return [level * 0.6, level * 0.6, level * 0.6];
    var dark = face[1] && (Math.floor(cells[k] / data.beams) + cells[k] % data.beams) % 8 < 3 ? 0.33 : 1;
    return data.faces.colours[face[0]].map(function (c) { return c * dark; });
  }
  function paint() {
    var colours = new Uint8Array(count * 4);
    for (var k = 0; k < count; k++) {
      var c = colourOf(k);
      colours.set([c[0], c[1], c[2], classes[k] && !rocksOn ? 255 : 0], k * 4);
    }
    return colours;
  }
  var colourBuffer = null;
  function prepare() {
    program = gl.createProgram();
    gl.attachShader(program, shader(gl.VERTEX_SHADER,
      'attribute vec3 place; attribute vec4 colour; uniform vec3 eye, right, up, forward; uniform vec2 focal; uniform float size, near, far, mark;' +
      'varying vec3 shown; void main() { vec3 d = place - eye; float z = dot(d, forward); float edge = colour.a;' +
      'gl_Position = vec4(dot(d, right) * focal.x, dot(d, up) * focal.y, ((far + near) * z - 2.0 * far * near) / (far - near) - edge * 0.004 * z, z);' +
      'gl_PointSize = mark > 0.0 ? mark : size * (1.0 + edge); shown = mark > 0.0 ? vec3(1.0, 0.25, 0.1) : colour.rgb; }'));
    gl.attachShader(program, shader(gl.FRAGMENT_SHADER,
      'precision mediump float; varying vec3 shown; void main() { gl_FragColor = vec4(shown, 1.0); }'));
    gl.linkProgram(program);
    gl.useProgram(program);
    [['place', positions, 3, gl.FLOAT, false], ['colour', paint(), 4, gl.UNSIGNED_BYTE, true]].forEach(function (a) {
      colourBuffer = gl.createBuffer(); // the last one
      gl.bindBuffer(gl.ARRAY_BUFFER, colourBuffer);
      gl.bufferData(gl.ARRAY_BUFFER, a[1], gl.STATIC_DRAW);
      var at = gl.getAttribLocation(program, a[0]);
      gl.enableVertexAttribArray(at);
      gl.vertexAttribPointer(at, a[2], a[3], a[4], 0, 0);
    });
    ['eye', 'right', 'up', 'forward', 'focal', 'size', 'near', 'far', 'mark'].forEach(function (n) { where[n] = gl.getUniformLocation(program, n); });
    gl.enable(gl.DEPTH_TEST);
    gl.clearColor(23 / 255, 25 / 255, 27 / 255, 1);
  }
  function draw() {
    if (!gl) return;
    var ratio = window.devicePixelRatio || 1;
    var w = Math.max(1, Math.round(canvas.clientWidth * ratio)), h = Math.max(1, Math.round(canvas.clientHeight * ratio));
    if (canvas.width !== w || canvas.height !== h) { canvas.width = w; canvas.height = h; }
    gl.viewport(0, 0, w, h);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    var c = camera();
    gl.uniform3fv(where.eye, c.eye);
    gl.uniform3fv(where.right, c.right);
    gl.uniform3fv(where.up, c.up);
    gl.uniform3fv(where.forward, c.forward);
    gl.uniform2f(where.focal, focal * h / w, focal);
    gl.uniform1f(where.near, 0.02 * now.distance);
    gl.uniform1f(where.far, 20 * (now.distance + far));
    gl.uniform1f(where.size, pointSize * ratio);
    gl.uniform1f(where.mark, 0);
    if (!edgesOnly) gl.drawArrays(gl.POINTS, 0, count);
    else for (var k = 0; k < count;) { // runs of edge cells
      while (k < count && !classes[k]) k++;
      var first = k;
      while (k < count && classes[k]) k++;
      if (k > first) gl.drawArrays(gl.POINTS, first, k - first);
    }
    if (picked >= 0) {
      gl.disable(gl.DEPTH_TEST);
      gl.uniform1f(where.mark, 9 * ratio);
      gl.drawArrays(gl.POINTS, picked, 1);
      gl.enable(gl.DEPTH_TEST);
    }
  }

  // ---- picking: the nearest to the viewer of those near to the place ----
  function pick(x, y) {
    var c = camera(), h = canvas.clientHeight, half = h / 2, best = -1, bestScore = Infinity;
    for (var k = 0; k < count; k++) {
      if (edgesOnly && !classes[k]) continue;
      var d = [positions[3 * k] - c.eye[0], positions[3 * k + 1] - c.eye[1], positions[3 * k + 2] - c.eye[2]];
      var z = dot(d, c.forward);
      if (z <= 0.02 * now.distance) continue;
      var px = canvas.clientWidth / 2 + focal * half * dot(d, c.right) / z - x, py = half - focal * half * dot(d, c.up) / z - y;
      var off = px * px + py * py;
      if (off > 400) continue;
      var score = z * (1 + off / 60);
      if (score < bestScore) { bestScore = score; best = k; }
    }
    picked = best;
    tell();
    draw();
  }
  function tell() {
    if (picked < 0) { told.textContent = words[0]; return; }
    var k = picked, line = Math.floor(cells[k] / data.beams), beam = cells[k] % data.beams;
    var place = [0, 1, 2].map(function (a) { return data.origin[a] + positions[3 * k + a]; });
    var shown = (data.placed ? ['E ', 'N ', 'RL '] : ['x ', 'y ', 'z ']).map(function (n, a) { return n + place[a].toFixed(3); }).join(', ');
    var text = filled(words[1], [line, beam, Math.round(ranges[k]), names[classes[k]], shown]);
    if (data.beam_deg) text += ' ' + filled(words[2], [data.beam_deg[beam].toFixed(3), data.line_deg[line].toFixed(3)]);
    if (rocks && rocks[k]) text += ' ' + filled(words[3], [rocks[k]].concat(data.faces.rocks[rocks[k] - 1].slice(2)));
    told.textContent = text;
  }

  // ---- hands and keys ----
  function turn(x, y) {
    now.yaw += x;
    now.pitch = Math.max(-1.5, Math.min(1.5, now.pitch + y));
    draw();
  }
  function nearer(factor) { now.distance = Math.max(0.05, Math.min(50 * far, now.distance * factor)); draw(); }
  function shift(x, y) {
    var c = camera(), step = now.distance * 0.05;
    now.target = plus(plus(now.target, c.right, x * step), c.up, y * step);
    draw();
  }
  var held = {}, moved = 0, apart = 0;
  canvas.addEventListener('pointerdown', function (e) {
    held[e.pointerId] = [e.clientX, e.clientY];
    moved = 0;
    apart = 0;
    canvas.setPointerCapture(e.pointerId);
  });
  canvas.addEventListener('pointermove', function (e) {
    var before = held[e.pointerId];
    if (!before) return;
    var dx = e.clientX - before[0], dy = e.clientY - before[1];
    held[e.pointerId] = [e.clientX, e.clientY];
    moved += Math.abs(dx) + Math.abs(dy);
    var ids = Object.keys(held);
    if (ids.length === 2) {
      var a = held[ids[0]], b = held[ids[1]], gap = Math.hypot(a[0] - b[0], a[1] - b[1]);
      if (apart > 0 && gap > 0) nearer(apart / gap);
      apart = gap;
    } else if (e.shiftKey || e.buttons === 2 || e.buttons === 4) {
      shift(-dx / 25, dy / 25);
    } else {
      turn(-dx * 0.008, dy * 0.008);
    }
  });
  canvas.addEventListener('pointerup', function (e) {
    var single = Object.keys(held).length === 1;
    delete held[e.pointerId];
    var box = canvas.getBoundingClientRect();
    if (single && moved < 5) pick(e.clientX - box.left, e.clientY - box.top);
  });
  canvas.addEventListener('pointercancel', function (e) { delete held[e.pointerId]; });
  canvas.addEventListener('contextmenu', function (e) { e.preventDefault(); });
  canvas.addEventListener('wheel', function (e) { e.preventDefault(); nearer(Math.exp(e.deltaY * 0.001)); }, { passive: false });
  canvas.addEventListener('keydown', function (e) {
    var way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[e.key];
    if (way && e.shiftKey) shift(way[0], way[1]);
    else if (way) turn(way[0] * 0.08, way[1] * 0.08);
    else if (e.key === '+' || e.key === '=') nearer(0.9);
    else if (e.key === '-') nearer(1 / 0.9);
    else if (e.key === 'Enter') pick(canvas.clientWidth / 2, canvas.clientHeight / 2);
    else if (e.key === 'Home') { now = copy(start); draw(); }
    else return;
    e.preventDefault();
  });
  var buttons = document.querySelectorAll('#viewtools button');
  function button(at, press) {
    var b = buttons[at];
    b.onclick = function () { press(b); };
  }
  function step() {
    if (!turning) return;
    turn(0.006, 0);
    window.requestAnimationFrame(step);
  }
  if (!gl) {
    told.textContent = words[4];
    canvas.style.display = 'none';
    document.getElementById('viewtools').style.display = 'none';
    return;
  }
  button(0, function (b) { turning = !turning; b.setAttribute('aria-pressed', turning); step(); });
  button(1, function (b) { edgesOnly = !edgesOnly; b.setAttribute('aria-pressed', edgesOnly); draw(); });
  button(2, function () { nearer(0.8); });
  button(3, function () { nearer(1.25); });
  button(4, function () { pointSize = pointSize % 5 + 1; draw(); });
  button(5, function () { now = copy(start); draw(); });
  if (rocks) button(6, function (b) {
    rocksOn = !rocksOn;
    b.setAttribute('aria-pressed', rocksOn);
    gl.bindBuffer(gl.ARRAY_BUFFER, colourBuffer);
    gl.bufferData(gl.ARRAY_BUFFER, paint(), gl.STATIC_DRAW);
    draw();
  });
  prepare();
  draw();
  window.addEventListener('resize', draw);
})();
