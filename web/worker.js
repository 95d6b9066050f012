// The worker: begins the core's module, which the page compiled, and does one job per message.
// Messages in: {compiled: WebAssembly.Module}, {request: Uint8Array}.
// Messages out: {progress: Uint8Array}, {outcome: Uint8Array}, {died: {why, ofMemory}}.
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

onmessage = async ({data}) => {
  try {
    if (data.compiled) core = begin(data.compiled);
    if (!data.request) return;
    const module = await core;
    const at = module._malloc(data.request.length);
    if (!at) throw new Error('out of memory');
    module.HEAPU8.set(data.request, at);
    module._serve(at, data.request.length);
    module._free(at);
  } catch (error) {
    died(error);
  }
};
