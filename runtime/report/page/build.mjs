// build.mjs OUT: bundles src/ and three.js into one page. A classic script, since modules do not load from a file.
import { readFileSync, writeFileSync } from 'node:fs';
import { build } from 'esbuild';

const bundle = await build({
  entryPoints: ['src/main.js'],
  bundle: true,
  write: false,
  format: 'iife',
  minify: true,
  target: 'es2022',
  charset: 'ascii',
  legalComments: 'none', // the whole licence stands in the page
});
const script = bundle.outputFiles[0].text.trimEnd().replaceAll('</script', '<\\/script');
const licence = readFileSync('node_modules/three/LICENSE', 'utf8').trimEnd();
const version = JSON.parse(readFileSync('node_modules/three/package.json', 'utf8')).version;
const parts = {
  THREE_LICENCE: `three.js ${version}, https://threejs.org\n\n${licence}`,
  STYLE: readFileSync('src/page.css', 'utf8').trimEnd(),
  SCRIPT: script,
};
let page = readFileSync('src/page.html', 'utf8');
for (const [name, text] of Object.entries(parts))
  page = page.replace(name, () => text);
writeFileSync(process.argv[2], page);
