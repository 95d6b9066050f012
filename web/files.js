// The page's files: chosen, dropped, pasted, saved, and those that were open before.
'use strict';

const aborted = (error) => error?.name === 'AbortError';
const words = (error) => String(error?.message ?? error);

// `kept`: browserStorage's. `tell`: calls the editor's module, `say`: in the person's language (page.js).
function browserFiles(kept, tell, say) {
  const kMostRecents = 8;
  const kLineSide = 1024; // pixels, the longer side of an SVG
  const handles = new Map(); // place → FileSystemFileHandle
  const seen = new Map(); // place → what the file was like when it was read or written here last
  const isDocument = (name) => /\.artisketch$/i.test(name);
  const kinds = {
    artisketch: {description: 'ArtiSketch document', accept: {'application/json': ['.artisketch']}},
    glb: {description: 'glTF model', accept: {'model/gltf-binary': ['.glb']}},
    obj: {description: 'Wavefront model', accept: {'model/obj': ['.obj']}},
    stl: {description: 'STL model', accept: {'model/stl': ['.stl']}},
    ply: {description: 'PLY model', accept: {'model/ply': ['.ply']}},
    png: {description: 'Picture', accept: {'image/png': ['.png']}},
  };
  const images = {description: 'Drawings', accept: {'image/*': [
    '.png', '.jpg', '.jpeg', '.gif', '.webp', '.svg', '.avif', '.bmp']}};

  const described = (kind) => ({...kind, description: say(kind.description)});

  async function placeOf(handle) {
    for (const [place, known] of handles) if (await known.isSameEntry(handle)) return place;
    const place = `file-${crypto.randomUUID()}`;
    handles.set(place, handle);
    return place;
  }

  // A document opened or saved: by its handle where the browser has such, else by a copy.
  async function remember(name, place, handle, bytes) {
    if (!isDocument(name)) return;
    try {
      await list(name, place, handle, bytes);
    } catch {
      // It is missing among the recent ones, no more: it was opened, or saved.
    }
  }

  async function list(name, place, handle, bytes) {
    const all = (await kept.all('recents')).sort((a, b) => b.time - a.time);
    const same = all.find((one) => one.place === place || (!handle && !one.handle && one.name === name));
    const key = place || same?.place || `copy-${crypto.randomUUID()}`;
    await kept.put('recents', key, {place: key, name, time: Date.now(), ...(handle ? {handle} : {bytes})});
    const others = all.filter((one) => one.place !== key);
    for (const old of others.slice(kMostRecents - 1)) await kept.drop('recents', old.place);
  }

  async function recents() {
    const all = (await kept.all('recents')).sort((a, b) => b.time - a.time);
    for (const one of all) if (one.handle) handles.set(one.place, one.handle);
    return all.map((one) => [one.name.replace(/\.artisketch$/i, ''), one.place]);
  }

  async function allowed(handle, mode) {
    if (!handle.queryPermission) return true;
    if (await handle.queryPermission({mode}) === 'granted') return true;
    return await handle.requestPermission({mode}) === 'granted';
  }

  // The editor reads PNG, JPEG and GIF itself; what else the browser shows as an image (WebP, SVG, AVIF…)
  // is drawn once, and handed over as a PNG.
  async function asTheEditorReads(file) {
    if (!/^image\/(?!png|jpeg|gif)/.test(file.type)) return new Uint8Array(await file.arrayBuffer());
    const image = new Image();
    image.src = await new Promise((resolve, reject) => {
      const reader = new FileReader(); // a data: URI, which is all that the page's policy lets in
      reader.onload = () => resolve(reader.result);
      reader.onerror = () => reject(reader.error);
      reader.readAsDataURL(file);
    });
    await image.decode().catch(() => {
      throw new Error(`${file.name} is damaged, or of a kind that this browser doesn't show; save it as a PNG`);
    });
    const {width, height} = sizeOf(image, file.type);
    const drawn = new OffscreenCanvas(width, height);
    drawn.getContext('2d').drawImage(image, 0, 0, width, height);
    return new Uint8Array(await (await drawn.convertToBlob()).arrayBuffer());
  }

  // Lines have no pixels of their own: they get as many as a drawing should have.
  function sizeOf({naturalWidth, naturalHeight}, type) {
    const longest = Math.max(naturalWidth, naturalHeight);
    if (!longest) return {width: kLineSide, height: kLineSide}; // a size that the SVG doesn't tell
    const scale = type === 'image/svg+xml' ? kLineSide / longest : 1;
    const pixels = (side) => Math.max(1, Math.round(side * scale));
    return {width: pixels(naturalWidth), height: pixels(naturalHeight)};
  }

  const likeness = ({lastModified, size}) => `${lastModified} ${size}`;

  // Another tab or program may have saved there since: it is not replaced unasked.
  async function refuseChanged(name, place, handle) {
    const before = seen.get(place);
    const now = before && await handle.getFile().then(likeness, () => before); // gone: nothing to lose
    if (now === before) return;
    seen.delete(place);
    throw new Error(`${name} was saved by another program since it was opened here. Save as keeps both; ` +
      'saving once more replaces it');
  }

  async function deliver(question, files) {
    let fault = '';
    for (const {file, handle} of files) {
      const bytes = await asTheEditorReads(file).catch((error) => void (fault = words(error)));
      if (!bytes) continue; // the others are taken all the same
      const place = handle && isDocument(file.name) ? await placeOf(handle) : '';
      if (place) seen.set(place, likeness(file));
      await remember(file.name, place, handle, bytes);
      tell('page_file', file.name, place, bytes);
    }
    if (files.length) tell('page_opened', question, fault);
  }

  async function chooseFiles(document_) {
    if (window.showOpenFilePicker) {
      try {
        const chosen = await showOpenFilePicker({
          multiple: !document_, types: [described(document_ ? kinds.artisketch : images)]});
        return Promise.all(chosen.map(async (handle) => ({file: await handle.getFile(), handle})));
      } catch (error) {
        if (aborted(error)) return [];
      }
    }
    const input = document.getElementById('files');
    input.accept = document_ ? '.artisketch,.bvh,.glb' : 'image/*';
    input.multiple = !document_;
    input.value = '';
    return new Promise((resolve) => {
      input.onchange = () => resolve([...input.files].map((file) => ({file})));
      input.oncancel = () => resolve([]);
      input.click();
    });
  }

  function download(name, bytes) {
    const link = document.createElement('a');
    link.href = URL.createObjectURL(new Blob([bytes], {type: 'application/octet-stream'}));
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60000);
  }

  async function handleFor(name, place) {
    const known = handles.get(place);
    if (known && await allowed(known, 'readwrite')) return known;
    if (!window.showSaveFilePicker) return null;
    const kind = kinds[name.split('.').pop()];
    try {
      return await showSaveFilePicker({suggestedName: name, ...(kind ? {types: [described(kind)]} : {})});
    } catch (error) {
      if (aborted(error)) throw error;
      return null; // not here (a frame of another site's page), or too long after the click
    }
  }

  async function saveFile(name, place, bytes) {
    const handle = await handleFor(name, place);
    if (!handle) {
      download(name, bytes);
      await remember(name, '', null, bytes);
      return {name, place: ''};
    }
    if (place && handle === handles.get(place)) await refuseChanged(name, place, handle);
    const stream = await handle.createWritable();
    await stream.write(bytes);
    await stream.close();
    const where = await placeOf(handle);
    await handle.getFile().then((file) => seen.set(where, likeness(file)), () => seen.delete(where));
    await remember(handle.name, where, handle, bytes);
    return {name: handle.name, place: where};
  }

  function watchDrops() {
    addEventListener('dragover', (event) => event.preventDefault());
    addEventListener('drop', async (event) => {
      event.preventDefault();
      // Both must be asked for before the event is over.
      const items = [...event.dataTransfer.items].filter((item) => item.kind === 'file').map((item) => ({
        file: item.getAsFile(),
        handle: item.getAsFileSystemHandle?.().catch(() => null),
      }));
      try {
        const files = await Promise.all(items.map(async ({file, handle}) => ({file, handle: await handle})));
        await deliver(0, files.filter(({file}) => file));
      } catch (error) {
        tell('page_opened', 0, words(error));
      }
    });
    addEventListener('paste', async (event) => {
      const files = [...event.clipboardData.files].map((file) => ({file}));
      if (files.length) await deliver(0, files);
      else tell('page_paste', event.clipboardData.getData('text'));
    });
  }

  async function openFiles(question, document_) {
    try {
      await deliver(question, await chooseFiles(document_));
    } catch (error) {
      tell('page_opened', question, words(error));
    }
  }

  async function openRecent(question, place) {
    try {
      const {name, handle, bytes} = await kept.get('recents', place) ?? {};
      if (!name) throw new Error('This document is no longer known here');
      if (handle && !await allowed(handle, 'read')) throw new Error(`No leave to read ${name}`);
      const file = handle ? await handle.getFile() : new File([bytes], name);
      await deliver(question, [{file, handle}]);
    } catch (error) {
      tell('page_opened', question, words(error));
    }
  }

  return {recents, openFiles, openRecent, saveFile, watchDrops};
}
