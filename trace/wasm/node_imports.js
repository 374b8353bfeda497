// The names that the program for Node imports from trace/package/node/vidno.mjs, so that the linker misses only what is really missing.
const names = ['sha256', 'packed', 'unpacked', 'packing_take'];
mergeInto(LibraryManager.library, Object.fromEntries(names.map((name) => [name, function () {}])));
