// What the browser may call.
#pragma once

#ifdef __wasm__
#define FOS_EXPORT(name) extern "C" __attribute__((export_name(#name)))
#else
#define FOS_EXPORT(name) extern "C"
#endif
