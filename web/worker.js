// The worker: begins the core's module, which the page compiled, and does one job per message.
// Messages in: {compiled: WebAssembly.Module}, {request: Uint8Array}, {rehearse: Uint8Array}.
// Messages out: {progress: Uint8Array}, {outcome: Uint8Array}, {died: {why, ofMemory}}; {rehearsed: true}.
'use strict';

let core = null; // a promise

function died(error) {
  const why = String(error?.message ?? error);
  postMessage({died: {why, ofMemory: /memory|allocation failed/i.test(why)}});
}

function begin(compiled) {
  return createCore({
    instantiateWasm(imports, done) {
      WebAssembly.instantiate(compiled, imports).then(done, died);
      return {};
    },
    send(kind, bytes) {
      postMessage({[kind]: bytes}, [bytes.buffer]);
    },
  });
}

// Calls the core's function with the bytes as a pointer and a size.
async function give(name, bytes) {
  const module = await core;
  const at = module._malloc(bytes.length);
  if (!at) throw new Error('out of memory');
  module.HEAPU8.set(bytes, at);
  module[name](at, bytes.length);
  module._free(at);
}

onmessage = async ({data}) => {
  try {
    if (data.compiled) core = begin(data.compiled);
    if (data.request) await give('_serve', data.request);
    if (data.rehearse) {
      await give('_rehearse', data.rehearse);
      postMessage({rehearsed: true});
    }
  } catch (error) {
    died(error);
  }
};
