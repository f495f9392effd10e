"use strict";
// Makes rows of frames, with modules of its own, beside the page.

const modules = {}; // by name: the exports

onmessage = async ({ data: { load, frame } }) => {
  if (load) {
    for (const [name, bytes] of Object.entries(load)) {
      const { instance } = await WebAssembly.instantiate(bytes);
      instance.exports._initialize();
      modules[name] = instance.exports;
    }
    postMessage({ loaded: true });
    return;
  }
  const { module, numbers, first, step } = frame;
  const { memory, numbers_at, show, rows_from } = modules[module];
  const at = numbers_at(numbers.length);
  new Float64Array(memory.buffer, at, numbers.length).set(numbers);
  if (!show()) throw new Error("no figure");
  const [width, height] = [numbers[2], numbers[3]];
  const size = 4 * width * Math.ceil((height - first) / step);
  const place = rows_from(first, step); // making them may move the memory
  const rows = memory.buffer.slice(place, place + size);
  postMessage({ rows }, [rows]);
};
