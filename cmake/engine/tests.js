// What a test built by tools/engine --tests has of the machine besides its files: its own program, which emscripten would fetch from a
// server where node can, and the parameters of rapidcheck.
Module.wasmBinary = require('fs').readFileSync(__filename.replace(/js$/, 'wasm'));
Module.preRun = () => { ENV.RC_PARAMS = process.env.RC_PARAMS; };
