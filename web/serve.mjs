// A plain static server on localhost, with no special header.
//   node serve.mjs FOLDER [PORT]
import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { extname, join, normalize, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

const types = {
  '.html': 'text/html; charset=utf-8', '.js': 'text/javascript; charset=utf-8', '.css': 'text/css; charset=utf-8',
  '.wasm': 'application/wasm', '.glb': 'model/gltf-binary', '.artisketch': 'application/json',
};

// Resolves to {url, close} once it listens; port 0 takes a free one.
export function serve(folder, port = 0) {
  const server = createServer(async (request, response) => {
    try {
      const path = normalize(decodeURIComponent(new URL(request.url, 'http://x').pathname));
      const file = join(folder, path.endsWith('/') ? `${path}index.html` : path);
      const bytes = await readFile(file);
      response.writeHead(200, {
        'Content-Type': types[extname(file)] ?? 'application/octet-stream', 'Cache-Control': 'no-cache',
      });
      response.end(bytes);
    } catch {
      response.writeHead(404, {'Content-Type': 'text/plain'});
      response.end('There is no such file.');
    }
  });
  return new Promise((done, failed) => {
    server.on('error', failed);
    server.listen(port, '127.0.0.1', () => done({
      url: `http://localhost:${server.address().port}/`,
      close: () => { server.closeAllConnections(); server.close(); },
    }));
  });
}

if (process.argv[1] && resolve(process.argv[1]) === fileURLToPath(import.meta.url)) {
  const [folder, port = '8000'] = process.argv.slice(2);
  serve(folder, Number(port)).then(
    ({url}) => console.log(`${url}  (Ctrl-C ends it)`),
    (error) => { console.error(error.message); process.exit(1); });
}
