#pragma once
/// Marks what the core library exports. Everything else in it is hidden.
#define PRESHAPE_API __attribute__((visibility("default")))
