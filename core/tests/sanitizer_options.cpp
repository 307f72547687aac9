// SPDX-License-Identifier: MIT
// Read by the leak sanitizer; nothing calls it elsewhere. VTK 9.1 leaks an array of a .vtp file that it rejects.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libvtkCommonCore\n"; }
