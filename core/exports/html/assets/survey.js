// The survey of an archive: sorts, filters and pages the rows of the element "data".
(function () {
  'use strict';
  var rows = JSON.parse(document.getElementById('data').textContent);
  function metres(v) { return v.toFixed(2) + ' m'; }
  var columns = [
    { title: 'Scan', of: function (r) { return r[0]; }, text: true },
    { title: 'Outcome', of: function (r) { return r[1]; }, text: true },
    { title: 'Scanned', of: function (r) { return r[3]; }, text: true },
    { title: 'Lines', of: function (r) { return r[4]; } },
    { title: 'Beams', of: function (r) { return r[5]; } },
    { title: 'Measured', of: function (r) { return r[6]; }, show: function (v) { return (v * 100).toFixed(1) + ' %'; } },
    { title: 'Edge cells', of: function (r) { return r[7]; } },
    { title: 'Noise at 5 m', of: function (r) { return r[8]; }, show: function (v) { return v.toFixed(1) + ' mm'; } },
    { title: 'Rocks', of: function (r) { return r[12]; }, rocks: true },
    { title: 'Visible P50', of: function (r) { return r[13]; }, show: metres, rocks: true },
    { title: 'Visible P80', of: function (r) { return r[14]; }, show: metres, rocks: true },
    { title: 'Largest visible', of: function (r) { return r[15]; }, show: metres, rocks: true },
    { title: 'Warnings', of: function (r) { return r[9].length; }, titles: function (r) { return r[9]; } }
  ].filter(function (column) { // an archive that was run without rocks has no columns of them
    return !column.rocks || rows.some(function (r) { return column.of(r) !== null; });
  });
  var state = { sort: -1, down: false, page: 0, size: 100, filter: '', outcome: '' };

  function make(tag, text, parent) {
    var element = document.createElement(tag);
    if (text !== undefined && text !== null) element.textContent = text;
    if (parent) parent.appendChild(element);
    return element;
  }

  function chosen() {
    var words = state.filter.toLowerCase();
    var some = rows.filter(function (r) {
      if (state.outcome && r[1] !== state.outcome) return false;
      return !words || (r[0] + ' ' + r[9].join(' ') + ' ' + r[10]).toLowerCase().indexOf(words) >= 0;
    });
    if (state.sort < 0) return some;
    var column = columns[state.sort], sign = state.down ? -1 : 1;
    return some.map(function (r, i) { return [r, i]; }).sort(function (a, b) {
      var x = column.of(a[0]), y = column.of(b[0]);
      var noX = x === null || x === '', noY = y === null || y === '';
      if (noX || noY) return noX === noY ? a[1] - b[1] : noX ? 1 : -1; // what is not known stands last, either way
      if (x === y) return a[1] - b[1];
      return (x < y ? -1 : 1) * sign;
    }).map(function (pair) { return pair[0]; });
  }

  function link(row, parent) {
    var a = make(row[2] ? 'a' : 'span', row[0], parent);
    if (row[2]) a.href = row[2];
    return a;
  }

  function drawSheet(some) {
    var sheet = document.getElementById('sheet');
    sheet.textContent = '';
    some.forEach(function (row) {
      var figure = make('figure', null, sheet);
      figure.className = row[1];
      var frame = make(row[2] ? 'a' : 'span', null, figure);
      frame.className = 'frame';
      if (row[2]) frame.href = row[2];
      if (row[11]) {
        var picture = make('img', null, frame);
        picture.src = 'data:image/png;base64,' + row[11];
        picture.alt = 'Gray levels and edges of ' + row[0];
      } else {
        make('span', row[1] === 'done' ? 'no picture' : row[1], frame);
      }
      var words = make('figcaption', row[0].split('/').pop(), figure);
      words.title = row[0] + (row[10] ? '\n' + row[10] : '');
    });
  }

  function drawTable(some) {
    var table = document.getElementById('table');
    table.textContent = '';
    var head = make('tr', null, make('thead', null, table));
    columns.forEach(function (column, i) {
      var cell = make('th', null, head);
      cell.scope = 'col';
      cell.setAttribute('aria-sort', state.sort !== i ? 'none' : state.down ? 'descending' : 'ascending');
      var button = make('button', column.title + (state.sort !== i ? '' : state.down ? ' \u25be' : ' \u25b4'), cell);
      button.onclick = function () {
        state.down = state.sort === i ? !state.down : false;
        state.sort = i;
        draw();
      };
    });
    var body = make('tbody', null, table);
    some.forEach(function (row) {
      var line = make('tr', null, body);
      line.className = row[1];
      columns.forEach(function (column, i) {
        var cell = make('td', null, line), value = column.of(row);
        if (!column.text) cell.className = 'number';
        if (i === 0) link(row, cell);
        else if (value !== null && value !== '') cell.textContent = column.show ? column.show(value) : value;
        if (i === 0 && row[10]) make('div', row[10], cell).className = 'error';
        if (column.titles && value > 0) cell.title = column.titles(row).join('\n');
      });
    });
  }

  function draw() {
    var all = chosen();
    var pages = Math.max(1, Math.ceil(all.length / state.size));
    state.page = Math.min(state.page, pages - 1);
    var some = all.slice(state.page * state.size, (state.page + 1) * state.size);
    document.getElementById('place').textContent =
      all.length + ' of ' + rows.length + ' scans, page ' + (state.page + 1) + ' of ' + pages;
    drawSheet(some);
    drawTable(some);
  }

  function tools() {
    var box = document.getElementById('tools');
    var filter = make('input', null, box);
    filter.type = 'search';
    filter.placeholder = 'Part of a path, warning or error';
    filter.setAttribute('aria-label', filter.placeholder);
    filter.oninput = function () { state.filter = filter.value; state.page = 0; draw(); };
    var outcome = make('select', null, box);
    outcome.setAttribute('aria-label', 'Outcome');
    ['', 'done', 'refused', 'failed'].forEach(function (name) { make('option', name || 'every outcome', outcome).value = name; });
    outcome.onchange = function () { state.outcome = outcome.value; state.page = 0; draw(); };
    [['\u2039', -1, 'Page before'], ['\u203a', 1, 'Next page']].forEach(function (way) {
      var button = make('button', way[0], box);
      button.setAttribute('aria-label', way[2]);
      button.onclick = function () { state.page = Math.max(0, state.page + way[1]); draw(); };
    });
    make('span', '', box).id = 'place';
  }

  var counts = {};
  rows.forEach(function (r) { counts[r[1]] = (counts[r[1]] || 0) + 1; });
  document.getElementById('summary').textContent = rows.length + ' scans: ' +
    ['done', 'refused', 'failed'].filter(function (n) { return counts[n]; }).map(function (n) { return counts[n] + ' ' + n; }).join(', ') + '.';
  tools();
  draw();
})();
