// `#test`: the page tries itself, counts the pixels that it draws, and writes JSON into the element #test.
const $ = (id) => document.getElementById(id);

// The pixels whose colour is nearest in hue to one of these, and the others by whether they are the background.
function count(page) {
  const { stage } = page;
  stage.draw();
  const gl = stage.renderer.getContext(), w = gl.drawingBufferWidth, h = gl.drawingBufferHeight;
  const pixels = new Uint8Array(4 * w * h);
  gl.readPixels(0, 0, w, h, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  const back = stage.scene.background.getHex(), r0 = back >> 16, g0 = (back >> 8) & 255, b0 = back & 255;
  const out = { all: w * h, back: 0, yellow: 0, vermilion: 0, curve: 0, other: 0 };
  for (let i = 0; i < pixels.length; i += 4) {
    const [r, g, b] = pixels.subarray(i, i + 3), most = Math.max(r, g, b), least = Math.min(r, g, b);
    if (r === r0 && g === g0 && b === b0) ++out.back;
    else if (most - least < 0.5 * most) ++out.other;
    else if (b === most && b - r > 60) ++out.curve;
    else if (r === most && g > 0.68 * r) ++out.yellow;
    else if (r === most) ++out.vermilion;
    else ++out.other;
  }
  out.corner = [...pixels.subarray(0, 3)];
  return out;
}

async function run(page, faults) {
  const { stage } = page, out = { pixels: {} };
  stage.jumps = true;
  const shot = (name) => (out.pixels[name] = count(page));
  shot('whole');
  for (const b of page.bodies.drawn) b.set('solid');
  shot('solid');
  $('clip-on').click();
  shot('clipped');
  $('clip-on').click();
  const dark = page.dark;
  page.setTheme(true);
  shot('dark');
  page.setTheme(false);
  shot('light');
  page.setTheme(dark);
  const rows = document.querySelectorAll('.row');
  out.rows = { shown: rows.length, all: page.list.rows.length };
  if (rows.length) {
    const before = stage.view().join();
    rows[Math.min(2, rows.length - 1)].click();
    out.chosen = { text: document.querySelector('.row.chosen').textContent, selected: $('selected').textContent };
    out.chosen.moved = stage.view().join() !== before;
    shot('near');
    $('wire').click();
    shot('wireframe');
    $('wire').click();
    const view = (out.view = page.now());
    $('fit').click();
    page.show(view);
    out.view_returns = page.now() === view;
    page.list.step(1);
    out.next = document.querySelector('.row.chosen').textContent;
    page.list.root.scrollTop = page.list.root.scrollHeight;
    page.list.draw();
    out.last = [...document.querySelectorAll('.row')].at(-1).textContent;
  }
  if (page.report.frames.length > 1) {
    stage.fit();
    page.setFrame(page.report.frames.length - 1);
    shot('last_frame');
    out.frame = $('frame-name').textContent;
  }
  // A page at rest draws nothing.
  do await new Promise((done) => setTimeout(done, 300));
  while (stage.wanted !== undefined);
  const frames = stage.frames;
  await new Promise((done) => setTimeout(done, 500));
  out.frames_at_rest = stage.frames - frames;
  out.facts = [...document.querySelectorAll('#facts dd')].map((e) => e.textContent);
  out.title = document.title;
  out.count = $('count').textContent;
  out.contacts = Object.fromEntries(Object.entries(page.report.contacts).map(([k, v]) => [k, v.length]));
  out.faults = faults;
  return out;
}

export async function runTest(page, faults) {
  let out;
  try {
    out = await run(page, faults);
  } catch (e) {
    out = { faults: [...faults, e.stack] };
  }
  const text = document.createElement('pre');
  text.id = 'test';
  text.hidden = true;
  text.textContent = JSON.stringify(out);
  document.body.append(text);
}
