// The worker that does the editor's slow jobs, one at a time, in a second module: the core.
'use strict';

const kIdle = 1000; // milliseconds without a job before the rehearsal

// `module`, `script`, `example` give promises: of the core, compiled, of where worker.js stands, of a
// document's bytes. `tell`: calls the editor's module (page.js).
function coreWorker({module, script, example, tell}) {
  let parts = null; // a promise of [the compiled core, the place of worker.js]
  let worker = null;

  function loaded() {
    parts ??= Promise.all([module(), script()]);
    parts.catch(() => { parts = null; }); // tried again from the start with the next job
    return parts;
  }

  function thread([core, url]) {
    const made = new Worker(url);
    made.postMessage({compiled: core});
    return made;
  }

  function begin() {
    const begun = {ended: false, thread: null, waiting: []};
    worker = begun;
    const died = (ofMemory, why) => {
      if (worker === begun) tell('page_died', ofMemory, why);
    };
    loaded().then((found) => {
      if (begun.ended) return;
      begun.thread = thread(found);
      begun.thread.onerror = (event) => died(false, event.message || 'the worker could not be loaded');
      begun.thread.onmessage = ({data}) => {
        if (worker !== begun) return;
        if (data.progress) tell('page_progress', data.progress);
        if (data.outcome) {
          tell('page_outcome', data.outcome);
          rehearseSoon();
        }
        if (data.died) died(data.died.ofMemory, data.died.why);
      };
      begun.waiting.forEach((request) => begun.thread.postMessage({request}));
    }).catch((error) => {
      begun.failed = words(error);
      if (begun.waiting.length) died(false, begun.failed);
    });
  }

  function post(request) {
    endRehearsal(); // the machine is the job's
    if (!worker || worker.failed) begin();
    if (worker.thread) worker.thread.postMessage({request});
    else worker.waiting.push(request);
  }

  function restart() {
    if (worker) {
      worker.ended = true;
      worker.thread?.terminate();
    }
    worker = null;
    // Not at once: a worker that cannot begin must not begin for ever.
    setTimeout(ready, 100);
  }

  // Begins it ahead of the first job.
  function ready() {
    if (!worker) begin();
    rehearseSoon();
  }

  // Browsers compile WebAssembly quickly first, and well what runs often; that code belongs to the compiled
  // module, whichever worker runs it. So a second worker makes a model of an example, for nothing, while
  // there is nothing else to do, and the first model that is wanted is made at the speed of later ones.
  let rehearsed = false;
  let rehearsal = null; // the second worker
  let due = 0; // the timer

  function rehearseSoon() {
    clearTimeout(due);
    if (!rehearsed) due = setTimeout(rehearse, kIdle);
  }

  async function rehearse() {
    const mine = due;
    try {
      const [found, bytes] = await Promise.all([loaded(), example()]);
      if (mine !== due) return; // a job came first
      rehearsal = thread(found);
      rehearsal.onerror = () => endRehearsal();
      rehearsal.onmessage = ({data}) => {
        rehearsed = Boolean(data.rehearsed);
        if (!data.progress) endRehearsal();
      };
      rehearsal.postMessage({rehearse: bytes});
    } catch {
      // The first job tells what is wrong.
    }
  }

  function endRehearsal() {
    clearTimeout(due);
    due = 0;
    rehearsal?.terminate();
    rehearsal = null;
  }

  return {post, restart, ready};
}
